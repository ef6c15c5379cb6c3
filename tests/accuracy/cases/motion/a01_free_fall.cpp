// Free fall: how far a discrete step is from the parabola. Semi-implicit Euler lags by a t h / 2, so h / t of the way.
#include "accuracy/scenes.h"

namespace tumble::accuracy {

namespace {

constexpr double kSeconds = 2;

Outcome fall(Trial& trial, double frame) {
  Simulation& scene = trial.scene();
  const BodyIndex body = scene.add(dynamic(ball(0.5), 1), {{0, 1000, 0}, {}});

  run(scene, kSeconds, frame);

  const double way = trial.reference(kGravity * kSeconds * kSeconds / 2);
  Outcome outcome;
  outcome.error = relative(1000 - scene.pose(body).position.y, way);
  outcome.energy_drift = energy(scene, body) / (kGravity * 1000) - 1;
  return outcome;
}

}  // namespace

Case a01_free_fall() {
  Case c{"A01", "Free fall", "a ball of 1 kg falls from rest for 2 s", "F: y = g t^2 / 2", "|way - g t^2 / 2| / way", {}};
  for (const int rate : {30, 60, 120, 240, 480})
    c.parts.push_back({std::to_string(rate) + " Hz", 1e-6, [rate](Trial& t) { return fall(t, 1.0 / rate); }});
  return c;
}

}  // namespace tumble::accuracy
