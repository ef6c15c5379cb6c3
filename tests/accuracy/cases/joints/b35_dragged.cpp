// Dragged past its limits: something that nothing can resist pulls a slider 2 m and a hinge a quarter turn beyond, holds,
// and returns. No solution exists meanwhile, so forces must stay bounded; after it all is as before, or broken.
#include "accuracy/cases/joints/mechanisms.h"

namespace tumble::accuracy {

namespace {

constexpr double kBreak = 1000;  // N

// A rod of 1 kg on a limited joint of the world, and a hand that is welded to it.
struct Dragged {
  Simulation& scene;
  Mechanism mechanism;
  bool turns;
  BodyIndex body = 0, hand = 0;
  JointIndex limited = 0, grip = 0;

  Dragged(Simulation& simulation, bool turn, double break_force) : scene(simulation), mechanism(simulation, {}), turns(turn) {
    body = mechanism.add(rod(), {{0.5, 0, 0}, {}});
    hand = mechanism.add(kinematic(box({0.2, 0.2, 0.2})), {});
    HingeDef hinge;
    hinge.angle.min = -0.5;
    hinge.angle.max = 0.5;
    SliderDef slider;
    slider.position.min = -0.5;
    slider.position.max = 0.5;
    limited = mechanism.join(joint(body, kWorld, {-0.5, 0, 0}, turn ? JointKind{hinge} : JointKind{slider}, turn ? Vec3{0, 0, 1} : Vec3{1, 0, 0}));
    JointSpec weld = joint(body, hand, {}, FixedDef{});
    weld.def.break_force = break_force;
    grip = mechanism.join(weld);
  }
  void put(double way) { scene.move(hand, turns ? Pose{{}, axis_angle({0, 0, 1}, way)} : Pose{{way, 0, 0}, {}}); }
  double position() const { return scene.joint_state(limited).position; }
};

// 0.5 to the limit and so much beyond in 1 s, held for 1 s, back in 1 s, and 1 s to recover.
Outcome drag(Trial& trial, bool turn, bool breaks) {
  const double beyond = turn ? kPi / 2 : 2;
  Dragged dragged(trial.scene({{0, 0, 0}, false}), turn, breaks ? kBreak : kInfinity);
  Simulation& scene = dragged.scene;
  const double h = kFrame / trial.knobs().substeps;
  double force = 0, early = 0, late = 0;
  bool broken = false;
  run(scene, 4, kFrame, [&](double time) {
    const double next = time + kFrame;
    dragged.put((0.5 + beyond) * std::clamp(next < 2 ? next : 3 - next, 0.0, 1.0));
    const JointState state = scene.joint_state(dragged.grip);
    broken = state.broken;
    const double now = broken ? 0 : length(state.force);
    force = std::max(force, now);
    if (time > 1.2 && time < 1.5) early = std::max(early, now);
    if (time > 1.7 && time < 2) late = std::max(late, now);
    return dragged.mechanism.finite();
  });

  Outcome outcome;
  // Twice the force that would close the gap within one substep (to stop it there, and to bring it back) bounds it, and it
  // must not grow while the hand holds still.
  const double most = 2 * beyond / (h * h);
  outcome.error = std::max(force / most, breaks ? 0 : late / (1.1 * early + 1));
  if (!breaks) outcome.error = std::max({outcome.error, relative(1 + dragged.position(), trial.reference(1), 0.005), dragged.mechanism.fastest() / 0.05});
  else outcome.error = std::max(outcome.error, relative(1 + std::max(0.0, std::abs(dragged.position()) - 0.5), trial.reference(1), 0.005));
  outcome.worst = force;
  if (!dragged.mechanism.finite()) outcome.failed = "not a number";
  else if (broken != breaks) outcome.failed = breaks ? "does not break" : "breaks unasked";
  return outcome;
}

// A weld of the world breaks under a load that grows by 200 N, or N m, a second.
Outcome breaking(Trial& trial, bool torque) {
  Simulation& scene = trial.scene({{0, 0, 0}, false});
  const BodyIndex body = scene.add(rod(), {});
  JointSpec weld = joint(body, kWorld, {}, FixedDef{});
  (torque ? weld.def.break_torque : weld.def.break_force) = kBreak;
  const JointIndex index = scene.add(weld);
  double load = 0;
  for (int i = 1; i <= 480 && !scene.joint_state(index).broken; ++i) {
    load = 200 * i * kFrame;
    if (torque) scene.apply_torque(body, {0, 0, load});
    else scene.apply_force(body, {load, 0, 0});
    scene.step(kFrame);
  }
  Outcome outcome;
  outcome.error = relative(load, trial.reference(kBreak)) / 0.1;
  if (!scene.joint_state(index).broken) outcome.failed = "does not break";
  return outcome;
}

}  // namespace

Case b35_dragged() {
  return {"B35", "Dragged past limits", "a kinematic hand welded to a rod drags its slider 2 m, its hinge 90 degrees past the limit in 1 s, holds, returns; welds with a break force of 1000 N",
          "force below ten times what would close the gap in a substep, and steady, recovered within 1 s, broken at the stated load within 10 %", "the worst over what is allowed",
          {{"slider", 1, [](Trial& t) { return drag(t, false, false); }},
           {"hinge", 1, [](Trial& t) { return drag(t, true, false); }},
           {"slider, breaks", 1, [](Trial& t) { return drag(t, false, true); }},
           {"hinge, breaks", 1, [](Trial& t) { return drag(t, true, true); }},
           {"break force", 1, [](Trial& t) { return breaking(t, false); }},
           {"break torque", 1, [](Trial& t) { return breaking(t, true); }}}};
}

}  // namespace tumble::accuracy
