#include "render/air.h"

#include <algorithm>

#include "render/batches.h"

namespace tumble {
namespace {

constexpr double kHaze = 2.2e-6;      // half of what is 670 m away
constexpr double kFogHeight = 0.2;    // sine; about 12 degrees

// What comes from all around is less colourful than what it comes from, and less than what comes straight.
constexpr double kColourful = 0.5;
constexpr double kFromAbove = 0.86, kFromBelow = 0.58;
constexpr double kBounced = 0.2;      // of the sun, off the ground

Vec3 light_of(const Color& color) {
  const std::array<float, 4> light = linear(color);
  return {light[0], light[1], light[2]};
}

Vec3 faded(Vec3 light) {
  const double grey = dot(light, {0.2126, 0.7152, 0.0722});
  return Vec3{grey, grey, grey} * (1 - kColourful) + light * kColourful;
}

}  // namespace

Air air_of(const DrawList& list) {
  Air air;
  const double sky = list.sky_brightness * list.exposure;
  air.sky_top = light_of(list.sky_top) * sky;
  air.sky_horizon = light_of(list.sky_horizon) * sky;
  air.ground = light_of(list.ground) * sky;
  air.to_sun = -normalized(list.sun_direction);
  air.sun = list.has_sun ? light_of(list.sun_color) * (list.sun_brightness * list.exposure) : Vec3{};
  air.above = faded((air.sky_horizon + air.sky_top) / 2) * kFromAbove;
  air.below = faded(air.ground) * kFromBelow +
              scaled(light_of(list.ground), air.sun) * (kBounced * std::max(air.to_sun.y, 0.0));
  air.has_fog = list.fog_end > 0;
  air.haze = air.has_fog ? 0 : kHaze;
  if (air.has_fog) {
    air.fog = {list.fog_start, 1 / std::max(list.fog_end - list.fog_start, 1e-3), list.fog_color ? 0.0 : 1.0};
    air.fog_color = list.fog_color ? light_of(*list.fog_color) * list.exposure : air.sky_horizon;
    air.fog_height = list.fog_color ? kFogHeight : 0;
  }
  return air;
}

double fog_share(double distance, double fog_start, double fog_end) {
  if (fog_end <= 0) return 0;
  const double depth = std::clamp((distance - fog_start) / (fog_end - fog_start), 0.0, 1.0);
  return depth * depth * (3 - 2 * depth);
}

}  // namespace tumble
