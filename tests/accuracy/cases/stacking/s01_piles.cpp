// S01 to S03: piles of hundreds to thousands of mixed bodies, the everyday load of an engine: how deep do they sink
// into each other where none of them may be looked after for itself?
#include <algorithm>

#include "accuracy/cases/stacking/pile.h"

namespace tumble::accuracy {

namespace {

constexpr double kSize = 1;         // m, of a body: makes a depth an error
constexpr double kLookEvery = 0.1, kLookAtManyEvery = 0.5;  // s: exact depths of thousands of hulls take seconds
constexpr int kMostInFull = 2000;

Outcome pile(Trial& trial, int full, int quick, int test, Mix mix) {
  Build build(trial, 0.5);
  // Eight thousand take minutes for a second: they are for a soak.
  const bool too_many = full > kMostInFull && trial.effort() == Effort::full;
  const int count = as_many(trial, too_many ? kMostInFull / 2 : full, quick, test);
  const Pit pit = pour(build, count, mix);

  const double seconds = soaking(trial, 7, mix == Mix::convex && count > 1000 ? 5 : 7, 2.2, 1.5), looked_at = std::min(1.0, seconds / 4);
  double sum = 0, most = 0;
  int looks = 0;
  const double every = mix == Mix::convex && count > 500 ? kLookAtManyEvery : kLookEvery;
  double next = seconds - looked_at + every;
  build.run(seconds, [&](double time) {
    if (time < next - kFrame / 2) return true;
    next += every;
    const std::vector<Overlap> overlaps = build.overlaps();
    sum += mean_depth(overlaps);
    most = std::max(most, deepest(overlaps));
    ++looks;
    return true;
  });

  int inside = 0;
  for (const Block& block : build.blocks()) inside += pit.holds(build.scene().pose(block.body).position);
  Outcome outcome = build.judge();
  if (inside < count && outcome.failed.empty()) outcome.failed = std::to_string(count - inside) + " bodies left the pit";
  outcome.error = std::max(looks ? sum / looks / kSize : 1, relative(inside, trial.reference(count)));
  outcome.max_penetration = most;
  return outcome;
}

Case piles(const char* id, int full, int quick, int test, double goal) {
  Case c{id, "Pile of " + std::to_string(full), std::to_string(full) + " mixed bodies of 1 kg and about 1 m fall into a pit with four walls, friction 0.5",
         "none overlaps another, all stay in the pit", "mean depth of overlapping pairs in the last of 7 s (hulls from 1000 on: 5 s, in a soak 7 s), over 1 m; part of the bodies lost", {}};
  c.parts.push_back({"box, ball, capsule", goal, [=](Trial& t) { return pile(t, full, quick, test, Mix::simple); }});
  c.parts.push_back({"box, cylinder, hull", goal, [=](Trial& t) { return pile(t, full, quick, test, Mix::convex); }});
  return c;
}

}  // namespace

Case s01_pile_of_500() { return piles("S01", 500, 60, 16, 0.5e-3); }
Case s02_pile_of_2000() { return piles("S02", 2000, 80, 18, 0.5e-3); }
Case s03_pile_of_8000() {
  Case c = piles("S03", 8000, 90, 20, 1e-3);
  c.scene += "; all of them with --soak, 1000 in a full run";
  return c;
}

}  // namespace tumble::accuracy
