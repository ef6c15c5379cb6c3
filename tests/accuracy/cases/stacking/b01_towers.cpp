// Towers of cubes: one on the other, the oldest test of contact and friction without drift. A solver that stops short
// of the truth, or forgets its friction from step to step, lets them lean and fall.
#include "accuracy/cases/stacking/build.h"

namespace tumble::accuracy {

namespace {

constexpr double kFriction = 0.64;

void raise(Build& build, int count, double spacing) {
  build.add_floor();
  for (int i = 0; i < count; ++i) build.add(dynamic(box({1, 1, 1}), 1), {{0, 0.5 + i * spacing, 0}, {}});
}

// From 1.05 m apart they drop onto each other; the height is looked at once they had time to.
Outcome tower(Trial& trial, int count, double spacing) {
  Build build(trial, kFriction);
  raise(build, count, spacing);
  Stand stand;
  stand.seconds = lasting(trial, 20, 6, 1.5);
  stand.settled = spacing > 1 ? 0.8 * stand.seconds : 0;
  stand.height = count - 0.5;
  if (count == 20) stand.sink = 0.01;  // the dynamics' own goal
  demand_stand(build, stand);
  return build.judge();
}

// With sleeping on it is asleep, all of it, within 5 s, and as high as it was.
Outcome sleeping_tower(Trial& trial, int count) {
  SceneSettings settings;
  settings.sleeping = true;
  Build build(trial, kFriction, settings);
  raise(build, count, 1);
  constexpr double kAsleepIn = 5;
  double asleep_at = 1.1 * kAsleepIn;
  build.run(asleep_at, [&](double time) {
    for (const Block& block : build.blocks())
      if (!build.scene().asleep(block.body)) return true;
    asleep_at = time;
    return false;
  });
  const Build::Way way = build.moved(build.last());
  build.demand(asleep_at, kAsleepIn);
  build.demand(way.across, 0.25);
  build.demand(way.up, 0.02);
  return build.judge();
}

}  // namespace

Case b01_towers() {
  Case c{"B01", "Towers", "10, 20 and 30 cubes of 1 m and 1 kg one on the other, friction 0.64; also dropped from gaps of 5 cm",
         "the tower as it was built", "top block aside over a quarter of a block, or too low over 2 % of one (20 cubes: 1 cm), in 20 s", {}};
  for (const int count : {10, 20, 30}) {
    c.parts.push_back({std::to_string(count), 1, [count](Trial& t) { return tower(t, count, 1); }});
    c.parts.push_back({std::to_string(count) + " dropped", 1, [count](Trial& t) { return tower(t, count, 1.05); }});
  }
  c.parts.push_back({"10 asleep", 1, [](Trial& t) { return sleeping_tower(t, 10); }});
  return c;
}

}  // namespace tumble::accuracy
