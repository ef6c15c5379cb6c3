// Bodies created at one point, as a script that forgot to move its spawner does: they must come apart without an explosion.
// Its time per step, which is to stay below half a second, is the report's column.
#include "accuracy/cases/impact/overlap.h"
#include "accuracy/scenes.h"

namespace tumble::accuracy {

namespace {

constexpr double kRadius = 0.25;  // m, and half the edge of a box
constexpr double kHeight = 5;     // m above a floor: to fall from there gives 9.9 m/s
constexpr double kFastest = 20;   // m/s
constexpr double kEnough = 0.01;  // of the diameter: overlaps below it count as apart

Outcome burst(Trial& trial, const Shape& shape, int full_count, int quick_count) {
  Simulation& scene = trial.scene();
  add_floor(scene, 400);  // balls roll far
  const int count = static_cast<int>(trial.shortened(full_count, trial.effort() == Effort::test ? 20 : quick_count));
  Chance chance(23);
  std::vector<BodyIndex> bodies;
  for (int i = 0; i < count; ++i) {
    const Vec3 off{chance.between(-1e-3, 1e-3), chance.between(-1e-3, 1e-3), chance.between(-1e-3, 1e-3)};
    bodies.push_back(scene.add(with(dynamic(shape, 1), 0.5), {Vec3{0, kHeight, 0} + off, {}}));
  }

  Outcome outcome;
  double fastest = 0;
  run(scene, trial.shortened(10, trial.effort() == Effort::test ? 2 : 5), kFrame, [&](double) {
    for (const BodyIndex body : bodies) {
      if (!finite(scene, body)) outcome.failed = "not finite";
      fastest = std::max(fastest, length(scene.velocity(body)));
    }
    return outcome.failed.empty();
  });
  if (!outcome.failed.empty()) return outcome;

  const double size = trial.reference(2 * kRadius);
  const bool boxes = shape.shape == ShapeKind::box;
  std::vector<Vec3> at;
  for (const BodyIndex body : bodies) at.push_back(scene.pose(body).position);
  double deepest = 0;
  each_near_pair(at, boxes ? 2 * size : size, [&](std::size_t i, std::size_t k) {
    const double overlap = boxes ? box_overlap(scene.pose(bodies[i]), {size, size, size}, scene.pose(bodies[k]), {size, size, size}) : size - distance(at[i], at[k]);
    deepest = std::max(deepest, overlap);
  });
  outcome.max_penetration = deepest;
  outcome.error = std::max(fastest / kFastest, deepest / (kEnough * 2 * kRadius));
  return outcome;
}

}  // namespace

Case b23_one_point() {
  const double edge = 2 * kRadius;
  return {"B23", "Many bodies at one point", "balls of 0.25 m radius, or boxes, all within 1 mm of one point 5 m above a floor",
          "finite, no faster than 20 m/s, apart within 10 s (overlaps under 1 % of the size)", "worst of speed and last overlap, each over what is allowed",
          {{"300 balls", 1, [](Trial& t) { return burst(t, ball(kRadius), 300, 60); }},
           {"1000 balls", 1, [](Trial& t) { return burst(t, ball(kRadius), 1000, 80); }},
           {"300 boxes", 1, [edge](Trial& t) { return burst(t, box({edge, edge, edge}), 300, 40); }}}};
}

}  // namespace tumble::accuracy
