// Levels that come and go two hundred times: nothing of them stays behind.
#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "support/source_tree.h"
#include "support/test_game.h"

using namespace tumble;

namespace {

constexpr double kPatience = 60;  // s: what is watched here is memory, also where everything is slow

constexpr int kLoads = 200;
constexpr int kTicks = 6;    // in each level, so that tasks, tweens and contacts begin
constexpr int kSettled = 40;  // loads until pools and tables have the size that they need

// What may grow with the number of loads, measured after each of them.
struct Measure {
  std::size_t lua_bytes = 0;
  std::size_t nodes = 0, joints = 0, bodies = 0;
  std::uint32_t highest_node = 0, highest_joint = 0;   // pools that leak grow, whatever they hold just now
};

Measure measure(TestGame& game) {
  Measure m;
  m.lua_bytes = game.script->memory_used();
  m.nodes = game.engine->scene.size();
  game.engine->scene.each(game.engine->scene.root(), [&](NodeId node, SceneNode&) {
    m.highest_node = std::max(m.highest_node, node.index);
    if (game.engine->body(node)) ++m.bodies;
  });
  game.engine->each_joint([&](JointRef joint, const JointRecord&) {
    ++m.joints;
    m.highest_joint = std::max(m.highest_joint, joint.index);
  });
  return m;
}

// The largest of some measures, each by itself.
Measure largest(const std::vector<Measure>& list, std::size_t begin, std::size_t end) {
  Measure top;
  for (std::size_t i = begin; i < end; ++i) {
    const Measure& m = list[i];
    top.lua_bytes = std::max(top.lua_bytes, m.lua_bytes);
    top.nodes = std::max(top.nodes, m.nodes);
    top.joints = std::max(top.joints, m.joints);
    top.bodies = std::max(top.bodies, m.bodies);
    top.highest_node = std::max(top.highest_node, m.highest_node);
    top.highest_joint = std::max(top.highest_joint, m.highest_joint);
  }
  return top;
}

// Loads one level after the other, and compares the loads at the end with those when all has settled.
void check_flat(TestGame& game, const std::vector<std::string>& levels) {
  std::vector<Measure> measures;
  for (int i = 0; i < kLoads; ++i) {
    game.script->request_scene(levels[static_cast<std::size_t>(i) % levels.size()]);
    game.tick(kTicks);
    measures.push_back(measure(game));
  }
  REQUIRE(game.last_error() == "");
  const Measure before = largest(measures, kSettled, 2 * kSettled), after = largest(measures, kLoads - kSettled, kLoads);

  CHECK(after.nodes == before.nodes);
  CHECK(after.bodies == before.bodies);
  CHECK(after.joints == before.joints);
  CHECK(after.highest_node == before.highest_node);
  CHECK(after.highest_joint == before.highest_joint);
  // Tables keep some room; a kept level would add 160 of them.
  INFO("Lua: " << before.lua_bytes << " bytes at most after some loads, " << after.lua_bytes << " at the end");
  CHECK(static_cast<double>(after.lua_bytes) < 1.1 * static_cast<double>(before.lua_bytes));
}

// Everything that can hang on a level.
const char* const kThing = R"(
local Thing = behaviour { speed = 2, data = {} }
function Thing:start()
  self.list, self.ticks, self.hit, self.last = {}, 0, false, false
  for i = 1, 50 do self.list[i] = { at = vec3(i, 0, 0), text = "entry " .. i .. " of " .. self.node.path } end
  task.every(0.02, self.count, self)
  task.spawn(function() while true do wait(0.03) self:count() end end)
  task.loop(function() wait(0.02) self:count() end)
  tween(self.node, 30, { color = "red" }, { times = math.huge, back = true })
  tween(self, 30, { speed = 5 })
  self.node.on_collision_enter = function(hit) self.hit = hit end
  self.node.on_message = function() self:count() end
  self.extra = scene.add { name = "extra of " .. self.node.name, mesh = "sphere", body = { mass = 1 }, parent = self.node.parent, behaviours = { follower = {} } }
  joint.ball { a = self.extra, b = self.node, anchor = vec3(0, 1, 0) }
end
function Thing:count() self.ticks = self.ticks + 1 end
function Thing:update(dt) scene.send("message") end
function Thing:on_collision_stay(hit) self.last = hit end
function Thing:on_destroy() self.gone = true end
return Thing
)";
const char* const kFollower = R"(
local Follower = behaviour { target = property.node() }
function Follower:start() task.after(100, print, self) end
function Follower:on_trigger_enter(hit) end
return Follower
)";
const char* const kMain = R"(
local held = {}
local last
scene.add { name = "kept", mesh = "box", body = "kinematic" }
function on_scene_start(name)
  last = scene.tagged("thing")
  task.spawn(function() wait(0.05) held = { scene.tagged("thing")[1] } end)
  for _, thing in ipairs(last) do tween(thing.light, 20, { brightness = 9 }) end
  if #last > 0 then joint.hinge { a = last[1], b = scene.get("kept"), axis = vec3.up } end
end
)";

std::string level(int things) {
  std::string text = R"({"tumble": 1, "children": [{"name": "floor", "mesh": {"shape": "box", "size": [40, 1, 40]}, "position": [0, -2, 0], "body": "static"},
    {"name": "zone", "mesh": "box", "body": {"type": "static", "trigger": true}})";
  for (int i = 0; i < things; ++i)
    text += R"(, {"prefab": "thing", "name": "thing )" + std::to_string(i) + R"(", "position": [)" + std::to_string(3 * i) + ", 0, 0]}";
  return text + "]}";
}

Files files_of(const std::string& game) {
  Files files;
  const std::filesystem::path folder = source_tree("games/" + game);
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    std::ifstream in(entry.path(), std::ios::binary);
    files[std::filesystem::relative(entry.path(), folder).generic_string()] = {std::istreambuf_iterator<char>(in), {}};
  }
  return files;
}

}  // namespace

TEST_CASE("levels: behaviours, tasks, tweens, joints, slots and hits of a level go with it", "[script][levels]") {
  TestGame game({{"main.lua", kMain},
                 {"thing.lua", kThing},
                 {"follower.lua", kFollower},
                 {"a.json", level(6)},
                 {"b.json", level(4)},
                 {"thing.json", R"({"tumble": 1, "name": "thing", "tags": "thing", "mesh": "box", "body": {"mass": 2}, "light": "point", "behaviours": {"thing": {}},
                    "children": [{"name": "arm", "position": [1, 0, 0], "behaviours": {"follower": {"target": "floor"}},
                                  "joints": []}]})"}});
  check_flat(game, {"a", "b"});
}

TEST_CASE("levels: the platformer's level loaded two hundred times", "[script][levels]") {
  TestGame game(files_of("platformer"), kPatience);
  check_flat(game, {"levels/one"});
}
