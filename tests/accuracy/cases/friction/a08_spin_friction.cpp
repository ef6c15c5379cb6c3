// A box that spins on the spot: how fast friction stops it depends on where the contact carries the weight. Four corner
// points brake 1.85 times as strongly as an even pressure, at any step size: an error of the model.
#include "accuracy/cases/friction/sliding.h"

namespace tumble::accuracy {

namespace {

constexpr double kHalf = 1, kMass = 1, kSpin = 10, kFriction = 0.2, kSeconds = 1;  // m, kg, rad/s, -, s
constexpr double kInertia = kMass * (2 * kHalf) * (2 * kHalf) / 6;

// The mean distance from the centre of a square of half side 1: (sqrt 2 + asinh 1) / 3 = 0.765196.
const double kUniform = (std::sqrt(2.0) + std::asinh(1.0)) / 3, kCorners = std::sqrt(2.0);

Outcome spin_down(Trial& trial, double arm) {
  Simulation& scene = trial.scene();
  add_floor(scene);
  BodyDef def = with(dynamic(box(Vec3{1, 1, 1} * (2 * kHalf)), kMass), kFriction);
  def.angular_velocity = {0, kSpin, 0};
  const BodyIndex body = scene.add(def, {{0, kHalf, 0}, {}});

  run(scene, kSeconds, kFrame);

  const double loss = trial.reference(arm * kHalf * kFriction * kMass * kGravity / kInertia * kSeconds);
  Outcome outcome;
  outcome.error = relative(kSpin - scene.angular_velocity(body).y, loss);
  return outcome;
}

}  // namespace

Case a08_spin_friction() {
  Case c{"A08", "Spin friction", "a cube of 2 m, 1 kg, spins at 10 rad/s on a floor, friction 0.2, for 1 s", "F: mu m g times the mean arm of an even pressure, 0.7652 of half the side",
         "|loss of spin - true| / true; the row of the four corners tells which model it is", {}};
  c.parts = {{"even pressure", 0.02, [](Trial& t) { return spin_down(t, kUniform); }},
             {"four corners", 1, [](Trial& t) { return spin_down(t, kCorners); }}};  // told, not asked for
  return c;
}

}  // namespace tumble::accuracy
