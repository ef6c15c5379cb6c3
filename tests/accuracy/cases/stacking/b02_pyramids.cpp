// Pyramids: many blocks that share their load with neighbours, so that an error anywhere spreads to the flanks.
#include "accuracy/cases/stacking/build.h"

namespace tumble::accuracy {

namespace {

constexpr double kFriction = 0.6, kAllowed = 0.1;  // m

Outcome judge_unmoved(Build& build, double seconds) {
  double most = 0;
  build.run(seconds, [&](double time) {
    const double now = build.furthest();
    most = std::max(most, now);
    if (now > 2) build.fail("fell apart at " + std::to_string(std::lround(time)) + " s");
    return now <= 2;
  });
  build.demand(most, kAllowed);
  return build.judge();
}

// Rows of base, base - 1 ... 1 cubes that touch their neighbours, each row half a cube aside.
Outcome flat(Trial& trial) {
  Build build(trial, kFriction);
  build.add_floor();
  const int base = as_many(trial, 20, 10, 8);
  for (int row = 0; row < base; ++row)
    for (int i = 0; i < base - row; ++i)
      build.add(dynamic(box({1, 1, 1}), 1), {{i + 0.5 * row - 0.5 * (base - 1), row + 0.5, 0}, {}});
  return judge_unmoved(build, lasting(trial, 20, 2, 0.5));
}

// Layers of 15 x 15, 14 x 14 ... 1 cubes of 2 m: 1240.
Outcome square(Trial& trial) {
  Build build(trial, kFriction);
  build.add_floor(80);
  const int base = as_many(trial, 15, 4, 3);
  for (int layer = 0; layer < base; ++layer)
    for (int i = 0; i < base - layer; ++i)
      for (int j = 0; j < base - layer; ++j)
        build.add(dynamic(box({2, 2, 2}), 8), {{2 * i + layer - (base - 1.0), 2 * layer + 1.0, 2 * j + layer - (base - 1.0)}, {}});
  return judge_unmoved(build, soaking(trial, 20, 5, 2, 0.5));
}

}  // namespace

Case b02_pyramids() {
  return {"B02", "Pyramids", "a wall-like pyramid of base 20 (210 cubes of 1 m), and a square one of base 15 (1240 cubes of 2 m); friction 0.6",
          "the pyramid as it was built", "furthest that any block moved in 20 s (the square one: 5 s, in a soak 20 s), over 0.1 m",
          {{"flat, base 20", 1, flat}, {"square, 1240", 1, square}}};
}

}  // namespace tumble::accuracy
