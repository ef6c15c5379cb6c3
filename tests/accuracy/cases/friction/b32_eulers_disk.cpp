// Euler's disk: a coin and a large disc, tilted and spun on a floor, roll on their rim until they lie. Without air the
// exact disc has no law for its end, so this asks only for a sound one: it settles, sinks steadily and gains nothing.
#include <algorithm>

#include "accuracy/cases/friction/sliding.h"

namespace tumble::accuracy {

namespace {

constexpr double kTilt = radians(20), kSpin = 20;  // to the floor; rad/s about the upright
constexpr double kSeconds = 60, kSettled = 0.1;    // s, rad/s
constexpr double kEnergy = 0.01, kRise = 0.01;     // of the start; rad between means of a second
constexpr double kSink = 0.02;                     // of its thickness

Outcome settle(Trial& trial, double radius, double height, double mass) {
  Simulation& scene = trial.scene();
  add_floor(scene);
  BodyDef def = with(dynamic(upright(ShapeKind::cylinder, radius, height), mass), 0.5);
  def.angular_velocity = {0, kSpin, 0};
  const double center = radius * std::sin(kTilt) + height / 2 * std::cos(kTilt);
  const BodyIndex body = scene.add(def, {{0, center, 0}, axis_angle({0, 0, 1}, kTilt)});
  const double start = energy(scene, body), spare = trial.reference(start) * (1 + kEnergy) - start;

  Outcome outcome;
  double gain = -start, rise = 0, mean = kTilt, sum = 0, deepest = 0;
  int samples = 0;
  run(scene, trial.shortened(kSeconds, trial.effort() == Effort::test ? 10 : 60), kFrame, [&](double) {
    gain = std::max(gain, energy(scene, body) - start);
    const double cosine = std::min(1.0, std::abs((scene.pose(body).rotation * Vec3{0, 1, 0}).y)), sine = std::sqrt(1 - cosine * cosine);
    deepest = std::max(deepest, radius * sine + height / 2 * cosine - scene.pose(body).position.y);
    sum += std::acos(cosine);
    if (++samples == 60) {
      rise = std::max(rise, sum / samples - mean);
      mean = sum / samples;
      sum = samples = 0;
    }
    return finite(scene, body);
  });
  outcome.energy_drift = gain / start;
  outcome.max_penetration = deepest;
  const double fall = center - scene.pose(body).position.y, sunk = std::abs(fall - trial.reference(center - height / 2));
  outcome.error = std::max({gain / spare, rise / kRise, length(scene.angular_velocity(body)) / kSettled, sunk / (kSink * height)});
  if (!finite(scene, body)) outcome.failed = "not finite";
  else if (scene.pose(body).position.y < 0) outcome.failed = "fell through the floor";
  return outcome;
}

}  // namespace

Case b32_eulers_disk() {
  Case c{"B32", "Euler's disk", "a coin of radius 0.04 m, 2 mm thick, and a disc of 1 m, tilted by 20 degrees to the floor and spun at 20 rad/s, friction 0.5, 60 s",
         "lies in the end, its tilt sinks from second to second, no energy gained", "the worst of spin at the end over 0.1 rad/s, tilt regained over 0.01 rad, energy gained over 1 %, height over 2 % of its thickness", {}};
  c.parts = {{"coin", 1, [](Trial& t) { return settle(t, 0.04, 0.002, 0.01); }}, {"disc of 1 m", 1, [](Trial& t) { return settle(t, 0.5, 0.05, 10); }}};
  return c;
}

}  // namespace tumble::accuracy
