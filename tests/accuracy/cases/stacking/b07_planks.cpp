// Towers of loose planks: a Kapla house of 102 and a Jenga-like tower of thirty crossed layers. Small flat contacts far
// from the blocks' centres must carry twelve and thirty storeys.
#include "accuracy/cases/stacking/build.h"

namespace tumble::accuracy {

namespace {

// SimBenchmark's building: each floor has eight cross blocks, and walls of five on the one and four on the other side
// that bind them; the block at its top corner tells whether it stands.
Outcome kapla(Trial& trial) {
  Build build(trial, 0.8);
  build.add_floor();
  constexpr int kFloors = 6, kCrosses = 8;
  constexpr double kLong = 0.2, kShort = 0.05, kHigh = 0.1;
  const auto block = [&](Vec3 size, Vec3 at) { build.add(dynamic(box(size), 10), {at, {}}); };
  const double middle = (kCrosses - 1) * kLong / 2;
  for (int floor = 0; floor < kFloors; ++floor) {
    const double y = floor * 2 * kHigh + kHigh / 2;
    const auto wall = [&](double x, double side) { block({kLong, kHigh, kShort}, {x - middle, y + kHigh, side * kLong / 2}); };
    for (int i = 0; i < kCrosses; ++i) block({kShort, kHigh, kLong + kShort}, {i * kLong - middle, y, 0});
    for (int i = 0; i < kCrosses / 2; ++i) wall((2 * i + 0.5) * kLong, -1);
    wall(0.5 * kLong, 1);
    for (int i = 0; i + 1 < kCrosses / 2; ++i) wall((2 * i + 1.5) * kLong, 1);
    wall((kCrosses - 1.5) * kLong, 1);
  }
  Stand stand;
  stand.seconds = lasting(trial, 60, 1, 0.1);
  stand.block = kLong;
  stand.sink = 0.02 * kLong;
  demand_stand(build, stand);
  return build.judge();
}

// Two planks a layer, a layer across the other.
Outcome jenga(Trial& trial) {
  Build build(trial, 0.6);
  build.add_floor();
  constexpr int kLayers = 30;
  constexpr double kHigh = 0.2, kApart = 0.7;
  for (int layer = 0; layer < kLayers; ++layer)
    for (const double side : {kApart, -kApart}) {
      const bool across = layer % 2 == 1;
      const double y = (layer + 0.5) * kHigh;
      build.add(dynamic(box(across ? Vec3{2, kHigh, kHigh} : Vec3{kHigh, kHigh, 2}), 1), {across ? Vec3{0, y, side} : Vec3{side, y, 0}, {}});
    }
  Stand stand;
  stand.seconds = lasting(trial, 20, 2, 0.2);
  stand.block = 2;
  stand.sink = 0.04;
  demand_stand(build, stand);
  return build.judge();
}

}  // namespace

Case b07_planks() {
  return {"B07", "Kapla and Jenga", "a house of 102 blocks of 20 x 10 x 5 cm, friction 0.8; 30 crossed layers of two planks of 2 x 0.2 x 0.2 m, friction 0.6",
          "the tower as it was built", "top block aside over a quarter of its length or too low over 2 % of it, in 60 s and 20 s",
          {{"Kapla", 1, kapla}, {"Jenga", 1, jenga}}};
}

}  // namespace tumble::accuracy
