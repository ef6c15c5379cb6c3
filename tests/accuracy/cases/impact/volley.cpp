#include "accuracy/cases/impact/volley.h"

#include <algorithm>

namespace tumble::accuracy {

namespace {

constexpr Vec3 kWall{0.01, 40, 4};  // m
constexpr double kLane = 6;         // m between the lanes

}  // namespace

Hits fire(Trial& trial, const std::vector<Shot>& shots, double speed, BodyType wall) {
  Simulation& scene = trial.scene({{0, 0, 0}});
  std::vector<BodyIndex> bodies;
  std::vector<Vec3> last;
  double longest = 0;
  for (std::size_t i = 0; i < shots.size(); ++i) {
    const Vec3 lane{0, 0, kLane * static_cast<double>(i)}, direction{std::cos(shots[i].angle), std::sin(shots[i].angle), 0};
    scene.add(wall == BodyType::fixed ? fixed(box(kWall)) : kinematic(box(kWall)), {lane, {}});
    BodyDef def = shots[i].body;
    def.velocity = direction * speed;
    const double way = 1 / direction.x + speed * kFrame * shots[i].phase;
    longest = std::max(longest, way);
    bodies.push_back(scene.add(def, {lane - direction * way, {}}));
    last.push_back(center(scene, bodies.back()));
  }

  std::vector<bool> through(shots.size(), false);
  Hits hits;
  // A few steps more than the way takes.
  run(scene, (std::ceil(longest / speed / kFrame) + 5) * kFrame, kFrame, [&](double) {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (!finite(scene, bodies[i])) hits.failed = "not finite";
      const Vec3 now = center(scene, bodies[i]);
      if (last[i].x <= 0 && now.x > 0) {
        const double height = lerp(last[i], now, last[i].x / (last[i].x - now.x)).y;
        through[i] = through[i] || std::abs(height) < kWall.y / 2;
      }
      if (!through[i]) hits.rebound = std::max(hits.rebound, -scene.velocity(bodies[i]).x / speed);
      last[i] = now;
    }
    return hits.failed.empty();
  });
  hits.through = static_cast<int>(std::count(through.begin(), through.end(), true));
  return hits;
}

}  // namespace tumble::accuracy
