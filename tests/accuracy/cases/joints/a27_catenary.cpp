// A hanging chain: forty links between two supports find the shape in which all forces balance. Joints that stretch
// under load, or that a solver leaves unfinished, hang too deep.
#include "accuracy/cases/joints/mechanisms.h"

namespace tumble::accuracy {

namespace {

constexpr double kLink = 0.5;  // m; of 1 kg

// Uniform links in balance: all bear the horizontal force `pull`, and link i lies along the mean of its ends' forces,
// where upward ones grow by a link's weight from joint to joint. Newton's iteration on the width that it spans.
struct Catenary {
  double pull = 0, sag = 0;  // N, m
  Catenary(int links, double width) {
    const auto spanned = [&](double force) {
      double sum = 0;
      for (int i = 0; i < links; ++i) sum += kLink / std::hypot(1, slope(i, links, force));
      return sum;
    };
    pull = links * kGravity / 4;
    for (int i = 0; i < 50; ++i) {
      const double step = pull * 1e-6, rise = (spanned(pull + step) - spanned(pull - step)) / (2 * step);
      pull -= (spanned(pull) - width) / rise;
    }
    for (int i = links / 2; i < links; ++i) sag += kLink * slope(i, links, pull) / std::hypot(1, slope(i, links, pull));
  }
  static double slope(int link, int links, double force) { return (link + 0.5 - links / 2) * kGravity / force; }
};

// Let go as a V with both sides straight.
Outcome settle(Trial& trial, bool pull) {
  const int links = trial.effort() == Effort::test ? 10 : 40;
  const double seconds = span(trial, 60, 6, 3), width = 0.4 * links;
  Simulation& scene = trial.scene();
  Mechanism mechanism(scene);
  std::vector<Vec3> nodes;
  for (int i = 0; i <= links; ++i) nodes.push_back({width * i / links, -0.3 * (links / 2 - std::abs(i - links / 2)), 0});
  BodyDef link = dynamic(box({kLink, 0.1, 0.1}), 1);
  link.damping = trial.full() ? 0.5 : 3;
  link.angular_damping = link.damping;
  const BodyIndex last = mechanism.chain(nodes, link, BallDef{}).back();
  const JointIndex end = mechanism.join(joint(last, kWorld, {kLink / 2, 0, 0}, BallDef{}));

  run(scene, seconds);

  const Catenary truth(links, width);
  const double deepest = (scene.pose(links / 2 - 1) * Vec3{kLink / 2, 0, 0}).y;
  Outcome outcome;
  if (pull) outcome.error = relative(scene.joint_state(end).force.x, trial.reference(truth.pull));
  else outcome.error = relative(-deepest, trial.reference(truth.sag));
  outcome.max_joint_gap = mechanism.gap();
  if (!mechanism.finite()) outcome.failed = "not a number";
  else if (mechanism.fastest() > 0.05) outcome.failed = "does not settle: " + text(mechanism.fastest()) + " m/s";
  return outcome;
}

}  // namespace

Case a27_catenary() {
  return {"A27", "Catenary", "forty links of 0.5 m and 1 kg on ball joints between supports 16 m apart, settled for 60 s with mild damping",
          "R: balance of each link, by Newton's iteration", "|sag - ref| / ref; |horizontal force - ref| / ref",
          {{"sag", 1e-3, [](Trial& t) { return settle(t, false); }}, {"horizontal force", 1e-3, [](Trial& t) { return settle(t, true); }}}};
}

}  // namespace tumble::accuracy
