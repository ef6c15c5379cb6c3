// What physics costs where there is little of it: an empty world, and one body that moves among ten thousand that sleep.
#include "bench/bench.h"
#include "physics/world.h"

namespace tumble::bench {

namespace {

constexpr double kTick = 1.0 / 60;
constexpr int kSide = 100, kBlocks = 9, kTicks = 200;

BodyDef cube(BodyType type) {
  BodyDef def;
  def.type = type;
  def.colliders.emplace_back();
  return def;
}

// Turns in the air for ever.
void add_awake(World& world) {
  BodyDef def = cube(BodyType::dynamic);
  def.gravity_factor = 0;
  def.angular_velocity = {0, 1, 0};
  world.add(def, {{0, 100, 0}, {}}, 0);
}

void add_asleep(World& world) {
  BodyDef floor = cube(BodyType::fixed);
  floor.colliders[0].shape.size = {3.0 * kSide, 1, 3.0 * kSide};
  world.add(floor, {{0, -0.5, 0}, {}}, 0);
  for (int i = 0; i < kSide * kSide; ++i) {
    const Vec3 place{2.0 * (i % kSide) - kSide, 0.5, 2.0 * (i / kSide) - kSide};
    world.sleep(world.add(cube(BodyType::dynamic), {place, {}}, 0));
  }
}

void tick(World& world, int count) {
  for (int i = 0; i < count; ++i) {
    world.step(kTick);
    world.take_events();
  }
}

}  // namespace

std::vector<Result> idle_physics() {
  World empty{WorldSettings{}}, alone{WorldSettings{}}, among{WorldSettings{}};
  add_awake(alone);
  add_awake(among);
  add_asleep(among);
  tick(among, 10);  // all that is new has been looked at
  const Turns turns = take_turns(kBlocks, [&] { tick(among, kTicks); }, [&] { tick(alone, kTicks); });
  const double begin = processor_ms();
  tick(empty, 100 * kTicks);
  const double of_empty = (processor_ms() - begin) / (100 * kTicks);
  return {{"empty_world_us", of_empty * 1e3, "us", "at most 2", "a tick of a world without bodies; thread processor time"},
          {"one_body_us", turns.b / kTicks * 1e3, "us", "", "a tick with one body that turns in the air"},
          {"one_among_sleepers", turns.ratio, "x", "at most 3", "the same body beside 10 000 cubes that sleep on a floor, over alone; " +
               std::to_string(among.stats().awake) + " of " + std::to_string(among.stats().bodies) + " are awake"}};
}

}  // namespace tumble::bench
