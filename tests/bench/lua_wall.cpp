// What scripting costs a scene full of physics: a wall of 100 cubes in a game, and in a bare world of ours.
#include <cmath>

#include "bench/bench.h"
#include "physics/world.h"
#include "support/test_game.h"

namespace tumble::bench {

namespace {

constexpr int kSide = 10, kTicks = 600, kBlocks = 5;
constexpr double kGap = 0.002, kLowest = 5.5;

const char* const kGame = R"(
physics.sleeping = false
scene.add { name = "floor", position = vec3(0, -0.5, 0), mesh = { shape = "box", size = vec3(60, 1, 60) }, body = { type = "static", friction = 0.6 } }
local cubes = {}
for row = 0, 9 do
  for column = 0, 9 do
    cubes[#cubes + 1] = scene.add { position = vec3((column - 4.5) * 1.002, 5.5 + row * 1.002, 0), mesh = "box", body = { mass = 1, friction = 0.6 } }
  end
end
local highest = 0
function update()
  highest = 0
  for i = 1, #cubes do
    local x, y, z = cubes[i]:get_position()
    if y > highest then highest = y end
  end
end
function late_update() game.report.highest = highest end
)";

Shape box(Vec3 size) {
  Shape shape;
  shape.shape = ShapeKind::box;
  shape.size = size;
  return shape;
}

BodyDef body(BodyType type, Vec3 size) {
  BodyDef def;
  def.type = type;
  def.friction = 0.6;
  def.colliders.emplace_back();
  def.colliders.back().shape = box(size);
  return def;
}

struct Run {
  double ms = 0;
  double contacts = 0;  // mean over the ticks
  double highest = 0;
};

Run in_lua() {
  TestGame game(Files{{"main.lua", kGame}});
  game.tick();
  Run run;
  const double begin = processor_ms();
  for (int i = 1; i < kTicks; ++i) {
    game.tick();
    run.contacts += game.engine->world()->stats().contacts;
  }
  run.ms = processor_ms() - begin;
  run.contacts /= kTicks - 1;
  run.highest = game.number("highest");
  return run;
}

Run in_world() {
  WorldSettings settings;
  settings.sleeping = false;
  World world(settings);
  world.add(body(BodyType::fixed, {60, 1, 60}), {{0, -0.5, 0}, {}}, 0);
  std::vector<BodyId> cubes;
  for (int row = 0; row < kSide; ++row)
    for (int column = 0; column < kSide; ++column) {
      const Vec3 at{(column - 4.5) * (1 + kGap), kLowest + row * (1 + kGap), 0};
      cubes.push_back(world.add(body(BodyType::dynamic, {1, 1, 1}), {at, {}}, cubes.size() + 1));
    }
  world.step(1.0 / 60);
  world.take_events();
  Run run;
  const double begin = processor_ms();
  for (int i = 1; i < kTicks; ++i) {
    run.highest = 0;
    for (const BodyId cube : cubes) run.highest = std::max(run.highest, world.pose(cube).position.y);
    world.step(1.0 / 60);
    world.take_events();
    run.contacts += world.stats().contacts;
  }
  run.ms = processor_ms() - begin;
  run.contacts /= kTicks - 1;
  return run;
}

}  // namespace

std::vector<Result> lua_wall() {
  std::vector<double> lua, bare;
  Run a, b;
  for (int i = 0; i < kBlocks; ++i) {
    a = in_lua();
    b = in_world();
    lua.push_back(a.ms);
    bare.push_back(b.ms);
  }
  return {{"lua_wall_ratio", median(lua) / median(bare), "ratio", "at most 1.1",
           "10x10 cubes, 600 ticks, sleep off, a Lua update that reads 100 positions, over the same scene in a World without Lua; 5 runs of each in turn, median"},
          {"lua_wall_contacts_ratio", a.contacts / b.contacts, "ratio", "within 5 % of 1", "mean contact points a tick of those two scenes"},
          {"lua_wall_ms", median(lua) / (kTicks - 1), "ms", "", "a tick of the scene in Lua"}};
}

}  // namespace tumble::bench
