// A wall of cubes that lands whole from 5 m: it must take the blow in all its layers at once, end at rest with the
// cubes where they belong, and gain nothing.
#include "accuracy/cases/stacking/build.h"

namespace tumble::accuracy {

namespace {

constexpr int kSide = 10;
constexpr double kAllowedPart = 0.05;
constexpr double kGap = 0.002, kDrop = 5, kFriction = 0.6, kInPlace = 0.5, kAtRest = 0.05;  // m, m/s

Outcome wall(Trial& trial) {
  Build build(trial, kFriction);
  build.add_floor(60);
  for (int row = 0; row < kSide; ++row)
    for (int column = 0; column < kSide; ++column)
      build.add(dynamic(box({1, 1, 1}), 1), {{(column - 4.5) * (1 + kGap), kDrop + 0.5 + row * (1 + kGap), 0}, {}});

  build.run(lasting(trial, 10, 3, 1.5));

  int out = 0;
  for (int i = 0; i < kSide * kSide; ++i) {
    const Block& cube = build.block(i);
    if (build.way(cube.body, {cube.start.position.x, 0.5 + i / kSide, 0}).far() > kInPlace) ++out;
  }
  build.demand(out, kAllowedPart * kSide * kSide);
  if (trial.full()) build.demand(build.fastest(), kAtRest);
  Outcome outcome = build.judge();
  outcome.error *= kAllowedPart;
  outcome.worst = out / static_cast<double>(kSide * kSide);
  return outcome;
}

}  // namespace

Case s04_wall() {
  return {"S04", "Wall from 5 m", "10 x 10 cubes of 1 m, 2 mm apart, fall 5 m as a wall, friction 0.6", "the wall on the floor",
          "part of the cubes more than half a metre out of place; 0.05 also stands for a speed of 0.05 m/s after 10 s and for 1 % of energy gained", {{"", kAllowedPart, wall}}};
}

}  // namespace tumble::accuracy
