// Motors that cannot have their way: driven into a limit, against a wall with a box between, against each other. They
// must not creep past what stops them, nor store up what would shoot out when they turn round.
#include "accuracy/cases/joints/mechanisms.h"

namespace tumble::accuracy {

namespace {

constexpr double kSpeed = 10, kTorque = 100;  // rad/s, N m
const SceneSettings kWeightless{{0, 0, 0}, false};

HingeDef turning(double speed) {
  HingeDef kind;
  kind.angle.motor.emplace();
  kind.angle.motor->speed = speed;
  kind.angle.motor->strength = kTorque;
  return kind;
}

JointSpec pivot(BodyIndex body, const HingeDef& kind) { return joint(body, kWorld, {-0.5, 0, 0}, kind, {0, 0, 1}); }

// Against a limit at 2 rad for 10 s, then back.
Outcome hinge(Trial& trial) {
  Simulation& scene = trial.scene(kWeightless);
  const BodyIndex body = scene.add(rod(), {{0.5, 0, 0}, {}});
  HingeDef kind = turning(kSpeed);
  kind.angle.min = -2;
  kind.angle.max = 2;
  JointSpec spec = pivot(body, kind);
  const JointIndex index = scene.add(spec);
  double furthest = 0, shaking = 0, release = 0;
  const double seconds = span(trial, 10, 3, 1);
  run(scene, seconds, kFrame, [&](double time) {
    furthest = std::max(furthest, scene.joint_state(index).position);
    if (time > seconds / 2) shaking = std::max(shaking, std::abs(scene.angular_velocity(body).z));
    return true;
  });
  kind.angle.motor->speed = -kSpeed;
  spec.def.kind = kind;
  scene.configure_joint(index, spec.def);
  run(scene, 0.25, kFrame, [&](double) {
    release = std::max(release, std::abs(scene.angular_velocity(body).z));
    return true;
  });

  Outcome outcome;
  // 0.01 rad past the limit; at rest but for a hundredth of the speed; released no faster than the motor turns.
  outcome.error = std::max({relative(furthest, trial.reference(2), 0.01), shaking / (0.01 * kSpeed), release / (1.01 * kSpeed)});
  outcome.worst = furthest - 2;
  if (!finite(scene, body)) outcome.failed = "not a number";
  else if (scene.joint_state(index).position > 1) outcome.failed = "stays at its limit";
  return outcome;
}

// Past full turns the speed stays what it is.
Outcome whole_turns(Trial& trial) {
  Simulation& scene = trial.scene(kWeightless);
  const BodyIndex body = scene.add(rod(), {{0.5, 0, 0}, {}});
  scene.add(pivot(body, turning(kSpeed)));
  double error = 0;
  run(scene, span(trial, 10, 3, 2), kFrame, [&](double time) {
    if (time > 0.5) error = std::max(error, relative(scene.angular_velocity(body).z, trial.reference(kSpeed)));
    return true;
  });
  Outcome outcome;
  outcome.error = error / 1e-3;
  return outcome;
}

// A carriage of 2 kg pushes a box of 1 kg against a wall with 100 N, then goes back.
Outcome press(Trial& trial) {
  constexpr double speed = 1;  // m/s
  Simulation& scene = trial.scene();
  add_floor(scene);
  scene.add(fixed(box({1, 2, 2})), {{3.5, 1, 0}, {}});
  const BodyIndex squeezed = scene.add(with(dynamic(box({1, 1, 1}), 1), 0.5), {{1, 0.5, 0}, {}});
  const BodyIndex carriage = scene.add(with(dynamic(box({1, 0.8, 1}), 2), 0.5), {{-0.5, 0.6, 0}, {}});
  SliderDef kind;
  kind.position.motor.emplace();
  kind.position.motor->speed = speed;
  kind.position.motor->strength = 100;
  JointSpec spec = joint(carriage, kWorld, {}, kind, {1, 0, 0});
  const JointIndex index = scene.add(spec);
  const double seconds = span(trial, 10, 4, 3.5);  // the way takes 2
  double furthest = 0, shaking = 0, release = 0;
  run(scene, seconds, kFrame, [&](double time) {
    furthest = std::max(furthest, scene.joint_state(index).position);
    if (time > 3) shaking = std::max({shaking, length(scene.velocity(carriage)), length(scene.velocity(squeezed))});
    return true;
  });
  kind.position.motor->speed = -speed;
  spec.def.kind = kind;
  scene.configure_joint(index, spec.def);
  run(scene, 0.5, kFrame, [&](double) {
    release = std::max({release, length(scene.velocity(carriage)), length(scene.velocity(squeezed))});
    return true;
  });

  Outcome outcome;
  const Vec3 at = scene.pose(squeezed).position;
  outcome.error = std::max({relative(furthest, trial.reference(2), 0.01), shaking / (0.05 * speed), release / (1.01 * speed)});
  outcome.max_penetration = std::max(0.0, furthest - 2);
  if (!finite(scene, squeezed) || !finite(scene, carriage)) outcome.failed = "not a number";
  else if (std::abs(at.y - 0.5) > 0.1 || std::abs(at.z) > 0.1) outcome.failed = "the box was squeezed out";
  else if (scene.joint_state(index).position > 1.8) outcome.failed = "the carriage stays at the wall";
  return outcome;
}

// Two hinges with one axis and opposite motors hold one rod.
Outcome fight(Trial& trial) {
  Simulation& scene = trial.scene(kWeightless);
  Mechanism mechanism(scene, {});
  const BodyIndex body = mechanism.add(rod(), {{0.5, 0, 0}, {}});
  mechanism.join(pivot(body, turning(kSpeed)));
  mechanism.join(pivot(body, turning(-kSpeed)));
  const double seconds = span(trial, 10, 3, 1), scale = 0.5 * (kRodInertia + 0.25) * kSpeed * kSpeed;
  double early = 0, late = 0, fastest = 0, gap = 0;
  run(scene, seconds, kFrame, [&](double time) {
    double& most = time < seconds / 2 ? early : late;
    most = std::max(most, mechanism.kinetic());
    fastest = std::max(fastest, length(scene.angular_velocity(body)));
    gap = std::max(gap, mechanism.gap());
    return true;
  });
  Outcome outcome;
  // Never faster than either motor wants, no more energy later than before, and the hinge holds to 5 mm.
  outcome.error = std::max({fastest / (1.01 * kSpeed), std::max(0.0, late - early) / (0.01 * scale), relative(1 + gap, trial.reference(1), 0.005)});
  outcome.energy_drift = (late - early) / scale;
  outcome.max_joint_gap = gap;
  if (!mechanism.finite()) outcome.failed = "not a number";
  return outcome;
}

}  // namespace

Case b14_motor_into_limit() {
  return {"B14", "Motors against limits", "a hinge motor of 100 N m and 10 rad/s at its limit for 10 s; a slider motor with a box before a wall; two motors on one axis, against each other",
          "at most 0.01 rad or m past the limit, no energy builds up, released no faster than the motor", "the worst over what is allowed",
          {{"hinge into its limit", 1, hinge}, {"hinge past whole turns", 1, whole_turns}, {"slider presses a box", 1, press}, {"two motors fight", 1, fight}}};
}

}  // namespace tumble::accuracy
