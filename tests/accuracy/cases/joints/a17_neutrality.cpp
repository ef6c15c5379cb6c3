// A joint pushes its two bodies against each other and nothing else: a floating linkage keeps momentum and angular
// momentum, also when a heavy ball strikes it, and its energy where nothing does.
#include "accuracy/cases/joints/mechanisms.h"

namespace tumble::accuracy {

namespace {

enum class Measure { momentum, angular_momentum, energy };

// Two rods end to end along x, joined at the origin, in a turn that bends them, or at rest until 10 kg at 5 m/s strike.
Outcome watch(Trial& trial, const JointKind& kind, bool struck, Measure measure, double seconds) {
  Simulation& scene = trial.scene({{0, 0, 0}, false});
  Mechanism mechanism(scene, {});
  BodyDef link = with(rod(), 0.5, 0.5);
  std::vector<BodyIndex> bodies;
  for (const double side : {-0.5, 0.5}) {
    if (!struck) {  // both turn about z, one faster, with the joint at rest
      link.angular_velocity = {0, 0, side > 0 ? 5.0 : 2.0};
      link.velocity = cross(link.angular_velocity, {side, 0, 0}) + Vec3{0, 1, 0};
    }
    bodies.push_back(mechanism.add(link, {{side, 0, 0}, {}}));
  }
  mechanism.join(joint(bodies[1], bodies[0], {-0.5, 0, 0}, kind, std::holds_alternative<SliderDef>(kind) ? Vec3{1, 0, 0} : Vec3{0, 0, 1}));
  if (struck) {
    BodyDef hammer = with(dynamic(ball(0.2), 10), 1, 1);
    hammer.velocity = {0, -5, 0};
    bodies.push_back(scene.add(hammer, {{0.8, 1.5, 0.02}, {}}));
  }
  const auto sum = [&](auto&& quantity) {
    auto total = quantity(bodies[0]);
    for (std::size_t i = 1; i < bodies.size(); ++i) total += quantity(bodies[i]);
    return total;
  };
  const auto momenta = [&] { return sum([&](BodyIndex body) { return momentum(scene, body); }); };
  const auto angular_momenta = [&] { return sum([&](BodyIndex body) { return angular_momentum(scene, body); }); };
  const Vec3 before = momenta(), angular_before = angular_momenta();
  const double energy_before = mechanism.energy();
  const double scale = sum([&](BodyIndex body) { return length(momentum(scene, body)); });
  const double angular_scale = sum([&](BodyIndex body) { return length(angular_momentum(scene, body)); });

  Outcome outcome;
  run(scene, seconds, kFrame, [&](double) {
    double error = 0;
    if (measure == Measure::momentum) error = distance(momenta(), trial.reference(before)) / scale;
    if (measure == Measure::angular_momentum) error = distance(angular_momenta(), trial.reference(angular_before)) / angular_scale;
    if (measure == Measure::energy) error = relative(mechanism.energy(), trial.reference(energy_before));
    outcome.error = std::max(outcome.error, error);
    outcome.max_joint_gap = std::max(outcome.max_joint_gap.value_or(0), mechanism.gap());
    return true;
  });
  if (struck && distance(scene.velocity(bodies.back()), {0, -5, 0}) < 0.1) outcome.failed = "was not struck";
  if (!mechanism.finite()) outcome.failed = "not a number";
  return outcome;
}

}  // namespace

Case a17_neutrality() {
  Case c{"A17", "Joint momentum neutrality", "two joined rods float, turning, or are struck off centre by 10 kg at 5 m/s", "C: momentum, angular momentum; energy where nothing strikes",
         "|P - P0| / sum |p|, |L - L0| / sum |l|, |E - E0| / E0, worst in 2 s (energy 10 s)", {}};
  const auto part = [&](const std::string& name, double goal, const JointKind& kind, bool struck, Measure measure) {
    c.parts.push_back({name, goal, [=](Trial& t) { return watch(t, kind, struck, measure, measure == Measure::energy ? span(t, 10, 3, 1) : 2); }});
  };
  for (const auto& [name, kind] : {std::pair<std::string, JointKind>{"hinge", HingeDef{}}, {"ball", BallDef{}}, {"slider", SliderDef{}}, {"fixed", FixedDef{}}}) {
    part(name + " struck momentum", 1e-6, kind, true, Measure::momentum);
    part(name + " struck angular momentum", 1e-6, kind, true, Measure::angular_momentum);
  }
  part("hinge floating momentum", 1e-6, HingeDef{}, false, Measure::momentum);
  part("hinge floating angular momentum", 1e-6, HingeDef{}, false, Measure::angular_momentum);
  part("hinge floating energy", 1e-3, HingeDef{}, false, Measure::energy);
  return c;
}

}  // namespace tumble::accuracy
