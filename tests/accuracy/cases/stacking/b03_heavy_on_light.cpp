// Heavy on light: the load must pass through light blocks, which a sequential solver passes on by a small part in each
// iteration. Too few, and the light ones are crushed or squeezed out.
#include "accuracy/cases/stacking/build.h"

namespace tumble::accuracy {

namespace {

constexpr double kFriction = 0.64, kSqueezed = 0.05, kSink = 0.01, kAside = 0.25;  // m

BodyDef cube(double mass) { return dynamic(box({1, 1, 1}), mass); }

// The last one is the heavy one.
Outcome judge_load(Trial& trial, Build& build, double sink, double quick) {
  double squeezed = 0, lower = 0, aside = 0;
  int frame = 0;
  build.run(lasting(trial, 10, quick, quick / 8), [&](double time) {
    if (++frame % 6 == 0) squeezed = std::max(squeezed, deepest(build.overlaps()));
    for (const Block& block : build.blocks()) aside = std::max(aside, build.moved(block).across);
    lower = std::max(lower, build.moved(build.last()).up);
    const bool lost = aside > 2 || lower > 0.5;
    if (lost) build.fail("gave way at " + std::to_string(time).substr(0, 4) + " s");
    return !lost;
  });
  build.demand(squeezed, kSqueezed);
  build.demand(lower, sink);
  build.demand(aside, kAside);
  return build.judge();
}

Outcome column(Trial& trial, int light, double mass) {
  Build build(trial, kFriction);
  build.add_floor();
  for (int i = 0; i <= light; ++i) build.add(cube(i == light ? mass : 1), {{0, 0.5 + i, 0}, {}});
  return judge_load(trial, build, kSink, 4);
}

// Ten rows of 10, 9 ... 1 cubes, the topmost heavy.
Outcome pyramid(Trial& trial, double mass) {
  Build build(trial, kFriction);
  build.add_floor();
  constexpr int kRows = 10;
  for (int row = 0; row < kRows; ++row)
    for (int i = 0; i < kRows - row; ++i) build.add(cube(row == kRows - 1 ? mass : 1), {{i + 0.5 * row - 4.5, row + 0.5, 0}, {}});
  return judge_load(trial, build, kSqueezed, 1.5);
}

}  // namespace

Case b03_heavy_on_light() {
  Case c{"B03", "Heavy on light", "a cube of 10 to 10 000 kg on one or on a column of nine of 1 kg; pyramids of ten rows with a topmost of 100 to 300 kg",
         "what was built", "overlap over 5 cm, the heavy one too low over 1 cm (pyramids 5 cm), any cube aside over 25 cm, in 10 s", {}};
  for (const int ratio : {10, 100, 1000, 10000})
    c.parts.push_back({std::to_string(ratio) + ":1", 1, [ratio](Trial& t) { return column(t, 1, ratio); }});
  for (const int ratio : {100, 1000})
    c.parts.push_back({std::to_string(ratio) + ":1 on nine", 1, [ratio](Trial& t) { return column(t, 9, ratio); }});
  for (const int ratio : {100, 200, 300})
    c.parts.push_back({"pyramid " + std::to_string(ratio) + ":1", 1, [ratio](Trial& t) { return pyramid(t, ratio); }});
  return c;
}

}  // namespace tumble::accuracy
