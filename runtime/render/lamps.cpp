#include "render/lamps.h"

#include <algorithm>
#include <cmath>

#include "render/batches.h"

namespace tumble {
namespace {

constexpr double kSoftRim = 0.25;  // of a spot's half angle

// How much light a lamp brings, and how near it is: the usual measure of what may be left out.
double importance(const DrawLight& light) {
  const auto& p = light.position;
  const double squared = double{p[0]} * p[0] + double{p[1]} * p[1] + double{p[2]} * p[2];
  return light.brightness * light.range * light.range / std::max(squared, 1.0);
}

bool matters(const DrawLight& light, const Frustum& frustum) {
  if (!(light.brightness > 0 && light.range > 0)) return false;
  return frustum.may_see({light.position[0], light.position[1], light.position[2], light.range});
}

void add(Lamps& lamps, const DrawLight& light, double exposure) {
  const std::array<float, 4> color = linear(light.color);
  // A point light is a spot without an end: every cosine lies above its rim.
  float end = -2, rim = 1;
  if (light.spot) {
    const double half = std::min(light.angle / 2.0, kPi - 1e-3), inner = half * (1 - kSoftRim);
    end = static_cast<float>(std::cos(half));
    rim = static_cast<float>(1 / std::max(std::cos(inner) - std::cos(half), 1e-4));
  }
  const auto& [x, y, z] = light.position;
  lamps.place.push_back({x, y, z, 1 / light.range});
  const float strength = light.brightness * static_cast<float>(exposure);
  lamps.light.push_back({color[0] * strength, color[1] * strength, color[2] * strength, rim});
  const std::array<float, 3> axis = light.spot ? light.direction : std::array<float, 3>{};
  lamps.axis.push_back({axis[0], axis[1], axis[2], end});
}

}  // namespace

double lamp_share(double distance, double range) {
  const double share = distance * distance / (range * range);
  const double window = std::clamp(1 - share * share, 0.0, 1.0);
  return window * window / (16 * share + 0.0625);
}

Lamps choose_lamps(const DrawList& list, const Frustum& frustum, std::size_t most) {
  std::vector<const DrawLight*> chosen;
  for (const DrawLight& light : list.lights)
    if (matters(light, frustum)) chosen.push_back(&light);
  std::stable_sort(chosen.begin(), chosen.end(),
                   [](const DrawLight* a, const DrawLight* b) { return importance(*a) > importance(*b); });
  if (chosen.size() > most) chosen.resize(most);
  Lamps lamps;
  for (const DrawLight* light : chosen) add(lamps, *light, list.exposure);
  return lamps;
}

}  // namespace tumble
