// The tennis racket: a free box that spins about its middle axis flips over again and again (Dzhanibekov). Energy and
// angular momentum stay, and the times of the flips follow from Euler's equations; damping hidden in the step shows here.
#include <algorithm>

#include "accuracy/cases/motion/rotation.h"
#include "accuracy/rk4.h"

namespace tumble::accuracy {

namespace {

constexpr Vec3 kSize{2, 4, 6};
constexpr double kMass = 48;
constexpr Vec3 kInertia{kMass / 12 * (4 * 4 + 6 * 6), kMass / 12 * (2 * 2 + 6 * 6), kMass / 12 * (2 * 2 + 4 * 4)};  // 208, 160, 80
constexpr Vec3 kMiddle{0.01, 5, 0.01}, kLargest{5, 0.05, 0.05}, kSmallest{0.05, 0.05, 5};  // rad/s

// A minute; the shortest that sees a flip in a test.
double seconds(Trial& trial) { return trial.shortened(60, trial.effort() == Effort::test ? 6 : 60); }

using Spin = std::array<double, 3>;  // in the body's axes

// Euler's equations of a free body.
Spin euler(const Spin& w) {
  const Vec3 i = kInertia;
  return {(i.y - i.z) * w[1] * w[2] / i.x, (i.z - i.x) * w[2] * w[0] / i.y, (i.x - i.y) * w[0] * w[1] / i.z};
}

struct Truth {
  std::vector<double> flips;  // s
  double middle_share = 0;    // the largest part of the energy that is ever in the middle axis
};

double share(double middle, double energy) { return kInertia.y * middle * middle / 2 / energy; }
double spin_energy(Vec3 w) { return dot(scaled(kInertia, w), w) / 2; }

Truth truth(Vec3 start, double seconds) {
  constexpr double h = 1e-4;
  Truth out;
  Spin w{start.x, start.y, start.z};
  for (long i = 1; i <= std::lround(seconds / h); ++i) {
    const Spin next = rk4(w, h, euler);
    if (next[1] * w[1] < 0) out.flips.push_back((static_cast<double>(i - 1) + w[1] / (w[1] - next[1])) * h);
    out.middle_share = std::max(out.middle_share, share(next[1], spin_energy(start)));
    w = next;
  }
  return out;
}

struct Racket {
  Simulation& scene;
  BodyIndex body;
  Vec3 spin() const { return conjugate(scene.pose(body).rotation) * scene.angular_velocity(body); }
};

Racket make(Trial& trial, Vec3 spin) {
  Simulation& scene = trial.scene({{0, 0, 0}});
  BodyDef def = dynamic(box(kSize), kMass);
  def.angular_velocity = spin;
  return {scene, scene.add(def, {})};
}

Outcome energy_kept(Trial& trial) {
  const Racket racket = make(trial, kMiddle);
  Outcome outcome;
  run(racket.scene, seconds(trial), kFrame, [&](double) {
    const double drift = kinetic_energy(racket.scene, racket.body) / trial.reference(spin_energy(kMiddle)) - 1;
    if (std::abs(drift) >= outcome.error) outcome.energy_drift = drift;
    outcome.error = std::max(outcome.error, std::abs(drift));
    return true;
  });
  return outcome;
}

Outcome momentum_kept(Trial& trial, bool direction) {
  const Racket racket = make(trial, kMiddle);
  const Vec3 start = scaled(kInertia, kMiddle), expected = trial.reference(start);
  Outcome outcome;
  run(racket.scene, seconds(trial), kFrame, [&](double) {
    const Vec3 now = spin_momentum(racket.scene, racket.body);
    const double off = direction ? distance(now, expected) : std::abs(length(now) - length(expected));
    outcome.error = std::max(outcome.error, off / length(start));
    return true;
  });
  return outcome;
}

Outcome flip_times(Trial& trial) {
  const Racket racket = make(trial, kMiddle);
  const double time = seconds(trial);
  std::vector<double> flips;
  double before = kMiddle.y;
  run(racket.scene, time, kFrame, [&](double t) {
    const double now = racket.spin().y;
    if (now * before < 0) flips.push_back(t - kFrame + kFrame * before / (before - now));
    before = now;
    return true;
  });
  const Truth exact = truth(kMiddle, time);
  Outcome outcome;
  for (std::size_t i = 0; i < exact.flips.size(); ++i)
    outcome.error = std::max(outcome.error, i < flips.size() ? relative(flips[i], trial.reference(exact.flips[i])) : 1);
  if (flips.size() < exact.flips.size()) outcome.failed = std::to_string(flips.size()) + " flips of " + std::to_string(exact.flips.size());
  return outcome;
}

// About the axes of largest and smallest inertia a spin is stable: nothing may creep into the middle one.
Outcome stable(Trial& trial, Vec3 spin) {
  const Racket racket = make(trial, spin);
  const double time = seconds(trial), total = spin_energy(spin), most = truth(spin, std::min(time, 10.0)).middle_share;
  Outcome outcome;
  run(racket.scene, time, kFrame, [&](double) {
    const double drift = kinetic_energy(racket.scene, racket.body) / trial.reference(total) - 1;
    outcome.energy_drift = drift;
    outcome.error = std::max({outcome.error, std::abs(drift), share(racket.spin().y, total) - most});
    return true;
  });
  return outcome;
}

}  // namespace

Case a09_tennis_racket() {
  Case c{"A09", "Tennis racket", "a free box of 2 x 4 x 6 m, 48 kg, spins at 5 rad/s about its middle axis for 60 s",
         "C: energy and angular momentum; R: flips by Euler's equations", "largest deviation over the whole; flip times over the true ones", {}};
  c.parts = {{"energy", 1e-3, energy_kept},
             {"size of L", 1e-5, [](Trial& t) { return momentum_kept(t, false); }},
             {"vector L", 1e-5, [](Trial& t) { return momentum_kept(t, true); }},
             {"flip times", 1e-2, flip_times},
             {"about the largest", 1e-3, [](Trial& t) { return stable(t, kLargest); }},
             {"about the smallest", 1e-3, [](Trial& t) { return stable(t, kSmallest); }}};
  return c;
}

}  // namespace tumble::accuracy
