// Forces at rest: what lies still is carried, and the impulses of a step add up to its weight.
#include <algorithm>
#include <map>

#include "accuracy/cases/stacking/build.h"

namespace tumble::accuracy {

namespace {

// Mean normal impulse of a step in the last second of the run, of each pair of bodies, the older first.
std::map<std::pair<int, int>, Vec3> resting_impulses(Trial& trial, Simulation& scene) {
  std::map<std::pair<int, int>, Vec3> sums;
  const double seconds = lasting(trial, 5, 3, 2);
  scene.touches();  // an engine may begin to sum impulses once it is asked for them
  run(scene, seconds, kFrame, [&](double time) {
    if (time <= seconds - 1 + kFrame / 2) return true;
    for (const Touch& touch : scene.touches()) sums[{touch.a, touch.b}] += touch.normal * (touch.impulse * kFrame);
    return true;
  });
  return sums;
}

constexpr double kMass = 3;
double weight(Trial& trial, double mass) { return trial.reference(mass * kGravity * kFrame); }  // N s a step

Outcome single(Trial& trial) {
  Simulation& scene = trial.scene();
  const BodyIndex floor = add_floor(scene);
  const BodyIndex body = scene.add(with(dynamic(box({1, 1, 1}), kMass), 0.5), {{0, 0.5, 0}, {}});
  auto impulses = resting_impulses(trial, scene);
  Outcome outcome;
  outcome.error = relative(impulses[{floor, body}].y, weight(trial, kMass));
  return outcome;
}

// The interfaces carry five, four, three, two and one weight; an error counts in weights of one box.
Outcome stack(Trial& trial) {
  Simulation& scene = trial.scene();
  BodyIndex below = add_floor(scene);
  constexpr int kCount = 5;
  for (int i = 0; i < kCount; ++i) scene.add(with(dynamic(box({1, 1, 1}), kMass), 0.5), {{0, 0.5 + i, 0}, {}});
  auto impulses = resting_impulses(trial, scene);
  Outcome outcome;
  for (int i = 0; i < kCount; ++i, ++below)
    outcome.error = std::max(outcome.error, relative(impulses[{below, below + 1}].y, weight(trial, kMass * (kCount - i)), kMass * kGravity * kFrame));
  return outcome;
}

// A cube on its edge in a groove of 90 degrees, without friction: each side carries m g / sqrt 2.
Outcome wedge(Trial& trial) {
  Simulation& scene = trial.scene();
  const double turn = kPi / 4;
  const Vec3 z{0, 0, 1};
  const BodyIndex left = scene.add(fixed(box({4, 1, 4})), {axis_angle(z, -turn) * Vec3{0, -0.5, 0}, axis_angle(z, -turn)});
  const BodyIndex right = scene.add(fixed(box({4, 1, 4})), {axis_angle(z, turn) * Vec3{0, -0.5, 0}, axis_angle(z, turn)});
  const BodyIndex body = scene.add(dynamic(box({1, 1, 1}), kMass), {{0, std::sqrt(0.5), 0}, axis_angle(z, turn)});
  auto impulses = resting_impulses(trial, scene);
  const Vec3 a = impulses[{left, body}], b = impulses[{right, body}];
  const double whole = weight(trial, kMass), side = whole / std::sqrt(2.0);
  Outcome outcome;
  outcome.error = std::max({relative(a.y + b.y, whole), relative(length(a), side), relative(length(b), side)});
  return outcome;
}

// A table with four legs, each on a plate of its own: the sum is the weight, and all four carry alike.
Outcome table(Trial& trial, bool symmetry) {
  Simulation& scene = trial.scene();
  BodyDef def = with(dynamic(box({2, 0.1, 1}), kMass), 0.5);
  def.colliders.front().offset = {0, 0.45, 0};
  std::vector<BodyIndex> plates;
  for (const double x : {-0.9, 0.9})
    for (const double z : {-0.4, 0.4}) {
      plates.push_back(scene.add(fixed(box({0.5, 2, 0.5})), {{x, -1, z}, {}}));
      def.colliders.emplace_back();
      def.colliders.back().shape = box({0.1, 0.9, 0.1});
      def.colliders.back().offset = {x, -0.05, z};
    }
  const BodyIndex body = scene.add(def, {{0, 0.5, 0}, {}});
  auto impulses = resting_impulses(trial, scene);
  double sum = 0;
  Spread legs;
  for (const BodyIndex plate : plates) {
    const double leg = impulses[{plate, body}].y;
    sum += leg;
    legs.add(leg);
  }
  Outcome outcome;
  outcome.error = relative(sum, weight(trial, kMass));
  if (symmetry) outcome.error = std::max(outcome.error, (legs.high - legs.low) / (sum / 4));
  return outcome;
}

}  // namespace

Case a23_resting_forces() {
  return {"A23", "Resting forces", "a box of 3 kg on the floor, five in a stack, one on its edge in a groove, a table of four legs",
          "F: the normal impulses of a step are m g h of all that lies above", "|mean impulse of the last second - truth| / truth, the worst interface",
          {{"single", 1e-4, single},
           {"stack of 5", 1e-2, stack},
           {"groove", 1e-4, wedge},
           {"table, sum", 1e-4, [](Trial& t) { return table(t, false); }},
           {"table, each leg", 1e-2, [](Trial& t) { return table(t, true); }}}};
}

}  // namespace tumble::accuracy
