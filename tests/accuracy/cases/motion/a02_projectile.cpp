// A projectile: range and apex of a thrown ball, without and with damping. Aiming needs them to come out as computed,
// and damping per second must not depend on the step.
#include <algorithm>

#include "accuracy/scenes.h"

namespace tumble::accuracy {

namespace {

constexpr double kSpeed = 20;     // m/s, at 45 degrees
constexpr double kOneStep = 0.12; // m/s more of speed bring the landing a step later: the phases lie between

struct Flight {
  double range = 0, apex = 0;  // m
};

// With damping c: x = (v_x / c)(1 - e^-ct), y = ((v_y + g/c) / c)(1 - e^-ct) - g t / c.
Flight exact(double speed, double c) {
  const double v = speed * std::sqrt(0.5);
  if (c == 0) return {2 * v * v / kGravity, v * v / kGravity / 2};
  const auto height = [=](double t) { return (v + kGravity / c) / c * (1 - std::exp(-c * t)) - kGravity * t / c; };
  const double top = std::log(1 + c * v / kGravity) / c;
  double low = top, high = 2 * v / kGravity;
  for (int i = 0; i < 60; ++i) (height((low + high) / 2) > 0 ? low : high) = (low + high) / 2;
  return {v / c * (1 - std::exp(-c * low)), height(top)};
}

struct Instant {
  Vec3 position, velocity;
};

// Between two steps: the cubic through both places and velocities (Hermite), `u` from 0 to 1.
Vec3 between(const Instant& a, const Instant& b, double h, double u) {
  const double u2 = u * u, u3 = u2 * u;
  return a.position * (2 * u3 - 3 * u2 + 1) + a.velocity * ((u3 - 2 * u2 + u) * h) + b.position * (3 * u2 - 2 * u3) + b.velocity * ((u3 - u2) * h);
}

Flight measured(Simulation& scene, BodyIndex body, double frame) {
  Flight flight;
  Instant before{scene.pose(body).position, scene.velocity(body)};
  run(scene, 4, frame, [&](double) {
    const Instant now{scene.pose(body).position, scene.velocity(body)};
    if (before.velocity.y > 0 && now.velocity.y <= 0)
      for (int i = 0; i <= 1000; ++i) flight.apex = std::max(flight.apex, between(before, now, frame, i / 1000.0).y);
    if (now.position.y <= 0) {
      double low = 0, high = 1;
      for (int i = 0; i < 50; ++i) (between(before, now, frame, (low + high) / 2).y > 0 ? low : high) = (low + high) / 2;
      flight.range = between(before, now, frame, low).x;
      return false;
    }
    before = now;
    return true;
  });
  return flight;
}

Outcome throw_ball(Trial& trial, double damping, double frame) {
  Spread spread;
  for (int phase = 0; phase < trial.phases(); ++phase) {
    const double speed = kSpeed + kOneStep * phase / trial.phases();
    Simulation& scene = trial.scene();
    BodyDef ball_def = dynamic(ball(0.1), 1);
    ball_def.damping = damping;
    ball_def.velocity = Vec3{1, 1, 0} * (speed * std::sqrt(0.5));
    const Flight flight = measured(scene, scene.add(ball_def, {}), frame), truth = exact(speed, damping);
    const double range = flight.range / trial.reference(truth.range) - 1, apex = flight.apex / trial.reference(truth.apex) - 1;
    spread.add(std::abs(range) > std::abs(apex) ? range : apex);
  }
  Outcome outcome;
  outcome.bias = spread.mean();
  outcome.worst = outcome.error = std::max(std::abs(spread.low), std::abs(spread.high));
  return outcome;
}

}  // namespace

Case a02_projectile() {
  Case c{"A02", "Projectile", "a ball is thrown at 20 m/s and 45 degrees, target as high as the start",
         "F: the parabola; with damping c, x = (v_x / c)(1 - e^-ct) and y alike", "the worse of range and apex, over the true one; worst of the phases", {}};
  c.parts = {{"free", 1e-6, [](Trial& t) { return throw_ball(t, 0, kFrame); }},
             {"damping 0.5 /s", 1e-4, [](Trial& t) { return throw_ball(t, 0.5, kFrame); }},
             {"damping 0.5 /s, 240 Hz", 1e-4, [](Trial& t) { return throw_ball(t, 0.5, kFrame / 4); }}};
  return c;
}

}  // namespace tumble::accuracy
