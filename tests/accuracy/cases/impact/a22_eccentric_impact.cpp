// A ball hits a free rod near its end: the rod takes the impulse as speed and as spin, by its mass and its inertia.
#include "accuracy/scenes.h"

namespace tumble::accuracy {

namespace {

constexpr double kSpeed = 3, kArm = 0.45, kRadius = 0.1;  // m/s, m, m
constexpr double kMass = 2, kLength = 1, kWidth = 0.1;    // of the rod: kg, m, m

Outcome hit(Trial& trial, double e) {
  Simulation& scene = trial.scene({{0, 0, 0}});
  const int lanes = trial.phases();
  std::vector<BodyIndex> balls, rods;
  for (int lane = 0; lane < lanes; ++lane) {
    const double run_up = 0.3 + kSpeed * kFrame * lane / lanes;
    BodyDef def = with(dynamic(ball(kRadius), 1), 0, e);
    def.velocity = {0, -kSpeed, 0};
    balls.push_back(scene.add(def, {{kArm, kWidth / 2 + kRadius + run_up, 2.0 * lane}, {}}));
    rods.push_back(scene.add(with(dynamic(box({kLength, kWidth, kWidth}), kMass), 0, 1), {{0, 0, 2.0 * lane}, {}}));
  }

  const double inertia = kMass * (kLength * kLength + kWidth * kWidth) / 12;
  const double impulse = (1 + e) * kSpeed / (1 + 1 / kMass + kArm * kArm / inertia);
  const double ball_after = trial.reference(impulse - kSpeed), rod_after = trial.reference(-impulse / kMass), spin_after = trial.reference(-impulse * kArm / inertia);
  const double end = ball_after * ball_after / 2 + kMass * rod_after * rod_after / 2 + inertia * spin_after * spin_after / 2;
  Spread error, energies;
  // Each lane is read three frames after its touch, before the rod has turned far.
  run(scene, 0.25, kFrame, [&](double time) {
    for (int lane = 0; lane < lanes; ++lane) {
      const double touch = 0.3 / kSpeed + kFrame * lane / lanes;
      if (std::lround(time / kFrame) != std::lround(std::floor(touch / kFrame + 1e-9)) + 4) continue;
      const BodyIndex ball = balls[static_cast<std::size_t>(lane)], rod = rods[static_cast<std::size_t>(lane)];
      error.add(std::max({distance(scene.velocity(ball), {0, ball_after, 0}), distance(scene.velocity(rod), {0, rod_after, 0}),
                          distance(scene.angular_velocity(rod), {0, 0, spin_after}) * kArm}) / kSpeed);
      energies.add(kinetic_energy(scene, ball) + kinetic_energy(scene, rod));
    }
    return true;
  });

  Outcome outcome;
  outcome.bias = error.mean();
  outcome.worst = outcome.error = error.high;
  outcome.energy_drift = (energies.mean() - end) / (kSpeed * kSpeed / 2);
  return outcome;
}

}  // namespace

Case a22_eccentric_impact() {
  return {"A22", "Eccentric impact", "a ball of 1 kg at 3 m/s hits a free rod of 2 kg and 1 m, 0.45 m from its centre; no friction",
          "F: J = (1 + e) v / (1 + 1/M + a^2/I)", "errors of both velocities and of spin times 0.45 m over 3 m/s, the worst, worst of the phases",
          {{"e 0", 1e-2, [](Trial& t) { return hit(t, 0); }},
           {"e 0.5", 1e-2, [](Trial& t) { return hit(t, 0.5); }},
           {"e 1", 1e-2, [](Trial& t) { return hit(t, 1); }}}};
}

}  // namespace tumble::accuracy
