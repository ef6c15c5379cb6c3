// B10, things that are long, flat or turning, and two that are both fast.
#include <algorithm>

#include "accuracy/cases/impact/b10_parts.h"

namespace tumble::accuracy {

// A tilted plank from 5 m on a ground of two triangles.
Outcome plank(Trial& trial) {
  Simulation& scene = trial.scene();
  Shape ground;
  ground.shape = ShapeKind::mesh;
  const Vec3 a{-10, 0, -10}, b{-10, 0, 10}, c{10, 0, 10}, d{10, 0, -10};
  ground.points = {a, b, c, a, c, d};
  std::vector<BodyIndex> planks;
  for (int i = 0; i < trial.phases(); ++i) {
    const double part = static_cast<double>(i) / trial.phases();
    scene.add(fixed(ground), {{0, 0, 30.0 * i}, {}});
    const Quat tilt = axis_angle({1, 0, 0}, 0.1 + 0.9 * part) * axis_angle({0, 0, 1}, 0.2);
    planks.push_back(scene.add(with(dynamic(box({2, 0.06, 2}), 10), 0.5), {{0, 5 + 0.1 * part, 30.0 * i}, tilt}));
  }
  run(scene, trial.shortened(4, trial.effort() == Effort::test ? 1.5 : 2.5));
  int through = 0;
  for (const BodyIndex body : planks) through += !(scene.pose(body).position.y > 0);
  return count_through(through, static_cast<int>(planks.size()));
}

// A thin rod at 4 m/s on a plane, from upright to lying.
Outcome rod(Trial& trial) {
  Simulation& scene = trial.scene();
  Shape plane;
  plane.shape = ShapeKind::plane;
  plane.size = {20, 1, 20};
  std::vector<BodyIndex> rods;
  for (int i = 0; i < trial.phases(); ++i) {
    const double tilt = kPi / 2 * i / trial.phases();
    scene.add(fixed(plane), {{0, 0, 30.0 * i}, {}});
    BodyDef def = with(dynamic(box({0.04, 4, 0.04}), 1), 0.5);
    def.velocity = {0, -4, 0};
    const double low = 2 * std::cos(tilt) + 0.02 * std::sin(tilt);  // of its centre above its lowest end
    rods.push_back(scene.add(def, {{0, low + 0.5, 30.0 * i}, axis_angle({0, 0, 1}, tilt)}));
  }
  run(scene, trial.shortened(4, trial.effort() == Effort::test ? 1 : 2.5));
  int through = 0;
  for (const BodyIndex body : rods) through += !(scene.pose(body).position.y > 0);
  return count_through(through, static_cast<int>(rods.size()));
}

// Two balls head on, each at this speed.
Outcome head_on(Trial& trial, double speed) {
  Simulation& scene = trial.scene({{0, 0, 0}});
  std::vector<BodyIndex> left, right;
  for (int i = 0; i < trial.phases(); ++i)
    for (const double side : {-1.0, 1.0}) {
      BodyDef def = swept(dynamic(ball(0.1), 1));
      def.velocity = {-side * speed, 0, 0};
      const double way = 1 + speed * kFrame * i / trial.phases();
      (side < 0 ? left : right).push_back(scene.add(def, {{side * way, 0, 3.0 * i}, {}}));
    }
  run(scene, (std::ceil(1 / speed / kFrame) + 5) * kFrame);
  int through = 0;
  for (std::size_t i = 0; i < left.size(); ++i) through += !(scene.pose(left[i]).position.x < scene.pose(right[i]).position.x);
  return count_through(through, static_cast<int>(left.size()));
}

// A stick of 2 m turns at 20 rad/s towards a thin post, which is never to be on its other side.
Outcome stick(Trial& trial) {
  Simulation& scene = trial.scene({{0, 0, 0}});
  std::vector<BodyIndex> sticks;
  std::vector<Vec3> posts;
  for (int i = 0; i < trial.phases(); ++i) {
    const double ahead = 0.6 + 20 * kFrame * i / trial.phases();
    BodyDef def = swept(dynamic(box({2, 0.05, 0.05}), 1));
    def.angular_velocity = {0, 20, 0};
    sticks.push_back(scene.add(def, {{0, 0, 4.0 * i}, {}}));
    posts.push_back(Vec3{std::cos(ahead), 0, -std::sin(ahead)} * 0.8 + Vec3{0, 0, 4.0 * i});
    scene.add(fixed(box({0.04, 2, 0.04})), {posts.back(), {}});
  }
  std::vector<bool> through(sticks.size(), false);
  run(scene, 10 * kFrame, kFrame, [&](double) {
    for (std::size_t i = 0; i < sticks.size(); ++i) {
      const Vec3 post = inverse(scene.pose(sticks[i])) * posts[i];  // z < 0 is where it started
      if (std::abs(post.x) < 1 && post.z > 0) through[i] = true;
    }
    return true;
  });
  return count_through(static_cast<int>(std::count(through.begin(), through.end(), true)), static_cast<int>(sticks.size()));
}

}  // namespace tumble::accuracy
