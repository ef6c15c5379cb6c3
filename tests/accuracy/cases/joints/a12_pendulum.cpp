// The pendulum: a joint's rows, the lever that they act on, and what they lose, at amplitudes up to nearly upside down.
//
// A rod on a hinge and on a ball joint, and a small bob, whose inertia is a thousandth of what its joint feels: there
// rows that are relaxed one by one need hundreds of rounds. The pivot is 10 m above the zero of height, which gives the
// energy a total to compare with.
#include "accuracy/cases/joints/mechanisms.h"

namespace tumble::accuracy {

namespace {

struct Pendulum {
  std::string name;
  BodyDef body;
  double arm, inertia;  // m; kg m^2 about its centre; its mass is 1 kg
  JointKind kind;
};

enum class Measure { period, energy, pivot };

Outcome swing(Trial& trial, const Pendulum& pendulum, double amplitude, Measure measure) {
  const Vec3 pivot{0, 10, 0}, along{std::sin(amplitude), -std::cos(amplitude), 0};
  const double arm = pendulum.arm, period = swing_period(pendulum.inertia + arm * arm, arm, amplitude);
  Simulation& scene = trial.scene();
  Mechanism mechanism(scene);
  const BodyIndex body = mechanism.add(pendulum.body, {pivot + along * arm, between({1, 0, 0}, along)});
  mechanism.join(joint(body, kWorld, {-arm, 0, 0}, pendulum.kind, {0, 0, 1}));
  const double before = mechanism.energy();

  // Over a whole period the energy's ripple within the steps is without effect.
  const double seconds = period * span(trial, 20, 4.3, 1.3);
  Swing swing;
  Spread last;
  double gap = 0;
  run(scene, seconds, kFrame, [&](double time) {
    swing.add(time, angle_of(scene, body, pivot));
    if (time > seconds - period) last.add(mechanism.energy());
    gap = std::max(gap, mechanism.gap());
    return true;
  });

  Outcome outcome;
  const double scale = 2 * kGravity * arm;
  outcome.energy_drift = (last.mean() - before) / scale;
  outcome.max_joint_gap = gap;
  if (measure == Measure::period) outcome.error = relative(swing.period(), trial.reference(period));
  if (measure == Measure::energy) outcome.error = relative(last.mean(), trial.reference(before), scale);
  if (measure == Measure::pivot) outcome.error = relative(arm + gap, trial.reference(arm));
  if (!mechanism.finite()) outcome.failed = "not a number";
  else if (swing.period() == 0) outcome.failed = "does not swing";
  return outcome;
}

void add_parts(Case& c, const Pendulum& pendulum, int degrees, bool pivot) {
  const std::string name = pendulum.name + " " + std::to_string(degrees) + " deg ";
  const auto part = [&](const char* what, double goal, Measure measure) {
    c.parts.push_back({name + what, goal, [=](Trial& t) { return swing(t, pendulum, radians(degrees), measure); }});
  };
  part("period", 1e-3, Measure::period);
  part("energy", 1e-2, Measure::energy);
  if (pivot) part("pivot", 1e-3, Measure::pivot);
}

}  // namespace

Case a12_pendulum() {
  Case c{"A12", "Physical pendulum", "a rod of 1 m, or a bob of 0.05 m on an arm of 1 m, swings for 20 periods",
         "F: T = 2 pi sqrt(I / m g L) / agm(1, cos(A / 2)); C: energy; the pivot stays", "|T - T_ref| / T_ref; |lost energy| / 2 m g L; gap / L", {}};
  for (const auto& [name, kind] : {std::pair<std::string, JointKind>{"hinge", HingeDef{}}, {"ball", BallDef{}}}) {
    for (const int degrees : {10, 30, 60, 90, 120, 150, 170, 179}) add_parts(c, {name, rod(), 0.5, kRodInertia, kind}, degrees, degrees == 90);
    add_parts(c, {name + " small bob", dynamic(ball(0.05), 1), 1, 0.4 * 0.05 * 0.05, kind}, 10, false);
  }
  c.parts.push_back({"6-dof", 1e-3, [](Trial&) -> Outcome { throw Missing{"general joints of six freedoms"}; }});
  return c;
}

}  // namespace tumble::accuracy
