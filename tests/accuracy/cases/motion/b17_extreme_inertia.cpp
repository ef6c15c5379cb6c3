// Bodies whose moments of inertia are far apart, spun and dropped: the thin axis is where a step in explicit form blows
// up. They must come to rest and never turn faster than they were spun once they lie.
#include <algorithm>

#include "accuracy/scenes.h"

namespace tumble::accuracy {

namespace {

constexpr double kSpin = 20;             // rad/s, about the body's y
constexpr double kSeconds = 10;
constexpr double kLanded = 2;            // s; from then on nothing feeds the spin
constexpr double kStill = 0.05;          // m/s, of the fastest point through the last half second: at rest
constexpr double kEnergy = 0.01;
constexpr double kHeight = 0.005;        // m, of where it rests

// Two equal parts at +-1 m on x.
BodyDef pair_of(const Shape& shape) {
  BodyDef body = dynamic(shape, 2);
  body.colliders.push_back(body.colliders.front());
  body.colliders[0].offset = {-1, 0, 0};
  body.colliders[1].offset = {1, 0, 0};
  return body;
}

Outcome drop(Trial& trial, BodyDef body_def, Vec3 size, double tilt) {
  Simulation& scene = trial.scene();
  add_floor(scene, 60);
  const Quat rotation = axis_angle({0, 0, 1}, tilt);
  body_def.friction = 0.5;
  body_def.angular_velocity = rotation * Vec3{0, kSpin, 0};
  const BodyIndex body = scene.add(body_def, {{0, 1, 0}, rotation});
  const double start = energy(scene, body), allowed = trial.reference(start) * (1 + kEnergy) - start;

  Outcome outcome;
  double gain = -start, speed = 0, spin = 0;
  run(scene, kSeconds, kFrame, [&](double t) {
    if (!finite(scene, body)) outcome.failed = "not finite at " + std::to_string(t) + " s";
    gain = std::max(gain, energy(scene, body) - start);
    if (t > kLanded) spin = std::max(spin, length(scene.angular_velocity(body)));
    if (t > kSeconds - 0.5) speed = std::max(speed, fastest_corner(scene, body, size));
    return outcome.failed.empty();
  });
  outcome.energy_drift = gain / start;
  const double fall = 1 - scene.pose(body).position.y, sunk = std::abs(fall - trial.reference(1 - size.y / 2));
  outcome.error = std::max({gain / allowed, speed / kStill, spin / kSpin, sunk / kHeight});
  if (scene.pose(body).position.y < -0.5) outcome.failed = "went through the floor";
  return outcome;
}

}  // namespace

Case b17_extreme_inertia() {
  Case c{"B17", "Extreme inertia", "thin bodies fall 1 m, spun at 20 rad/s about the upright axis, friction 0.5; all but the dumbbell 5 degrees askew",
         "at rest after 10 s, no energy gained", "the worst of the fastest point at the end over 0.05 m/s, energy gained over 1 %, spin after landing over 20 rad/s, height over 5 mm", {}};
  const double askew = radians(5);
  constexpr Vec3 needle{2, 0.005, 0.005}, plate{4, 0.01, 4};
  // A dumbbell that lands askew may end rolling, which nothing stops: it falls level.
  c.parts = {{"dumbbell 1:1001", 1, [](Trial& t) { return drop(t, pair_of(ball(0.05)), {2, 0.1, 0.1}, 0); }},
             {"needle", 1, [=](Trial& t) { return drop(t, dynamic(box(needle), 0.5), needle, askew); }},
             {"plate", 1, [=](Trial& t) { return drop(t, dynamic(box(plate), 10), plate, askew); }},
             {"compound 1:10000", 1, [=](Trial& t) { return drop(t, pair_of(box({0.0245, 0.0245, 0.0245})), {2, 0.0245, 0.0245}, askew); }}};
  return c;
}

}  // namespace tumble::accuracy
