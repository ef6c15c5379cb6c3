// A gas of spheres: what many frictionless collisions do to momentum, angular momentum and energy.
//
// Each collision's error is small and has a sign; over a hundred of them a scene heats up or cools down visibly. Restitution
// that is taken from stale gaps, or overlap repaired with speed, shows here as energy from nowhere.
#include "accuracy/scenes.h"

namespace tumble::accuracy {

namespace {

constexpr double kSeconds = 2;

struct Totals {
  Vec3 momentum, angular_momentum;
  double energy = 0, momenta = 0, angular_momenta = 0;  // the last two: sums of the bodies' amounts
};

Totals totals(const Simulation& scene, const std::vector<BodyIndex>& bodies, Vec3 gravity) {
  Totals sum;
  for (const BodyIndex body : bodies) {
    const Vec3 p = momentum(scene, body), l = angular_momentum(scene, body);
    sum.momentum += p;
    sum.angular_momentum += l;
    sum.momenta += length(p);
    sum.angular_momenta += length(l);
    sum.energy += energy(scene, body, gravity);
  }
  return sum;
}

// 64 balls of 1, 2 and 3 kg on a grid, each with a velocity of its own, no gravity.
std::vector<BodyIndex> add_gas(Simulation& scene, double e) {
  Chance chance(19);
  std::vector<BodyIndex> balls;
  for (int i = 0; i < 64; ++i) {
    BodyDef def = with(dynamic(ball(0.25), 1 + i % 3), 0, std::sqrt(e));  // of a pair: e
    def.velocity = {chance.between(-2, 2), chance.between(-2, 2), chance.between(-2, 2)};
    balls.push_back(scene.add(def, {Vec3(i % 4, i / 4 % 4, i / 16) * 0.8, {}}));
  }
  return balls;
}

enum class Kept { momentum, angular_momentum, energy };

Outcome elastic(Trial& trial, Kept kept) {
  Simulation& scene = trial.scene({{0, 0, 0}});
  const std::vector<BodyIndex> balls = add_gas(scene, 1);
  const Totals start = totals(scene, balls, {});

  run(scene, kSeconds);

  const Totals end = totals(scene, balls, {});
  Outcome outcome;
  outcome.energy_drift = end.energy / start.energy - 1;
  if (kept == Kept::energy) outcome.error = relative(end.energy, trial.reference(start.energy), start.energy);
  if (kept == Kept::momentum) outcome.error = distance(end.momentum, trial.reference(start.momentum)) / start.momenta;
  if (kept == Kept::angular_momentum) outcome.error = distance(end.angular_momentum, trial.reference(start.angular_momentum)) / start.angular_momenta;
  return outcome;
}

// With e = 0.5 energy only falls: the error is its largest rise in a step.
Outcome inelastic(Trial& trial) {
  Simulation& scene = trial.scene({{0, 0, 0}});
  const std::vector<BodyIndex> balls = add_gas(scene, 0.5);
  const double start = totals(scene, balls, {}).energy;
  double before = start, rise = 0;

  run(scene, kSeconds, kFrame, [&](double) {
    const double now = totals(scene, balls, {}).energy;
    rise = std::max(rise, (trial.reference(now) - before) / start);
    before = now;
    return true;
  });

  Outcome outcome;
  outcome.error = rise;
  outcome.energy_drift = before / start - 1;
  return outcome;
}

// SimBenchmark's 666: 6 x 6 x 6 balls, slightly out of line, fall together on a floor.
Outcome elastic_666(Trial& trial) {
  Simulation& scene = trial.scene();
  add_floor(scene, 400);  // they fly far
  Chance chance(42);
  std::vector<BodyIndex> balls;
  for (int i = 0; i < 216; ++i) {
    const Vec3 off{chance.between(-1e-3, 1e-3), chance.between(-1e-3, 1e-3), chance.between(-1e-3, 1e-3)};
    balls.push_back(scene.add(with(dynamic(ball(0.1), 10), 0, 1), {Vec3(i % 6 - 2.5, i / 36, i / 6 % 6 - 2.5) * 0.21 + Vec3{0, 1.1, 0} + off, {}}));
  }
  const Vec3 gravity{0, -kGravity, 0};
  const double start = totals(scene, balls, gravity).energy;

  run(scene, trial.shortened(10, trial.effort() == Effort::test ? 0.5 : 1.5));

  const double end = totals(scene, balls, gravity).energy;
  Outcome outcome;
  outcome.error = relative(end, trial.reference(start), start);
  outcome.energy_drift = end / start - 1;
  return outcome;
}

}  // namespace

Case a19_gas() {
  return {"A19", "Gas of spheres", "64 balls of 1 to 3 kg without gravity or friction for 2 s; 216 balls that fall on a floor",
          "C: momentum, angular momentum and energy", "change over the sum of the bodies' amounts; e 0.5: largest rise of energy in a step",
          {{"energy", 1e-3, [](Trial& t) { return elastic(t, Kept::energy); }},
           {"momentum", 1e-6, [](Trial& t) { return elastic(t, Kept::momentum); }},
           {"angular momentum", 1e-5, [](Trial& t) { return elastic(t, Kept::angular_momentum); }},
           {"energy, e 0.5", 1e-6, inelastic},
           {"666, energy", 1e-3, elastic_666}}};
}

}  // namespace tumble::accuracy
