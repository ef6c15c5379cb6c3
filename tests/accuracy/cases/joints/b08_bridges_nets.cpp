// Many joints at once: a bridge, a ball on a chain, a grid, nets. Nothing may tear, race or gain energy.
#include "accuracy/cases/joints/mechanisms.h"

namespace tumble::accuracy {

namespace {

constexpr double kHeight = 100;  // m, above the zero of height, so that energy has a total to compare with

// Gap, speed and energy over what is allowed: a tenth of a link from 2 s on, 100 m/s, and 1 % of the work that gravity
// has done by then above the start.
Outcome judge(Trial& trial, Simulation& scene, const Mechanism& mechanism, double link, double seconds) {
  const double start = mechanism.energy();
  double gap = 0, fastest = 0, highest = start, lowest_potential = start;
  run(scene, seconds, kFrame, [&](double time) {
    const double now = mechanism.energy();
    highest = std::max(highest, now);
    lowest_potential = std::min(lowest_potential, now - mechanism.kinetic());
    fastest = std::max(fastest, mechanism.fastest());
    if (time > 2 - kFrame / 2) gap = std::max(gap, mechanism.gap());
    return mechanism.finite();
  });

  const double work = start - lowest_potential;
  Outcome outcome;
  outcome.error = std::max({gap / (0.1 * link), fastest / 100, relative(highest, trial.reference(start), 0.01 * work)});
  outcome.max_joint_gap = gap;
  outcome.energy_drift = (mechanism.energy() - start) / work;
  if (!mechanism.finite()) outcome.failed = "not a number";
  else if (gap > link) outcome.failed = "torn: a gap of " + text(gap) + " m";
  return outcome;
}

std::vector<Vec3> line(int links) {
  std::vector<Vec3> nodes;
  for (int i = 0; i <= links; ++i) nodes.push_back({static_cast<double>(i), kHeight, 0});
  return nodes;
}

// Planks of 1 m, 20 kg/m^3, on hinges, level and without slack.
Outcome bridge(Trial& trial) {
  Simulation& scene = trial.scene();
  Mechanism mechanism(scene);
  const BodyIndex last = mechanism.chain(line(static_cast<int>(span(trial, 160, 40, 10))), dynamic(box({1, 0.25, 1}), 5), HingeDef{}).back();
  mechanism.join(joint(last, kWorld, {0.5, 0, 0}, HingeDef{}, {0, 0, 1}));
  return judge(trial, scene, mechanism, 1, span(trial, 4, 2.5, 2.2));
}

// Links of 6 kg and a ball of 4 m and 1000 kg, let go horizontally.
Outcome ball_and_chain(Trial& trial) {
  Simulation& scene = trial.scene();
  Mechanism mechanism(scene);
  const int links = static_cast<int>(span(trial, 40, 40, 8));
  const BodyIndex last = mechanism.chain(line(links), dynamic(box({1, 0.25, 0.25}), 6), BallDef{}).back();
  const BodyIndex end = mechanism.add(dynamic(ball(4), 1000), {{links + 4.0, kHeight, 0}, {}});
  mechanism.join(joint(end, last, {-4, 0, 0}, BallDef{}));
  return judge(trial, scene, mechanism, 1, span(trial, 10, 4, 2.2));
}

// Balls 1 m apart in a square, each joined to its neighbours half way; `down` is the way from row to row.
Outcome net(Trial& trial, int side, Vec3 down, const JointKind& kind, const std::function<bool(int, int)>& held, double seconds) {
  Simulation& scene = trial.scene();
  Mechanism mechanism(scene);
  std::vector<BodyIndex> above(static_cast<std::size_t>(side));
  for (int row = 0; row < side; ++row) {
    BodyIndex left = 0;
    for (int column = 0; column < side; ++column) {
      const Vec3 at = Vec3{static_cast<double>(column), kHeight, 0} + down * row;
      const BodyIndex body = mechanism.add(held(row, column) ? fixed(ball(0.4)) : dynamic(ball(0.4), 1), {at, {}});
      const auto tie = [&](BodyIndex other, Vec3 way) { mechanism.join(joint(body, other, way * -0.5, kind, {0, 0, 1})); };
      BodyIndex& upper = above[static_cast<std::size_t>(column)];
      if (column > 0 && !(held(row, column) && held(row, column - 1))) tie(left, {1, 0, 0});
      if (row > 0 && !(held(row, column) && held(row - 1, column))) tie(upper, down);
      left = upper = body;
    }
  }
  return judge(trial, scene, mechanism, 1, seconds);
}

// Upright, on hinges, held by seven of its upper edge.
Outcome grid(Trial& trial) {
  const int side = static_cast<int>(span(trial, 20, 8, 4));
  return net(trial, side, {0, -1, 0}, HingeDef{}, [=](int row, int column) { return row == 0 && std::abs(column - side / 2) <= 3; }, span(trial, 4, 2.3, 2.2));
}

// Level, held by its corners.
Outcome corner_net(Trial& trial) {
  const int side = static_cast<int>(span(trial, 40, 7, 3));
  return net(trial, side, {0, 0, 1}, BallDef{}, [=](int row, int column) { return row % (side - 1) == 0 && column % (side - 1) == 0; }, span(trial, 3, 2.3, 2.2));
}

// Level, held by every fourth of one edge: 10 000 steps in the soak run.
Outcome pinned_net(Trial& trial) {
  const bool soak = trial.effort() == Effort::soak;
  const int side = static_cast<int>(span(trial, soak ? 32 : 16, 7, 3));
  const auto held = [=](int row, int column) { return row == 0 && (column % 4 == 0 || column == side - 1); };
  return net(trial, side, {0, 0, 1}, BallDef{}, held, span(trial, soak ? 10000 * kFrame : 15, 2.3, 2.2));
}

}  // namespace

Case b08_bridges_nets() {
  return {"B08", "Bridge, ball and chain, nets", "160 planks; 40 links and a ball of 1000 kg; a 20 x 20 grid; a 40 x 40 and a 32 x 32 net, let go from where no joint has slack",
          "no gap above a tenth of a link from 2 s on, no speed above 100 m/s, no energy above the start and 1 % of gravity's work", "the worst over what is allowed",
          {{"bridge", 1, bridge}, {"ball and chain", 1, ball_and_chain}, {"grid", 1, grid}, {"net by its corners", 1, corner_net}, {"pinned net", 1, pinned_net}}};
}

}  // namespace tumble::accuracy
