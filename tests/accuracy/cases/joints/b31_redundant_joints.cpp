// More joints than are needed: a planar four-bar, a door on three hinges, a ring closed by welds, two welds at one place.
// What they hold they hold twice, and a solver may fight itself; the motion must be that of the least joints.
#include "accuracy/cases/joints/mechanisms.h"

namespace tumble::accuracy {

namespace {

constexpr double kSwing = kPi / 6;
const Vec3 kPivot{0, 10, 0};

// Swings it and compares its period with the truth, to 1 %; joints hold to 1 % of `size`, sideways drift too.
Outcome watch(Trial& trial, Simulation& scene, const Mechanism& mechanism, const std::function<double()>& angle, double period, double size,
              const std::function<double()>& drift) {
  Swing swing;
  double gap = 0;
  run(scene, span(trial, 60, 6, 4), kFrame, [&](double time) {
    swing.add(time, angle());
    gap = std::max(gap, mechanism.gap());
    return mechanism.finite();
  });
  Outcome outcome;
  outcome.error = std::max({relative(swing.period(), trial.reference(period)) / 0.01, gap / (0.01 * size), drift() / (0.01 * size)});
  outcome.max_joint_gap = gap;
  if (!mechanism.finite()) outcome.failed = "not a number";
  else if (swing.period() == 0) outcome.failed = "does not swing";
  return outcome;
}

// Two rods hang 1 m apart and carry a third, level, which moves on a circle without turning.
Outcome four_bar(Trial& trial) {
  Simulation& scene = trial.scene();
  Mechanism mechanism(scene);
  const Vec3 along{std::sin(kSwing), -std::cos(kSwing), 0}, level{1, 0, 0};
  std::vector<BodyIndex> cranks;
  for (const double x : {0.0, 1.0}) cranks.push_back(mechanism.chain({kPivot + level * x, kPivot + level * x + along}, rod(), HingeDef{}).front());
  const BodyIndex coupler = mechanism.add(rod(), {kPivot + along + level / 2, {}});
  mechanism.join(joint(coupler, cranks[0], {-0.5, 0, 0}, HingeDef{}, {0, 0, 1}));
  mechanism.join(joint(coupler, cranks[1], {0.5, 0, 0}, HingeDef{}, {0, 0, 1}));
  const double period = swing_period(2 * (kRodInertia + 0.25) + 1, 2 * 0.5 + 1, kSwing);
  return watch(trial, scene, mechanism, [&] { return angle_of(scene, cranks[0], kPivot); }, period, 1, [&] { return std::abs(scene.pose(coupler).position.z); });
}

// A door of 20 kg, 1 x 2 m, turns about three hinges of one upright axis.
Outcome door(Trial& trial) {
  Simulation& scene = trial.scene();
  Mechanism mechanism(scene);
  constexpr double speed = 2;  // rad/s
  BodyDef leaf = dynamic(box({1, 2, 0.05}), 20);
  leaf.angular_velocity = {0, speed, 0};
  leaf.velocity = cross(leaf.angular_velocity, {0.5, 0, 0});
  const BodyIndex body = mechanism.add(leaf, {kPivot + Vec3{0.5, 0, 0}, {}});
  for (const double y : {-0.8, 0.0, 0.8}) mechanism.join(joint(body, kWorld, {-0.5, y, 0}, HingeDef{}));
  return watch(trial, scene, mechanism, [&] { return scene.pose(body).position.z; }, 2 * kPi / speed, 1, [&] { return std::abs(scene.pose(body).position.y - kPivot.y); });
}

// A ring of 32 hulls, 2 m from its middle, welded all round and hung up at one of them.
Outcome ring(Trial& trial) {
  constexpr int parts = 32;
  constexpr double radius = 2, half = kPi / parts, thick = 0.15;
  std::vector<Vec3> points;  // a wedge whose middle is at {radius, 0, 0}
  for (const double r : {radius - thick, radius + thick})
    for (const double a : {-half, half})
      for (const double z : {-thick, thick}) points.push_back({r * std::cos(a), r * std::sin(a), z});
  const Vec3 middle = mass_properties(dynamic(hull(points), 1)).center;
  for (Vec3& point : points) point = point - middle;
  const BodyDef wedge = dynamic(hull(points), 1);
  const MassProperties mass = mass_properties(wedge);
  const double across = (mass.axes * scaled(mass.inertia, conjugate(mass.axes) * Vec3{0, 0, 1})).z;

  // The hull in whose middle the hinge is lies at the top of a ring that is turned aside by the swing.
  Simulation& scene = trial.scene();
  Mechanism mechanism(scene);
  const double ring_radius = middle.x;
  const Vec3 center = kPivot + Vec3{std::sin(kSwing), -std::cos(kSwing), 0} * ring_radius;
  const Vec3 edge = axis_angle({0, 0, 1}, -half) * Vec3{ring_radius, 0, 0} - Vec3{ring_radius, 0, 0};
  std::vector<BodyIndex> bodies;
  for (int i = 0; i < parts; ++i) {
    const Quat turn = axis_angle({0, 0, 1}, kPi / 2 + kSwing + 2 * half * i);
    bodies.push_back(mechanism.add(wedge, {center + turn * Vec3{ring_radius, 0, 0}, turn}));
    if (i > 0) mechanism.join(joint(bodies.back(), bodies[bodies.size() - 2], edge, FixedDef{}));
  }
  mechanism.join(joint(bodies.front(), bodies.back(), edge, FixedDef{}));
  mechanism.join(joint(bodies.front(), kWorld, {}, HingeDef{}, {0, 0, 1}));

  const double about_middle = parts * (across + ring_radius * ring_radius), period = swing_period(about_middle + parts * ring_radius * ring_radius, parts * ring_radius, kSwing);
  const BodyIndex opposite = bodies[parts / 2];
  return watch(trial, scene, mechanism, [&] { return angle_of(scene, opposite, kPivot); }, period, 2 * half * radius, [&] { return std::abs(scene.pose(opposite).position.z); });
}

// The rod of the pendulums in two halves, welded twice.
Outcome welded_twice(Trial& trial) {
  Simulation& scene = trial.scene();
  Mechanism mechanism(scene);
  const Vec3 along{std::sin(kSwing), -std::cos(kSwing), 0};
  const auto halves = mechanism.chain({kPivot, kPivot + along * 0.5}, dynamic(box({0.5, 0.1, 0.1}), 0.5), HingeDef{});
  const BodyIndex lower = mechanism.chain({kPivot + along * 0.5, kPivot + along}, dynamic(box({0.5, 0.1, 0.1}), 0.5), FixedDef{}, halves[0]).front();
  mechanism.join(joint(lower, halves[0], {-0.25, 0, 0}, FixedDef{}));
  return watch(trial, scene, mechanism, [&] { return angle_of(scene, lower, kPivot); }, swing_period(kRodInertia + 0.25, 0.5, kSwing), 0.5,
               [&] { return std::abs(scene.pose(lower).position.z); });
}

}  // namespace

Case b31_redundant_joints() {
  return {"B31", "Redundant joints", "a four-bar on four hinges, a door on three, a ring of 32 welded hulls, two welds at one place; 60 s",
          "F: periods of the same motion with the least joints, to 1 %; gaps and drift at most 1 % of a body's size", "the worst over what is allowed",
          {{"four-bar", 1, four_bar}, {"door on three hinges", 1, door}, {"ring of 32", 1, ring}, {"two welds", 1, welded_twice}}};
}

}  // namespace tumble::accuracy
