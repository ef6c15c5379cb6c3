// A box that slides and spins at once: friction acts against each point's own velocity, so a spinning box brakes less and
// slides further, and both motions end together. Friction at one point, or at each corner, stops it too early.
#include <algorithm>

#include "accuracy/cases/friction/sliding.h"
#include "accuracy/rk4.h"

namespace tumble::accuracy {

namespace {

constexpr double kSide = 1, kLow = 0.1, kFriction = 0.5;  // m; low, so that braking hardly shifts its weight

struct Motion {
  double way = 0, turn = 0;  // m, rad
};

using State = std::array<double, 6>;  // x, z, turn about y, and their rates

// An even pressure over the square, by midpoints; per mass.
State rates(const State& s) {
  constexpr int n = 32;
  const double cosine = std::cos(s[2]), sine = std::sin(s[2]);
  double fx = 0, fz = 0, torque = 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double a = kSide * ((i + 0.5) / n - 0.5), b = kSide * ((j + 0.5) / n - 0.5);
      const double x = cosine * a + sine * b, z = cosine * b - sine * a;
      const double vx = s[3] + s[5] * z, vz = s[4] - s[5] * x, speed = std::sqrt(vx * vx + vz * vz);
      if (speed < 1e-9) continue;
      fx -= vx / speed;
      fz -= vz / speed;
      torque -= (z * vx - x * vz) / speed;
    }
  const double each = kFriction * kGravity / (n * n), inertia = kSide * kSide / 6;
  return {s[3], s[4], s[5], fx * each, fz * each, torque * each / inertia};
}

// Until it stands; what is left below a step's worth of braking moves it by less than 1e-6 m.
Motion exact(double speed, double spin) {
  constexpr double h = 2e-3;  // as fine as 1e-4 to seven digits; the midpoints leave 4e-4
  State state{0, 0, 0, speed, 0, spin};
  while (std::hypot(state[3], state[4]) + std::abs(state[5]) > 2 * kFriction * kGravity * h) state = rk4(state, h, rates);
  return {std::hypot(state[0], state[1]), state[2]};
}

Motion measured(Trial& trial, double speed, double spin) {
  Simulation& scene = trial.scene();
  add_floor(scene);
  BodyDef def = with(dynamic(box({kSide, kLow, kSide}), 2), kFriction);
  def.velocity = {speed, 0, 0};
  def.angular_velocity = {0, spin, 0};
  const BodyIndex body = scene.add(def, {{0, kLow / 2, 0}, {}});
  Motion out;
  double before = 0;
  run(scene, 3, kFrame, [&](double) {
    const double now = yaw(scene, body);
    out.turn += std::remainder(now - before, 2 * kPi);
    before = now;
    return true;
  });
  out.way = length(level(scene.pose(body).position));
  return out;
}

Outcome slid(Trial& trial, double speed, double spin) {
  Outcome outcome;
  outcome.error = relative(measured(trial, speed, spin).way, trial.reference(exact(speed, spin).way));
  return outcome;
}

Outcome turned(Trial& trial, double speed, double spin) {
  Outcome outcome;
  outcome.error = relative(measured(trial, speed, spin).turn, trial.reference(exact(speed, spin).turn));
  return outcome;
}

}  // namespace

Case s06_slide_with_spin() {
  Case c{"S06", "Slide with spin", "a box of 1 x 0.1 x 1 m, 2 kg, friction 0.5, slides and spins to its stop", "R: an even pressure over the square, integrated",
         "|way - true| / true, |angle - true| / true", {}};
  for (const auto& [speed, spin] : {std::pair{3.0, 5.0}, {3.0, 15.0}}) {
    const std::string name = ", " + std::to_string(static_cast<int>(speed)) + " m/s and " + std::to_string(static_cast<int>(spin)) + " rad/s";
    c.parts.push_back({"way" + name, 0.02, [speed = speed, spin = spin](Trial& t) { return slid(t, speed, spin); }});
    c.parts.push_back({"turn" + name, 0.02, [speed = speed, spin = spin](Trial& t) { return turned(t, speed, spin); }});
  }
  return c;
}

}  // namespace tumble::accuracy
