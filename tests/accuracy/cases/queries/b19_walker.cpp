// A capsule that walks: driven by velocity, kept upright, over stairs and seams, along tiled walls and into corners.
// Games without a character controller move their figures so. (What only a mover does is told as missing.)
#include "accuracy/cases/life/verdict.h"
#include "accuracy/cases/queries/grounds.h"

namespace tumble::accuracy {

namespace {

constexpr double kRadius = 0.3, kHeight = 1.8;  // a cylinder of 1.2 m with its two half balls
constexpr double kSpeed = 4, kRise = 0.2, kTread = 0.3;
constexpr int kSteps = 20;
constexpr double kStepRate = kSpeed * kRise / kTread;  // how fast the stairs rise under it, m/s
constexpr double kSink = 0.05;                         // m

BodyIndex add_walker(Simulation& scene, Vec3 foot) {
  BodyDef def = dynamic(upright(ShapeKind::capsule, kRadius, kHeight), 70);
  def.lock_rotation = "xyz";
  return scene.add(def, {foot + Vec3{0, kHeight / 2, 0}, {}});
}

// Walks with the wanted level velocity; the vertical one is left to physics. Calls each(foot, vertical speed).
void walk(Simulation& scene, BodyIndex body, Vec3 velocity, double seconds, const std::function<bool(Vec3, double)>& each) {
  scene.set_velocity(body, velocity);
  run(scene, seconds, kFrame, [&](double) {
    const double vertical = scene.velocity(body).y;
    const bool on = each(scene.pose(body).position - Vec3{0, kHeight / 2, 0}, vertical);
    scene.set_velocity(body, {velocity.x, vertical, velocity.z});
    return on && finite(scene, body);
  });
}

// From x = 0 on, `up` or down; solid blocks below.
void add_stairs(Simulation& scene, bool up) {
  for (int i = 0; i < kSteps; ++i) {
    const double top = kRise * (up ? i + 1 : kSteps - i - 1);
    scene.add(fixed(box({kTread, top + 1, 4})), {{kTread * (i + 0.5), (top - 1) / 2, 0}, {}});
  }
  const double high = kRise * kSteps;
  scene.add(fixed(box({10, (up ? 0 : high) + 1, 4})), {{-5, ((up ? 0 : high) - 1) / 2, 0}, {}});
  scene.add(fixed(box({10, (up ? high : 0) + 1, 4})), {{kTread * kSteps + 5, ((up ? high : 0) - 1) / 2, 0}, {}});
}

double stairs_at(double x, bool up) {
  const int step = static_cast<int>(std::clamp(std::floor(x / kTread) + 1, 0.0, double(kSteps)));
  return kRise * (up ? step : kSteps - step);
}

// Up: it must arrive, in twice the time that level ground takes, and never be thrown. Down: it may fly, but not bounce.
Outcome stairs(Trial& trial, bool up) {
  Simulation& scene = trial.scene();
  add_stairs(scene, up);
  const BodyIndex body = add_walker(scene, {-2, up ? 0 : kRise * kSteps, 0});
  const double end = kTread * kSteps + 1;
  Verdict verdict;
  double reached = -2, lowest_gap = 0;
  walk(scene, body, {kSpeed, 0, 0}, 2 * (end + 2) / kSpeed, [&](Vec3 foot, double vertical) {
    reached = foot.x;
    verdict.allow(vertical, kStepRate);
    // The lowest point of its round foot may be over a deeper tread than its rim; it is held against the lower one.
    lowest_gap = std::min(lowest_gap, foot.y - std::min(stairs_at(foot.x - kRadius, up), stairs_at(foot.x + kRadius, up)));
    return reached < end;
  });
  verdict.require_finite(scene, body);
  verdict.outcome.max_penetration = -lowest_gap;
  verdict.allow(-lowest_gap, kSink);
  if (verdict.require(reached >= end, "stuck at x = " + std::to_string(reached))) {
    run(scene, 1);
    verdict.allow(std::abs(scene.pose(body).position.y - trial.reference((up ? kRise * kSteps : 0) + kHeight / 2)), 0.0085);
  }
  return verdict.outcome;
}

// Over level ground with a seam or edges: never up nor down.
Outcome level(Trial& trial, const std::vector<std::pair<Shape, Vec3>>& grounds) {
  Simulation& scene = trial.scene();
  for (const auto& [shape, at] : grounds) scene.add(fixed(shape), {at, {}});
  const BodyIndex body = add_walker(scene, {-6, 0, 0.2});
  Verdict verdict;
  walk(scene, body, {kSpeed, 0, 0}, 3, [&](Vec3 foot, double vertical) {
    verdict.allow(std::abs(vertical), 0.02);
    verdict.allow(-foot.y, kSink);
    return true;
  });
  verdict.allow(std::abs(scene.pose(body).position.x + 6 - trial.reference(3 * kSpeed)), 0.1);
  return verdict.outcome;
}

Outcome seams(Trial& trial) {
  const Shape field = tiled(ShapeKind::height_field, 10);
  return level(trial, {{field, {-10, 0, 0}}, {field, {10, 0, 0}}});
}

// Pressed against a wall of boxes of 1 m, it walks along.
Outcome wall(Trial& trial) {
  Simulation& scene = trial.scene();
  add_floor(scene);
  for (int x = -8; x < 8; ++x)
    for (int y = 0; y < 3; ++y) scene.add(fixed(box({1, 1, 1})), {{x + 0.5, y + 0.5, 0.5}, {}});
  const BodyIndex body = add_walker(scene, {-6, 0, -kRadius});
  Verdict verdict;
  walk(scene, body, {kSpeed, 0, 1}, 3, [&](Vec3 foot, double vertical) {
    verdict.allow(std::abs(vertical), 0.02);
    verdict.allow(-foot.y, kSink);
    verdict.allow(foot.z + kRadius, kSink);
    return true;
  });
  verdict.allow(std::abs(scene.pose(body).position.x + 6 - trial.reference(3 * kSpeed)), 0.1);
  return verdict.outcome;
}

// Two walls that meet at x = 0 at an angle; it walks into the corner for 2 s and out again.
Outcome corner(Trial& trial, double degrees) {
  const double half = radians(degrees) / 2;
  Simulation& scene = trial.scene();
  add_floor(scene);
  for (const double side : {-1.0, 1.0}) {
    const Pose turned{{}, axis_angle({0, 1, 0}, side * half)};
    scene.add(fixed(box({10, 4, 1})), turned * Pose{{-5, 2, side * 0.5}, {}});
  }
  const double deepest = -kRadius / std::sin(half);  // where its middle ends
  const BodyIndex body = add_walker(scene, {deepest - 2, 0, 0.05});
  Verdict verdict;
  const auto each = [&](Vec3 foot, double vertical) {
    verdict.allow(std::abs(vertical), 0.1);
    verdict.allow(-foot.y, kSink);
    for (const double side : {-1.0, 1.0}) {
      const Vec3 out = axis_angle({0, 1, 0}, side * half) * Vec3{0, 0, -side};
      verdict.allow(kRadius - dot(foot, out), kSink);
    }
    return true;
  };
  walk(scene, body, {kSpeed, 0, 0}, 2, each);
  verdict.allow(std::abs(scene.pose(body).position.x - trial.reference(deepest)), std::min(kSink, 0.006 * -deepest));
  walk(scene, body, {-kSpeed, 0, 0}, 0.5, each);
  verdict.allow(std::abs(scene.pose(body).position.x - (deepest - 0.5 * kSpeed)), 0.2);
  return verdict.outcome;
}

Outcome needs_mover(Trial&) { throw Missing{"a character mover"}; }

}  // namespace

Case b19_walker() {
  return {"B19", "Walking capsule", "an upright capsule of 0.3 m and 1.8 m at 4 m/s on stairs of 0.2 x 0.3 m, over seams, along a tiled wall, into corners",
          "F: reaches the end, sinks at most 5 cm, rises no faster than the stairs", "worst of measured / allowed",
          {{"stairs up", 1, [](Trial& t) { return stairs(t, true); }},
           {"stairs down", 1, [](Trial& t) { return stairs(t, false); }},
           {"stairs down, feet on them", 1, needs_mover},
           {"steps as by a mover", 1, needs_mover},
           {"seam of height fields", 1, seams},
           {"wall of tiles", 1, wall},
           {"corner of 90 deg", 1, [](Trial& t) { return corner(t, 90); }},
           {"corner of 30 deg", 1, [](Trial& t) { return corner(t, 30); }}}};
}

}  // namespace tumble::accuracy
