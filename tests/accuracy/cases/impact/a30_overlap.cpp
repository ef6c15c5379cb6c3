// How deep a heap of balls overlaps while it falls apart: SimBenchmark's 666, without bounce and friction, in a box.
#include "accuracy/cases/impact/overlap.h"
#include "accuracy/cases/impact/room.h"

namespace tumble::accuracy {

namespace {

constexpr double kRadius = 0.1, kRoom = 3;  // m

Outcome fall(Trial& trial) {
  Simulation& scene = trial.scene();
  add_floor(scene);
  add_walls(scene, kRoom, 6);
  Chance chance(42);
  std::vector<BodyIndex> balls;
  for (int i = 0; i < 216; ++i) {
    const Vec3 off{chance.between(-1e-3, 1e-3), chance.between(-1e-3, 1e-3), chance.between(-1e-3, 1e-3)};
    balls.push_back(scene.add(dynamic(ball(kRadius), 10), {Vec3(i % 6 - 2.5, i / 36, i / 6 % 6 - 2.5) * 0.21 + Vec3{0, 1.1, 0} + off, {}}));
  }

  const double touch = trial.reference(2 * kRadius);
  double squares = 0, deepest = 0;
  int steps = 0;
  std::vector<Vec3> at(balls.size());
  run(scene, trial.shortened(10, trial.effort() == Effort::test ? 0.7 : 2), kFrame, [&](double) {
    const auto add = [&](double overlap) {
      if (overlap <= 0) return;
      squares += overlap * overlap;
      deepest = std::max(deepest, overlap);
    };
    for (std::size_t i = 0; i < balls.size(); ++i) at[i] = scene.pose(balls[i]).position;
    each_near_pair(at, touch, [&](std::size_t i, std::size_t k) { add(touch - distance(at[i], at[k])); });
    for (const Vec3& p : at) {
      add(touch / 2 - p.y);
      add(touch / 2 + std::max(std::abs(p.x), std::abs(p.z)) - kRoom / 2);
    }
    ++steps;
    return true;
  });

  Outcome outcome;
  outcome.error = std::sqrt(squares / (static_cast<double>(steps) * static_cast<double>(balls.size()))) / kRadius;
  outcome.max_penetration = deepest;
  for (const Vec3& p : at)
    if (!(std::abs(p.x) < kRoom / 2 && p.y > 0 && std::abs(p.z) < kRoom / 2)) outcome.failed = "a ball left the box";
  return outcome;
}

}  // namespace

Case a30_overlap() {
  return {"A30", "666 penetration", "216 balls of 10 kg in a grid fall 1 m into a box of 3 m, no bounce, no friction", "F: no overlap",
          "RMS of the overlaps, per ball and step, over the radius", {{"", 0.01, fall}}};
}

}  // namespace tumble::accuracy
