// Rolling: down a slope with grip and just without, and a billiard ball that slides until it rolls. Joins friction with
// inertia: both must be right, and rolling itself must cost nothing.
#include <algorithm>

#include "accuracy/cases/friction/sliding.h"

namespace tumble::accuracy {

namespace {

constexpr double kRadius = 0.5, kSlope = radians(20), kSeconds = 2;

struct Wheel {
  Simulation& scene;
  BodyIndex body;
  double speed() const { return scene.velocity(body).x; }
  double rim_speed() const { return -scene.angular_velocity(body).z * kRadius; }
};

// It rolls along x; a cylinder lies across.
Wheel make(Trial& trial, const Shape& shape, Vec3 gravity, double friction, double speed, std::optional<Vec3> inertia = {}) {
  Simulation& scene = trial.scene({gravity});
  add_floor(scene);
  BodyDef def = with(dynamic(shape, 1), friction);
  def.velocity = {speed, 0, 0};
  def.inertia = inertia;
  return {scene, scene.add(def, {{0, kRadius, 0}, axis_angle({1, 0, 0}, kPi / 2)})};
}

double least_friction(double k) { return k * std::tan(kSlope) / (1 + k); }

// I = k m r^2. With grip a = g sin / (1 + k), and the rim keeps up; without, a = g (sin - mu cos) and the rim lags.
Outcome roll(Trial& trial, const Shape& shape, double k, double friction, std::optional<Vec3> inertia = {}) {
  const bool grips = friction > least_friction(k);
  const double along = kGravity * (grips ? std::sin(kSlope) / (1 + k) : std::sin(kSlope) - friction * std::cos(kSlope));
  const double rim = grips ? along : friction * kGravity * std::cos(kSlope) / k;
  const Wheel wheel = make(trial, shape, on_slope(kSlope), friction, 0, inertia);

  run(wheel.scene, kSeconds, kFrame);

  Outcome outcome;
  outcome.error = std::max(relative(wheel.speed(), trial.reference(along * kSeconds)), relative(wheel.rim_speed(), trial.reference(rim * kSeconds)));
  return outcome;
}

// 7 m/s and no spin: rolls at 5/7 of it from 2 v / (7 mu g) on.
constexpr double kShot = 7, kCloth = 0.4;

Outcome billiard_speed(Trial& trial) {
  const Wheel wheel = make(trial, ball(kRadius), {0, -kGravity, 0}, kCloth, kShot);
  run(wheel.scene, 1, kFrame);
  Outcome outcome;
  const double slip = std::abs(wheel.speed() - wheel.rim_speed()) / kShot;
  outcome.error = std::max(relative(wheel.speed(), trial.reference(kShot * 5 / 7)), slip);
  return outcome;
}

Outcome billiard_way(Trial& trial) {
  const Wheel wheel = make(trial, ball(kRadius), {0, -kGravity, 0}, kCloth, kShot);
  run(wheel.scene, 1, kFrame);
  const double rolls_at = 2 * kShot / (7 * kCloth * kGravity), rolls_from = 12 * kShot * kShot / (49 * kCloth * kGravity);
  Outcome outcome;
  outcome.error = relative(wheel.scene.pose(wheel.body).position.x, trial.reference(rolls_from + kShot * 5 / 7 * (1 - rolls_at)));
  return outcome;
}

// All mass at the rim: 2/3 m r^2 of a shell; of a hoop m r^2 about its axis, half across.
constexpr double kRim = kRadius * kRadius;
Outcome shell(Trial& trial) { return roll(trial, ball(kRadius), 2.0 / 3, 0.5, Vec3{1, 1, 1} * (kRim * 2 / 3)); }
Outcome hoop(Trial& trial) { return roll(trial, upright(ShapeKind::cylinder, kRadius, 0.05), 1, 0.5, Vec3{kRim / 2, kRim, kRim / 2}); }

}  // namespace

Case a06_rolling() {
  Case c{"A06", "Rolling", "round bodies of 0.5 m, 1 kg, from rest down 20 degrees for 2 s; a ball shot at 7 m/s over friction 0.4 for 1 s",
         "F: a = g sin / (1 + k) with grip, g (sin - mu cos) without; a ball rolls at 5/7 of its speed", "the worse of speed and rim speed over the true one; way over the true one", {}};
  const struct {
    const char* name;
    Shape shape;
    double k;
  } kinds[] = {{"ball", ball(kRadius), 0.4}, {"cylinder", upright(ShapeKind::cylinder, kRadius, 1), 0.5}};
  for (const auto& [name, shape, k] : kinds) {
    const std::string start = name;
    c.parts.push_back({start + ", grip", 1e-3, [shape = shape, k = k](Trial& t) { return roll(t, shape, k, 0.5); }});
    c.parts.push_back({start + ", 1.1 of least grip", 1e-3, [shape = shape, k = k](Trial& t) { return roll(t, shape, k, 1.1 * least_friction(k)); }});
    c.parts.push_back({start + ", 0.9 of least grip", 1e-3, [shape = shape, k = k](Trial& t) { return roll(t, shape, k, 0.9 * least_friction(k)); }});
  }
  c.parts.push_back({"thin shell", 1e-3, shell});
  c.parts.push_back({"hoop", 1e-3, hoop});
  c.parts.push_back({"billiard, speed", 1e-3, billiard_speed});
  c.parts.push_back({"billiard, way", 1e-3, billiard_way});
  return c;
}

}  // namespace tumble::accuracy
