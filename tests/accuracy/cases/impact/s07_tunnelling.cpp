// Tunnelling: the share of balls, boxes and capsules that go through a wall of 1 cm, as fast bodies of a game do, with
// nothing said of them; and what bounces back though it should not.
#include "accuracy/cases/impact/volley.h"

namespace tumble::accuracy {

namespace {

Hits fire_sixty(Trial& trial, double speed, std::size_t& tries) {
  Chance chance(7);
  std::vector<Shot> shots;
  const int phases = std::min(20, trial.phases());
  for (int i = 0; i < phases; ++i)
    for (const Shape& shape : {ball(0.1), box({0.2, 0.2, 0.2}), upright(ShapeKind::capsule, 0.1, 0.4)})
      shots.push_back({dynamic(shape, 1), chance.between(-0.5, 0.5), static_cast<double>(i) / phases});
  tries = shots.size();
  return fire(trial, shots, speed);
}

Outcome share(Trial& trial, double speed) {
  std::size_t tries = 0;
  const Hits hits = fire_sixty(trial, speed, tries);
  Outcome outcome;
  outcome.failed = hits.failed;
  outcome.error = static_cast<double>(hits.through) / static_cast<double>(tries);
  return outcome;
}

Outcome rebound(Trial& trial, double speed) {
  std::size_t tries = 0;
  const Hits hits = fire_sixty(trial, speed, tries);
  Outcome outcome;
  outcome.failed = hits.failed;
  // Both speeds together, so that none has a reference to miss.
  outcome.error = trial.reference(1 + hits.rebound) - 1;
  if (hits.through == static_cast<int>(tries)) outcome.failed = "all went through";
  return outcome;
}

}  // namespace

Case s07_tunnelling() {
  Case c{"S07", "Tunnelling", "60 balls, boxes and capsules of 0.2 m at up to 30 degrees against walls of 1 cm", "none goes through, and with e = 0 none comes back",
         "share that goes through; rebound: largest speed away from the wall over the speed of the shot", {}};
  for (const int speed : {10, 25, 50, 100, 200, 400}) {
    const std::string name = std::to_string(speed) + " m/s";
    c.parts.push_back({name, 1e-6, [speed](Trial& t) { return share(t, speed); }});
    c.parts.push_back({"rebound, " + name, 1e-3, [speed](Trial& t) { return rebound(t, speed); }});
  }
  return c;
}

}  // namespace tumble::accuracy
