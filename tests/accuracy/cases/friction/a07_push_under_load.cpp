// SimBenchmark's "rolling": a box that slides over the ground under 25 balls is pushed by a force that fits no axis of
// the solver. Everything rolls and slides at constant acceleration, known exactly.
#include <algorithm>

#include "accuracy/cases/friction/sliding.h"

namespace tumble::accuracy {

namespace {

constexpr double kBox = 10, kBall = 1, kForce = 150, kFrame1k = 1e-3;  // kg, kg, N, s
constexpr int kSide = 5, kBalls = kSide * kSide;
constexpr double kGround = 0.4, kOnTop = 0.8;  // friction

// A ball rolls without slip on the box: friction f on it gives a = f / m and 5/2 of that at its rim, so that the box
// runs from under it at 7/2 f / m.
constexpr double kDrag = kGround * (kBox + kBalls * kBall) * kGravity;
constexpr double kOnBall = (kForce - kDrag) / (3.5 * kBox / kBall + kBalls);
constexpr double kBoxRate = (kForce - kDrag - kBalls * kOnBall) / kBox, kBallRate = kOnBall / kBall;  // 0.7385, 0.2110 m/s^2

Outcome push(Trial& trial, double azimuth) {
  const double seconds = trial.shortened(4, trial.effort() == Effort::test ? 0.04 : 0.4);
  const Vec3 direction = on_floor(azimuth);
  Simulation& scene = trial.scene();
  add_floor(scene, 60);
  const BodyIndex pushed = scene.add(with(dynamic(box({20, 1, 20}), kBox), kGround), {{0, 0.5, 0}, {}});
  std::vector<BodyIndex> balls;
  for (int i = 0; i < kBalls; ++i)
    balls.push_back(scene.add(with(dynamic(ball(0.5), kBall), kOnTop / kGround), {{2.0 * (i % kSide - 2), 1.5, 2.0 * (i / kSide - 2)}, {}}));

  double squares = 0;
  long samples = 0;
  const auto note = [&](BodyIndex body, double expected) {
    const Vec3 off = scene.velocity(body) - direction * trial.reference(expected);
    squares += dot(off, off);
    ++samples;
  };
  scene.apply_force(pushed, direction * kForce);
  run(scene, seconds, kFrame1k, [&](double t) {
    note(pushed, kBoxRate * t);
    for (const BodyIndex body : balls) note(body, kBallRate * t);
    scene.apply_force(pushed, direction * kForce);
    return true;
  });

  Outcome outcome;
  outcome.error = std::sqrt(squares / static_cast<double>(samples)) / (kBoxRate * seconds);
  return outcome;
}

}  // namespace

Case a07_push_under_load() {
  Case c{"A07", "Push under load", "25 balls of 1 kg lie on a box of 10 kg that 150 N push over the ground, friction 0.8 and 0.4, 4 s at 1 kHz",
         "F: box 0.7385, balls 0.2110 m/s^2", "RMS of the velocities' errors over the box's last speed", {}};
  c.parts = {{"60 degrees", 1e-3, [](Trial& t) { return push(t, radians(60)); }}, {"90 degrees", 1e-3, [](Trial& t) { return push(t, radians(90)); }}};
  return c;
}

}  // namespace tumble::accuracy
