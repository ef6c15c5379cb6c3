// Painleve's rod: a rod that slides on its tip, leaning back against the way it goes, as a piece of chalk that is pushed.
// Above a friction of 4/3 rigid-body mechanics has states without a solution; a time step always has one and must find it.
#include <algorithm>

#include "accuracy/cases/friction/sliding.h"

namespace tumble::accuracy {

namespace {

constexpr double kLength = 2, kThick = 0.02, kSpeed = 5, kSeconds = 5;
constexpr Vec3 kSize{kLength, kThick, kThick};
constexpr double kEnergy = 0.01, kStill = 0.05, kSink = 0.005;  // of the start; m/s of the fastest corner; m of where it lies

// The tip is at the origin, the centre behind it.
void slide_on_tip(Trial& trial, double friction, double angle, Outcome& outcome) {
  Simulation& scene = trial.scene();
  add_floor(scene);
  BodyDef def = with(dynamic(box(kSize), 1), friction);
  def.velocity = {-kSpeed, 0, 0};
  const double height = (kLength * std::sin(angle) + kThick * std::cos(angle)) / 2;
  const BodyIndex body = scene.add(def, {{kLength / 2 * std::cos(angle), height, 0}, axis_angle({0, 0, 1}, angle)});
  const double start = energy(scene, body), spare = trial.reference(start) * (1 + kEnergy) - start;

  double least = start, gain = 0, speed = 0;
  run(scene, kSeconds, kFrame, [&](double t) {
    const double now = energy(scene, body);
    least = std::min(least, now);
    gain = std::max(gain, now - least);
    if (t > kSeconds - 0.25) speed = std::max(speed, fastest_corner(scene, body, kSize));
    return std::isfinite(now);
  });
  if (!finite(scene, body)) outcome.failed = "not finite from " + std::to_string(static_cast<int>(std::lround(degrees(angle)))) + " degrees";
  outcome.energy_drift = std::max(outcome.energy_drift.value_or(0), gain / start);
  const double fall = height - scene.pose(body).position.y, sunk = std::abs(fall - trial.reference(height - kThick / 2));
  outcome.error = std::max({outcome.error, gain / spare, speed / kStill, sunk / kSink});
}

Outcome from_all_angles(Trial& trial, double friction) {
  Outcome outcome;
  for (int angle = 45; angle <= 75; angle += trial.effort() == Effort::test ? 15 : 5) slide_on_tip(trial, friction, radians(angle), outcome);
  return outcome;
}

}  // namespace

Case b27_painleve_rod() {
  Case c{"B27", "Painleve's rod", "a rod of 2 m slides at 5 m/s on its tip, leaning back at 45 to 75 degrees to the floor", "finite, energy never rises, at rest after 5 s",
         "the worst of energy regained over 1 % and speed at the end over 0.05 m/s, height over 5 mm, of all angles", {}};
  c.parts = {{"friction 1.2", 1, [](Trial& t) { return from_all_angles(t, 1.2); }},
             {"friction 1.5", 1, [](Trial& t) { return from_all_angles(t, 1.5); }},
             {"friction 2", 1, [](Trial& t) { return from_all_angles(t, 2); }}};
  return c;
}

}  // namespace tumble::accuracy
