// The double pendulum: two joints that drive each other. Its first seconds can be computed; later it is chaotic, and
// only its energy can be judged. Most engines lose it within the minute, and a few gain.
#include "accuracy/cases/joints/mechanisms.h"

#include <array>

namespace tumble::accuracy {

namespace {

using State = std::array<double, 4>;  // both angles from straight down, both speeds

// Lagrange's equations of two rods of 1 m and 1 kg.
State slope(const State& s) {
  const double sine = std::sin(s[0] - s[1]), cosine = std::cos(s[0] - s[1]);
  const double m11 = kRodInertia + 0.25 + 1, m12 = 0.5 * cosine, m22 = kRodInertia + 0.25;
  const double f1 = -0.5 * sine * s[3] * s[3] - 1.5 * kGravity * std::sin(s[0]), f2 = 0.5 * sine * s[2] * s[2] - 0.5 * kGravity * std::sin(s[1]);
  const double determinant = m11 * m22 - m12 * m12;
  return {s[2], s[3], (m22 * f1 - m12 * f2) / determinant, (m11 * f2 - m12 * f1) / determinant};
}

State plus(const State& s, const State& slope, double h) {
  State out;
  for (std::size_t i = 0; i < 4; ++i) out[i] = s[i] + h * slope[i];
  return out;
}

// Centre of the second rod against the pivot after so long, from a horizontal start: Runge-Kutta at 1e-4 s.
Vec3 true_center(double seconds) {
  constexpr double h = 1e-4;
  State s{kPi / 2, kPi / 2, 0, 0};
  for (long i = std::lround(seconds / h); i > 0; --i) {
    const State a = slope(s), b = slope(plus(s, a, h / 2)), c = slope(plus(s, b, h / 2)), d = slope(plus(s, c, h));
    for (std::size_t k = 0; k < 4; ++k) s[k] += h / 6 * (a[k] + 2 * b[k] + 2 * c[k] + d[k]);
  }
  return {std::sin(s[0]) + 0.5 * std::sin(s[1]), -std::cos(s[0]) - 0.5 * std::cos(s[1]), 0};
}

const Vec3 kPivot{0, 10, 0};

std::vector<BodyIndex> build(Mechanism& mechanism, const JointKind& kind) {
  return mechanism.chain({kPivot, kPivot + Vec3{1, 0, 0}, kPivot + Vec3{2, 0, 0}}, rod(), kind);
}

Outcome path(Trial& trial, const JointKind& kind, double seconds) {
  Simulation& scene = trial.scene();
  Mechanism mechanism(scene);
  const BodyIndex last = build(mechanism, kind).back();

  run(scene, seconds);

  Outcome outcome;
  outcome.error = distance(center(scene, last) - kPivot, trial.reference(true_center(seconds)));
  outcome.max_joint_gap = mechanism.gap();
  return outcome;
}

}  // namespace

Case a13_double_pendulum() {
  Case c{"A13", "Double pendulum", "two rods of 1 m end to end, released horizontally",
         "R: Runge-Kutta in both angles, 1e-4 s; C: energy of 60 s", "way of the second rod's centre from the truth / 1 m; |energy - start| / (m g 1 m), worst, and gain alone", {}};
  for (const auto& [name, kind] : {std::pair<std::string, JointKind>{"hinges", HingeDef{}}, {"balls", BallDef{}}}) {
    for (const int seconds : {1, 2})
      c.parts.push_back({name + " at " + std::to_string(seconds) + " s", 1e-2, [=](Trial& t) { return path(t, kind, seconds); }});
    const auto keep = [=](bool gain) {
      return [=](Trial& t) {
        Simulation& scene = t.scene();
        Mechanism mechanism(scene);
        build(mechanism, kind);
        return keep_energy(t, scene, mechanism, kGravity, span(t, 60, 6, 1.5), gain);
      };
    };
    c.parts.push_back({name + " energy", 5e-3, keep(false)});
    c.parts.push_back({name + " energy gain", 1e-3, keep(true)});
  }
  return c;
}

}  // namespace tumble::accuracy
