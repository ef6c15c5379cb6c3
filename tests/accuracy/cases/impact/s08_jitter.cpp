// A heap under jittering steps: what was solved for one length of step must not be put into another as it is. With
// impulses carried over from 1/60 s to 1/12 s a heap throws its boxes up for ever.
#include "accuracy/cases/impact/room.h"

namespace tumble::accuracy {

namespace {

constexpr double kMost = 0.005;  // energy gained, of what there is

Outcome shake(Trial& trial) {
  Simulation& scene = trial.scene();
  add_floor(scene);
  add_walls(scene, 3, 8);
  Chance chance(8);
  std::vector<BodyIndex> bodies;
  for (int i = 0; i < 225; ++i) {
    const Shape shape = i % 2 == 0 ? box({0.5, 0.5, 0.5}) : ball(0.25);
    const Vec3 at = Vec3(i % 5 - 2, 0, i / 5 % 5 - 2) * 0.55 + Vec3{chance.between(-0.02, 0.02), 0.3 + 0.52 * (i / 25), chance.between(-0.02, 0.02)};
    bodies.push_back(scene.add(with(dynamic(shape, 1), 0.5), {at, {}}));
  }
  const auto total = [&] {
    double sum = 0;
    for (const BodyIndex body : bodies) sum += energy(scene, body);
    return sum;
  };
  const bool test = trial.effort() == Effort::test;
  run(scene, trial.shortened(5, test ? 0.2 : 0.6));  // it settles

  const double start = total();
  double most = start, fastest = 0;
  Outcome outcome;
  for (long i = std::lround(trial.shortened(20, test ? 0.2 : 1.5) / 0.1); i > 0 && outcome.failed.empty(); --i)
    for (const double step : {1.0 / 60, 1.0 / 12}) {
      scene.step(step);
      most = std::max(most, total());
      for (const BodyIndex body : bodies) {
        fastest = std::max(fastest, length(scene.velocity(body)));
        if (!finite(scene, body)) outcome.failed = "not finite";
      }
    }

  outcome.energy_drift = most / start - 1;
  outcome.error = (trial.reference(most) / start - 1) / kMost;
  // Nothing falls from higher than 5 m, which gives 9.9 m/s.
  if (outcome.failed.empty() && fastest > 10) outcome.failed = "a body reached " + std::to_string(std::lround(fastest)) + " m/s";
  return outcome;
}

}  // namespace

Case s08_jitter() {
  return {"S08", "Heap under jittering steps", "225 boxes and balls between walls 3 m apart; steps of 1/60 s and 1/12 s in turns", "C: energy does not rise",
          "largest rise of the energy over what there was, over 0.5 %", {{"", 1, shake}}};
}

}  // namespace tumble::accuracy
