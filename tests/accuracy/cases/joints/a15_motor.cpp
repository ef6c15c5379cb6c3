// Motors: a limit in newton metres must mean the same at any step, and what a motor holds must be read back truly.
#include "accuracy/cases/joints/mechanisms.h"

namespace tumble::accuracy {

namespace {

const SceneSettings kWeightless{{0, 0, 0}, false};
constexpr double kStrength = 6;  // N m on 1 kg m^2, N on 2 kg

// A cube of 1 kg m^2 on a hinge, or of 2 kg on a slider, along y, with a motor.
struct Driven {
  Simulation& scene;
  BodyIndex body;
  bool turns;
  double speed() const { return turns ? scene.angular_velocity(body).y : scene.velocity(body).y; }
};
Driven build(Simulation& scene, bool turns, double speed) {
  const BodyIndex body = scene.add(dynamic(box({1, 1, 1}), turns ? 6 : 2), {});
  HingeDef hinge;
  hinge.angle.motor.emplace();
  hinge.angle.motor->speed = speed;
  hinge.angle.motor->strength = kStrength;
  SliderDef slider;
  slider.position.motor.emplace();
  slider.position.motor->speed = speed;
  slider.position.motor->strength = kStrength;
  scene.add(joint(body, kWorld, {}, turns ? JointKind{hinge} : JointKind{slider}));
  return {scene, body, turns};
}

// Towards a speed that is out of reach.
Outcome pull(Trial& trial, bool turns, double frame) {
  const Driven driven = build(trial.scene(kWeightless), turns, 1000);
  run(driven.scene, 1, frame);
  Outcome outcome;
  outcome.error = relative(driven.speed(), trial.reference(turns ? kStrength : kStrength / 2));
  return outcome;
}

// To 10 rad/s, which it has after 10 / 6 s, one step left out; never above.
Outcome settle(Trial& trial) {
  const Driven driven = build(trial.scene(kWeightless), true, 10);
  Outcome outcome;
  run(driven.scene, 3, kFrame, [&](double time) {
    const double there = 10 / kStrength, wanted = std::min(10.0, kStrength * time);
    if (time <= there || time > there + kFrame) outcome.error = std::max(outcome.error, relative(driven.speed(), trial.reference(wanted), 10));
    return true;
  });
  return outcome;
}

// A load of 8 N m against the 6 of the motor.
Outcome overload(Trial& trial) {
  const Driven driven = build(trial.scene(kWeightless), true, 10);
  run(driven.scene, 2);
  const double before = driven.speed();
  for (int i = 0; i < 60; ++i) {
    driven.scene.apply_torque(driven.body, {0, -8, 0});
    driven.scene.step(kFrame);
  }
  Outcome outcome;
  outcome.error = relative(driven.speed() - before, trial.reference(kStrength - 8));
  return outcome;
}

// A servo holds a rod at 30 degrees above the horizontal.
Outcome hold(Trial& trial, bool torque) {
  constexpr double angle = kPi / 6;
  Simulation& scene = trial.scene();
  const Vec3 along{std::cos(angle), std::sin(angle), 0};
  const BodyIndex body = scene.add(rod(), {along * 0.5, between({1, 0, 0}, along)});
  HingeDef kind;
  kind.angle.motor.emplace();
  kind.angle.motor->target = 0;
  kind.angle.motor->strength = 100;
  const JointIndex hinge = scene.add(joint(body, kWorld, {-0.5, 0, 0}, kind, {0, 0, 1}));
  run(scene, 2);
  const Vec3 at = center(scene, body);
  Outcome outcome;
  if (torque) outcome.error = relative(scene.joint_state(hinge).torque.z, trial.reference(kGravity * 0.5 * std::cos(angle)));
  else outcome.error = relative(std::atan2(at.y, at.x), trial.reference(angle), 1);
  return outcome;
}

}  // namespace

Case a15_motor() {
  Case c{"A15", "Motors", "a cube of 1 kg m^2 on a hinge, or of 2 kg on a slider, and a motor of 6 N m or 6 N; a servo holds a rod at 30 degrees",
         "F: torque t / I up to the speed, torque - load beyond; m g L cos(angle)", "relative error of speed, change of speed, torque; error of the angle, rad", {}};
  for (const int rate : {30, 60, 240})
    c.parts.push_back({"torque limit " + std::to_string(rate) + " Hz", 1e-4, [rate](Trial& t) { return pull(t, true, 1.0 / rate); }});
  for (const int rate : {60, 240})
    c.parts.push_back({"force limit " + std::to_string(rate) + " Hz", 1e-4, [rate](Trial& t) { return pull(t, false, 1.0 / rate); }});
  c.parts.push_back({"settles", 1e-4, settle});
  c.parts.push_back({"overload", 1e-4, overload});
  c.parts.push_back({"servo torque", 1e-4, [](Trial& t) { return hold(t, true); }});
  c.parts.push_back({"servo angle", 1e-4, [](Trial& t) { return hold(t, false); }});
  return c;
}

}  // namespace tumble::accuracy
