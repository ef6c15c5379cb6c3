// A heavy top started on its steady precession: it must go round at the slow root of the top's equation without nodding.
// A joint solved loosely, a gyroscopic term that damps or a silent clamp of the spin all show.
#include <algorithm>

#include "accuracy/cases/motion/rotation.h"

namespace tumble::accuracy {

namespace {

constexpr double kRadius = 0.5, kThickness = 0.05, kArm = 0.5;  // m; 1 kg
constexpr double kTilt = radians(20);
constexpr double kAlong = kRadius * kRadius / 2;
constexpr double kAcross = kRadius * kRadius / 4 + kThickness * kThickness / 12 + kArm * kArm;  // about the foot

// The slow root of I1 cos(tilt) W^2 - I3 spin W + m g d = 0.
double steady_precession(double spin) {
  const double a = kAcross * std::cos(kTilt), b = kAlong * spin;
  return (b - std::sqrt(b * b - 4 * a * kGravity * kArm)) / (2 * a);
}

struct Top {
  double precession = 0, tilt = kTilt;  // rad/s, mean; rad, the one furthest from the first
  double turned = 0, reported = 0;      // rad
};

Top spun(Trial& trial, double spin) {
  const double seconds = trial.shortened(10, trial.effort() == Effort::test ? 2 : 10);
  const Vec3 axis{std::sin(kTilt), std::cos(kTilt), 0};
  BodyDef def = dynamic(upright(ShapeKind::cylinder, kRadius, kThickness), 1);
  def.angular_velocity = axis * spin + (Vec3{0, 1, 0} - axis * std::cos(kTilt)) * steady_precession(spin);
  def.velocity = cross(def.angular_velocity, axis * kArm);
  Simulation& scene = trial.scene();
  const BodyIndex body = scene.add(def, {axis * kArm, axis_angle({0, 0, 1}, -kTilt)});
  scene.add(joint(body, kWorld, {0, -kArm, 0}, BallDef{}));

  Top top;
  TurnWatch watch(scene, body);
  double azimuth = 0;
  run(scene, seconds, kFrame, [&](double) {
    watch.after_step(kFrame);
    const Vec3 now = normalized(center(scene, body));
    const double next = std::atan2(-now.z, now.x), tilt = std::acos(std::clamp(now.y, -1.0, 1.0));
    top.precession += within_half_turn(next - azimuth) / seconds;
    if (std::abs(tilt - kTilt) > std::abs(top.tilt - kTilt)) top.tilt = tilt;
    azimuth = next;
    return true;
  });
  top.turned = watch.turned();
  top.reported = watch.reported();
  return top;
}

Outcome precession(Trial& trial, double spin) {
  const Top top = spun(trial, spin);
  Outcome outcome;
  outcome.error = std::max(relative(top.precession, trial.reference(steady_precession(spin))), relative(top.tilt, trial.reference(kTilt)));
  return outcome;
}

Outcome turned(Trial& trial, double spin) {
  const Top top = spun(trial, spin);
  Outcome outcome;
  outcome.error = relative(top.turned, trial.reference(top.reported));
  return outcome;
}

}  // namespace

Case a11_heavy_top() {
  Case c{"A11", "Heavy top", "a disc of radius 0.5 m and 1 kg, its centre 0.5 m from a ball joint, tilted by 20 degrees, for 10 s",
         "F: the slow root of I1 cos(tilt) W^2 - I3 spin W + m g d = 0", "the worse of precession and tilt, over the true one; angle turned over angle reported", {}};
  for (const int spin : {50, 100, 200}) c.parts.push_back({"spin " + std::to_string(spin), 1e-2, [spin](Trial& t) { return precession(t, spin); }});
  for (const int spin : {50, 100, 200}) c.parts.push_back({"spin " + std::to_string(spin) + ", turned", 1e-2, [spin](Trial& t) { return turned(t, spin); }});
  return c;
}

}  // namespace tumble::accuracy
