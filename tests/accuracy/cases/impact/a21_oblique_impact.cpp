// Two balls meet off centre: the line of centres at the very touch decides both directions. An engine that makes the
// contact early, or late, turns that line; one that counts the gap against the bounce takes speed.
#include "accuracy/scenes.h"

namespace tumble::accuracy {

namespace {

constexpr double kRadius = 0.5, kSpeed = 4, kOffset = 0.4;  // m, m/s, m

Outcome meet(Trial& trial, double e, std::optional<bool> continuous) {
  Simulation& scene = trial.scene({{0, 0, 0}});
  const int lanes = trial.phases();
  const double reach = std::sqrt(4 * kRadius * kRadius - kOffset * kOffset);  // along x between the centres at the touch
  std::vector<BodyIndex> light, heavy;
  for (int lane = 0; lane < lanes; ++lane) {
    BodyDef def = with(dynamic(ball(kRadius), 1), 0, e);
    def.continuous = continuous;
    def.velocity = {kSpeed, 0, 0};
    light.push_back(scene.add(def, {{-reach - 0.5 - kSpeed * kFrame * lane / lanes, 0, 4.0 * lane}, {}}));
    heavy.push_back(scene.add(with(dynamic(ball(kRadius), 3), 0, 1), {{0, kOffset, 4.0 * lane}, {}}));
  }

  run(scene, 0.25);

  const Vec3 normal{reach, kOffset, 0};  // of length 1, since the diameter is 1 m
  const double impulse = (1 + e) * kSpeed * normal.x * 3 / 4;
  const Vec3 light_after = trial.reference(Vec3{kSpeed, 0, 0} - normal * impulse), heavy_after = trial.reference(normal * (impulse / 3));
  const double energy_after = (dot(light_after, light_after) + 3 * dot(heavy_after, heavy_after)) / 2;
  Spread error, energies;
  for (std::size_t i = 0; i < light.size(); ++i) {
    error.add(std::max(distance(scene.velocity(light[i]), light_after), distance(scene.velocity(heavy[i]), heavy_after)) / kSpeed);
    energies.add(kinetic_energy(scene, light[i]) + kinetic_energy(scene, heavy[i]));
  }
  Outcome outcome;
  outcome.bias = error.mean();
  outcome.worst = outcome.error = error.high;
  outcome.energy_drift = (energies.mean() - energy_after) / (kSpeed * kSpeed / 2);
  return outcome;
}

}  // namespace

Case a21_oblique_impact() {
  Case c{"A21", "Two-body oblique impact", "a ball of 1 kg at 4 m/s meets one of 3 kg at rest, 0.4 m beside its line; no friction",
         "F: J = (1 + e) v n_x 3/4 along the line of centres at the touch", "|velocity - truth| / 4 m/s, the worse ball, worst of the phases", {}};
  for (const auto& [name, e] : {std::pair("e 0", 0.0), {"e 0.5", 0.5}, {"e 1", 1.0}}) {
    c.parts.push_back({name, 1e-2, [e = e](Trial& t) { return meet(t, e, {}); }});
    c.parts.push_back({std::string(name) + ", continuous", 1e-3, [e = e](Trial& t) { return meet(t, e, true); }});
  }
  return c;
}

}  // namespace tumble::accuracy
