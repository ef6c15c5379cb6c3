// Newton's cradle: of five equal balls the first hits, and only the last leaves. Taken as one simultaneous collision with
// restitution, the same laws of conservation also allow every ball to move on; what is seen is one impact after another.
#include "accuracy/scenes.h"

namespace tumble::accuracy {

namespace {

constexpr int kBalls = 5;
constexpr double kRadius = 0.5, kSpeed = 2;  // m, m/s

Outcome line(Trial& trial, double gap) {
  Simulation& scene = trial.scene({{0, 0, 0}});
  const int lanes = trial.phases();
  std::vector<BodyIndex> balls;
  for (int lane = 0; lane < lanes; ++lane)
    for (int i = 0; i < kBalls; ++i) {
      BodyDef def = with(dynamic(ball(kRadius), 1), 0, 1);
      if (i == 0) def.velocity = {kSpeed, 0, 0};
      const double run_up = i == 0 ? 0.3 + kSpeed * kFrame * lane / lanes : gap;
      balls.push_back(scene.add(def, {{i * (2 * kRadius + gap) - run_up, 0, 3.0 * lane}, {}}));
    }

  run(scene, 0.6);

  Spread error, energies;
  for (int lane = 0; lane < lanes; ++lane) {
    double square = 0, energy_sum = 0;
    for (int i = 0; i < kBalls; ++i) {
      const BodyIndex body = balls[static_cast<std::size_t>(lane * kBalls + i)];
      const double off = distance(scene.velocity(body), {i == kBalls - 1 ? trial.reference(kSpeed) : 0, 0, 0});
      square += off * off;
      energy_sum += kinetic_energy(scene, body);
    }
    error.add(std::sqrt(square) / kSpeed);
    energies.add(energy_sum / (kSpeed * kSpeed / 2));
  }
  Outcome outcome;
  outcome.bias = error.mean();
  outcome.worst = outcome.error = error.high;
  outcome.energy_drift = energies.mean() - 1;
  return outcome;
}

// Angle and its speed of a pendulum, by Runge and Kutta.
struct Swing {
  double angle = 0, speed = 0;
};
Swing swing(Swing now, double pull, double seconds) {
  constexpr double h = 1e-4;
  const auto slope = [pull](Swing s) { return Swing{s.speed, -pull * std::sin(s.angle)}; };
  const auto ahead = [](Swing s, Swing d, double by) { return Swing{s.angle + d.angle * by, s.speed + d.speed * by}; };
  for (long i = std::lround(seconds / h); i > 0; --i) {
    const Swing a = slope(now), b = slope(ahead(now, a, h / 2)), c = slope(ahead(now, b, h / 2)), d = slope(ahead(now, c, h));
    now = ahead(ahead(ahead(ahead(now, a, h / 6), b, h / 3), c, h / 3), d, h / 6);
  }
  return now;
}

// On rods 2 m long, let go at 0.5 rad. The first and the last ball share one pendulum's motion, each on its side.
Outcome pendulums(Trial& trial) {
  constexpr double rod = 2, seconds = 5, pull = kGravity * rod / (rod * rod + 0.4 * kRadius * kRadius);
  constexpr Swing start{-0.5, 0};
  Simulation& scene = trial.scene();
  std::vector<BodyIndex> balls;
  double before = 0;
  for (int i = 0; i < kBalls; ++i) {
    const Quat turn = axis_angle({0, 0, 1}, i == 0 ? start.angle : 0);
    balls.push_back(scene.add(with(dynamic(ball(kRadius), 1), 0, 1), {Vec3{2 * kRadius * i, 0, 0} + turn * Vec3{0, -rod, 0}, turn}));
    scene.add(joint(balls.back(), kWorld, {0, rod, 0}, HingeDef{}, {0, 0, 1}));
    before += energy(scene, balls.back());
  }

  run(scene, seconds);

  const Swing truth = swing(start, pull, seconds);
  const std::size_t moving = truth.angle < 0 ? 0 : kBalls - 1;
  double square = 0, end = 0;
  for (std::size_t i = 0; i < kBalls; ++i) {
    const double along = i == moving ? trial.reference(truth.speed) * rod : 0;
    const Vec3 expected = Vec3{std::cos(truth.angle), std::sin(truth.angle), 0} * along;
    square += std::pow(distance(scene.velocity(balls[i]), expected), 2);
    end += energy(scene, balls[i]);
  }
  const double height = rod * (1 - std::cos(start.angle)), fastest = rod * std::sqrt(2 * pull * (1 - std::cos(start.angle)));
  Outcome outcome;
  outcome.error = std::sqrt(square) / fastest;
  outcome.energy_drift = (end - before) / (kGravity * height);
  return outcome;
}

}  // namespace

Case a20_cradle() {
  return {"A20", "Newton's cradle", "five balls of 1 kg in a row, hit by the first at 2 m/s; five pendulums for 5 s",
          "F: the last one leaves with all the speed; R: pendulum by RK4", "norm of the velocities' errors over the first ball's speed, worst of the phases",
          {{"gaps of 1 mm", 0.02, [](Trial& t) { return line(t, 1e-3); }},
           {"touching", 0.1, [](Trial& t) { return line(t, 0); }},
           {"pendulums", 0.1, pendulums}}};
}

}  // namespace tumble::accuracy
