// Twenty bodies that overlap on a floor: they must come apart, and the pushing must not leave them with more energy than
// they had, heights counted.
#include "accuracy/cases/impact/overlap.h"
#include "accuracy/scenes.h"

namespace tumble::accuracy {

namespace {

constexpr double kSize = 0.5;      // m
constexpr double kMost = 0.01;     // energy gained, of what there was
constexpr double kEnough = 0.005;  // of the size: overlaps below it count as apart

Outcome heap(Trial& trial, const Shape& shape) {
  Simulation& scene = trial.scene();
  add_floor(scene);
  Chance chance(9);
  const bool boxes = shape.shape == ShapeKind::box;
  std::vector<BodyIndex> bodies;
  for (int i = 0; i < 20; ++i) {
    const Vec3 at{chance.between(-0.5, 0.5), chance.between(0.5, 1.5), chance.between(-0.5, 0.5)};
    bodies.push_back(scene.add(with(dynamic(shape, 1), 0.5), {at, boxes ? chance.rotation() : Quat{}}));
  }
  const auto total = [&] {
    double sum = 0;
    for (const BodyIndex body : bodies) sum += energy(scene, body);
    return sum;
  };

  const double start = total();
  double most = start;
  Outcome outcome;
  run(scene, trial.shortened(10, trial.effort() == Effort::test ? 2 : 5), kFrame, [&](double) {
    for (const BodyIndex body : bodies)
      if (!finite(scene, body)) outcome.failed = "not finite";
    most = std::max(most, total());
    return outcome.failed.empty();
  });

  const Vec3 edges = trial.reference(Vec3{kSize, kSize, kSize});
  double deepest = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    for (std::size_t k = i + 1; k < bodies.size(); ++k) {
      const Pose a = scene.pose(bodies[i]), b = scene.pose(bodies[k]);
      deepest = std::max(deepest, boxes ? box_overlap(a, edges, b, edges) : edges.x - distance(a.position, b.position));
    }
  outcome.max_penetration = deepest;
  outcome.energy_drift = most / start - 1;
  outcome.error = std::max((trial.reference(most) / start - 1) / kMost, deepest / (kEnough * kSize));
  return outcome;
}

}  // namespace

Case s09_twenty_overlapping() {
  return {"S09", "Twenty overlapping bodies", "20 boxes or balls of 0.5 m within a cubic metre above a floor, for 10 s", "C: energy does not rise; apart at the end",
          "worst of the energy gained over 1 % and the last overlap over 0.5 % of the size",
          {{"boxes", 1, [](Trial& t) { return heap(t, box({kSize, kSize, kSize})); }}, {"balls", 1, [](Trial& t) { return heap(t, ball(kSize / 2)); }}}};
}

}  // namespace tumble::accuracy
