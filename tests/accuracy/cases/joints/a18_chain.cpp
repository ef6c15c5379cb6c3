// A chain with a heavy end: each joint carries what hangs below it, up to ten thousand times a link's weight. Rows that
// are relaxed one by one do not get that far; smaller steps help hundreds of times more than further rounds.
#include "accuracy/cases/joints/mechanisms.h"

namespace tumble::accuracy {

namespace {

constexpr int kLinks = 10;
constexpr double kLink = 0.5;  // m

enum class Measure { gap, tension, height };

// Ten links of 1 kg and a cube of `heavy` kg at their end, along a direction.
Outcome hang(Trial& trial, double heavy, Vec3 along, Measure measure, double seconds) {
  Simulation& scene = trial.scene();
  Mechanism mechanism(scene);
  std::vector<Vec3> nodes;
  for (int i = 0; i <= kLinks; ++i) nodes.push_back(along * (kLink * i));
  const std::vector<BodyIndex> links = mechanism.chain(nodes, dynamic(box({kLink, 0.1, 0.1}), 1), BallDef{});
  const BodyIndex end = mechanism.add(dynamic(box({kLink, kLink, kLink}), heavy), {along * (kLink * (kLinks + 0.5)), between({1, 0, 0}, along)});
  mechanism.join(joint(end, links.back(), {-kLink / 2, 0, 0}, BallDef{}));
  const double start = mechanism.energy();

  Outcome outcome;
  double gap = 0, highest = start;
  run(scene, seconds, kFrame, [&](double) {
    gap = std::max(gap, mechanism.gap());
    highest = std::max(highest, mechanism.energy());
    return mechanism.finite();
  });
  outcome.max_joint_gap = gap;
  outcome.energy_drift = (highest - start) / ((heavy + kLinks) * kGravity * kLink * kLinks);
  if (measure == Measure::gap) outcome.error = relative(kLink + gap, trial.reference(kLink));
  if (measure == Measure::height) outcome.error = relative(-center(scene, end).y, trial.reference(kLink * (kLinks + 0.5)));
  if (measure == Measure::tension) {  // joint i is above link i and bears that and all below
    for (int i = 0; i <= kLinks; ++i) {
      const double weight = (heavy + kLinks - i) * kGravity;
      outcome.error = std::max(outcome.error, relative(length(scene.joint_state(i).force), trial.reference(weight)));
    }
  }
  if (!mechanism.finite()) outcome.failed = "not a number";
  return outcome;
}

}  // namespace

Case a18_chain() {
  Case c{"A18", "Chain with a heavy end", "ten links of 0.5 m and 1 kg on ball joints, 1 to 10000 kg at the end; hung for 10 s, or let go horizontally",
         "F: no gap; the force in a joint is the weight below it", "largest gap / 0.5 m; worst relative error of a joint's force; error of the end's height / its depth", {}};
  for (const double heavy : {1, 10, 100, 1000, 10000}) {
    const std::string name = "1:" + text(heavy);
    const auto part = [&](const char* what, double goal, Vec3 along, Measure measure) {
      c.parts.push_back({name + what, goal, [=](Trial& t) { return hang(t, heavy, along, measure, span(t, 10, 3, 0.5)); }});
    };
    part(" hung gap", 2e-3, {0, -1, 0}, Measure::gap);
    part(" hung tension", 1e-3, {0, -1, 0}, Measure::tension);
    part(" hung height", 1e-3, {0, -1, 0}, Measure::height);
    part(" let go gap", 2e-3, {1, 0, 0}, Measure::gap);
  }
  return c;
}

}  // namespace tumble::accuracy
