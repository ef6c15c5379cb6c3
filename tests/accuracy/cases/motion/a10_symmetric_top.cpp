// A free disc that wobbles: its axis circles the angular momentum at L / I1, its spin circles its axis at a rate of its
// own, and the angle between axis and momentum stays. All three are known exactly.
#include <algorithm>

#include "accuracy/cases/motion/rotation.h"

namespace tumble::accuracy {

namespace {

constexpr double kRadius = 0.5, kHeight = 0.2;
constexpr double kAlong = kRadius * kRadius / 2, kAcross = kRadius * kRadius / 4 + kHeight * kHeight / 12;  // of 1 kg
constexpr double kSpin = 20, kWobble = 2;  // rad/s, about the axis and across it
constexpr double kFrame240 = 1.0 / 240;

struct Wobble {
  double precession = 0, body_rate = 0;  // rad/s, mean
  double cone = 0;                       // rad, the one that is furthest from the first
};

// The angle from a to b about an axis.
double angle_about(Vec3 axis, Vec3 a, Vec3 b) { return std::atan2(dot(axis, cross(a, b)), dot(a, b) - dot(axis, a) * dot(axis, b)); }

Wobble measured(Trial& trial) {
  const double seconds = trial.shortened(20, trial.effort() == Effort::test ? 4 : 20);
  Simulation& scene = trial.scene({{0, 0, 0}});
  BodyDef def = dynamic(upright(ShapeKind::cylinder, kRadius, kHeight), 1);
  def.angular_velocity = {kWobble, kSpin, 0};
  const BodyIndex body = scene.add(def, {});
  const Vec3 momentum = normalized(Vec3{kAcross * kWobble, kAlong * kSpin, 0});
  const double cone = std::atan2(kAcross * kWobble, kAlong * kSpin);

  Wobble out;
  out.cone = cone;
  Vec3 axis{0, 1, 0}, spin = def.angular_velocity;  // the axis in the world, the spin in the body
  run(scene, seconds, kFrame240, [&](double) {
    const Quat rotation = scene.pose(body).rotation;
    const Vec3 next_axis = rotation * Vec3{0, 1, 0}, next_spin = conjugate(rotation) * scene.angular_velocity(body);
    out.precession += angle_about(momentum, axis, next_axis) / seconds;
    out.body_rate += std::abs(angle_about({0, 1, 0}, spin, next_spin)) / seconds;
    const double angle = std::atan2(length(cross(momentum, next_axis)), dot(momentum, next_axis));
    if (std::abs(angle - cone) > std::abs(out.cone - cone)) out.cone = angle;
    axis = next_axis;
    spin = next_spin;
    return true;
  });
  return out;
}

Outcome compared(double value, double truth) {
  Outcome outcome;
  outcome.error = relative(value, truth);
  return outcome;
}

}  // namespace

Case a10_symmetric_top() {
  Case c{"A10", "Free symmetric body", "a free cylinder of radius 0.5 m, 0.2 m high spins at 20 rad/s about its axis and 2 across, for 20 s at 240 Hz",
         "F: precession L / I1, body rate (I3 - I1) / I1 spin, cone angle atan(I1 2 / I3 20)", "|rate - true| / true, |angle - true| / true", {}};
  c.parts = {{"precession", 1e-4, [](Trial& t) { return compared(measured(t).precession, t.reference(std::hypot(kAlong * kSpin, kAcross * kWobble) / kAcross)); }},
             {"body rate", 1e-4, [](Trial& t) { return compared(measured(t).body_rate, t.reference((kAlong - kAcross) / kAcross * kSpin)); }},
             {"cone angle", 1e-4, [](Trial& t) { return compared(measured(t).cone, t.reference(std::atan2(kAcross * kWobble, kAlong * kSpin))); }}};
  return c;
}

}  // namespace tumble::accuracy
