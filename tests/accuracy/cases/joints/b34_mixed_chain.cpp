// A chain of many kinds: hinges, sliders, balls and welds, or cones and universal joints in place of the last two, with
// limits, two with motors, a heavy end, hung up and shaken.
#include "accuracy/cases/joints/mechanisms.h"

#include <algorithm>

namespace tumble::accuracy {

namespace {

constexpr int kLinks = 10;
constexpr double kLink = 0.5, kHeavy = 100, kTurn = 0.5, kSlide = 0.1, kCone = 0.5;  // m, kg, rad, m

JointKind kind_of(int index, bool cones) {
  HingeDef hinge;
  hinge.angle.min = -kTurn;
  hinge.angle.max = kTurn;
  SliderDef slider;
  slider.position.min = -kSlide;
  slider.position.max = kSlide;
  if (index == 4) {
    hinge.angle.motor.emplace();
    hinge.angle.motor->speed = 1;
    hinge.angle.motor->strength = 20;
  }
  if (index == 5) {
    slider.position.motor.emplace();
    slider.position.motor->speed = 0.2;
    slider.position.motor->strength = 200;
  }
  RagdollDef cone;
  cone.swing_a.max = cone.swing_b.max = kCone;
  UniversalDef universal;
  universal.axis_b = Vec3{1, 0, 0};
  switch (index % 4) {
    case 0: return hinge;
    case 1: return slider;
    case 2: return cones ? JointKind{cone} : BallDef{};
    default: return cones ? JointKind{universal} : FixedDef{};
  }
}

Outcome shake(Trial& trial, bool cones) {
  Simulation& scene = trial.scene();
  Mechanism mechanism(scene);
  const BodyIndex hook = mechanism.add(kinematic(box({0.2, 0.2, 0.2})), {});
  std::vector<BodyIndex> bodies{hook};
  std::vector<JointIndex> joints;
  std::vector<JointSpec> specs;
  for (int i = 0; i <= kLinks; ++i) {  // the last one is the weight
    const bool weight = i == kLinks;
    const double length = weight ? 0.4 : kLink, top = -kLink * i;
    bodies.push_back(mechanism.add(weight ? dynamic(box({length, length, length}), kHeavy) : dynamic(box({0.1, length, 0.1}), 1), {{0, top - length / 2, 0}, {}}));
    const JointKind kind = weight ? JointKind{BallDef{}} : kind_of(i, cones);
    const bool upright = std::holds_alternative<SliderDef>(kind) || std::holds_alternative<RagdollDef>(kind);
    const Vec3 axis = upright ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
    specs.push_back(joint(bodies.back(), bodies[bodies.size() - 2], {0, length / 2, 0}, kind, axis));
    joints.push_back(mechanism.join(specs.back()));
  }

  // Work that the hook and the driven freedoms did: force along the way of each step.
  const double start = mechanism.energy(), seconds = span(trial, 20, 4, 1);
  double work = 0, turnover = 0, surplus = 0, gap = 0, beyond = 0;
  std::vector<double> before(joints.size(), 0);
  Vec3 hook_before;
  run(scene, seconds, kFrame, [&](double time) {
    const Vec3 hook_now = scene.pose(hook).position;
    double done = dot(scene.joint_state(joints[0]).force, hook_now - hook_before);
    hook_before = hook_now;
    for (std::size_t i = 0; i < joints.size(); ++i) {
      const JointState state = scene.joint_state(joints[i]);
      const bool slides = std::holds_alternative<SliderDef>(specs[i].def.kind), turns = std::holds_alternative<HingeDef>(specs[i].def.kind);
      if (std::holds_alternative<RagdollDef>(specs[i].def.kind)) {
        const Vec3 up = scene.pose(bodies[i]).rotation * Vec3{0, 1, 0}, bone = scene.pose(bodies[i + 1]).rotation * Vec3{0, 1, 0};
        beyond = std::max(beyond, std::acos(std::clamp(dot(up, bone), -1.0, 1.0)) - kCone);
      }
      if (!slides && !turns) continue;
      const Vec3 axis = scene.pose(bodies[i + 1]).rotation * specs[i].def.axis;
      done += dot(slides ? state.force : state.torque, axis) * (state.position - before[i]);
      before[i] = state.position;
      beyond = std::max(beyond, std::abs(state.position) - (slides ? kSlide : kTurn));
    }
    work += done;
    turnover += std::abs(done);
    surplus = std::max(surplus, mechanism.energy() - start - work);
    gap = std::max(gap, mechanism.gap());
    const double next = time + kFrame;
    scene.move(hook, {{0.2 * std::sin(2 * kPi * next), 0, 0}, {}});
    return mechanism.finite();
  });

  // Of energy 1 % of all that the end mass could fall and of what went in and out may come from nowhere.
  const double scale = (kHeavy + kLinks) * kGravity * kLink * kLinks + turnover;
  Outcome outcome;
  outcome.error = std::max({relative(kLink + gap, trial.reference(kLink), 0.01 * kLink), beyond / 0.01, surplus / (0.01 * scale)});
  outcome.max_joint_gap = gap;
  outcome.energy_drift = surplus / scale;
  outcome.worst = beyond;
  if (!mechanism.finite()) outcome.failed = "not a number";
  else if (gap > kLink) outcome.failed = "torn: a gap of " + text(gap) + " m";
  return outcome;
}

}  // namespace

Case b34_mixed_chain() {
  return {"B34", "Chain of mixed joints", "ten links of 0.5 m and 1 kg on hinge, slider, ball or cone, and fixed or universal joints in turn, limited, two driven, 100 kg at the end, shaken by 0.2 m at 1 Hz for 20 s",
          "gaps at most 1 % of a link, limits kept to 0.01, no energy beyond what hook and motors put in and 1 %", "the worst over what is allowed",
          {{"hinge slider ball fixed", 1, [](Trial& t) { return shake(t, false); }},
           {"with universals, and cones on the balls", 1, [](Trial& t) { return shake(t, true); }}}};
}

}  // namespace tumble::accuracy
