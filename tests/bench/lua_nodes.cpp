// What the binding costs: nodes moved by node:translate against a hand-written function that checks nothing.
#include "bench/bench.h"
#include "script/lua.h"
#include "script/objects.h"
#include "script/types.h"
#include "support/test_game.h"

namespace tumble::bench {

namespace {

constexpr int kNodes = 10000, kTicks = 10, kBlocks = 31;

const char* const kGame = R"(
local nodes, velocity = {}, vec3(0, 0.001, 0)
function start()
  for i = 1, 10000 do nodes[i] = scene.add { position = vec3(i, 0, 0) } end
end
local mode = "vector"
function on_mode(name) mode = name end
local function by_vector(dt)
  for i = 1, #nodes do nodes[i]:translate(velocity, dt) end
end
local function by_numbers(dt)
  for i = 1, #nodes do nodes[i]:translate(0, 0.001 * dt, 0) end
end
local function by_property(dt)
  for i = 1, #nodes do local n = nodes[i]; n.position = n.position + velocity * dt end
end
local modes = { vector = by_vector, numbers = by_numbers, property = by_property }
function update(dt) modes[mode](dt) end
)";

// Nothing is looked at: the userdata is a node, the numbers are numbers, the node lives.
int bare_translate(lua_State* L) {
  const NodeId node = static_cast<Object<NodeId>*>(lua_touserdata(L, 1))->value;
  Engine& engine = script_of(L).live_engine();
  const Vec3 offset{lua_tonumber(L, 2), lua_tonumber(L, 3), lua_tonumber(L, 4)};
  engine.set_position(node, engine.scene[node].local.position + offset);
  return 0;
}

const char* const kBareLoop = R"(
local translate, nodes = ...
return function(dt)
  for i = 1, #nodes do translate(nodes[i], 0, 0.001 * dt, 0) end
end
)";

// Leaves the loop's place in the registry.
int make_bare_loop(TestGame& game) {
  lua_State* L = game.script->lua();
  luaL_loadstring(L, kBareLoop);
  lua_pushcfunction(L, bare_translate);
  lua_createtable(L, kNodes, 0);
  int i = 0;
  game.engine->scene.each(game.engine->scene.root(), [&](NodeId id, const SceneNode& node) {
    if (!node.parent || i == kNodes) return;
    game.script->push_node(id);
    lua_rawseti(L, -2, ++i);
  });
  lua_call(L, 2, 1);
  return luaL_ref(L, LUA_REGISTRYINDEX);
}

}  // namespace

std::vector<Result> lua_nodes() {
  TestGame game(Files{{"main.lua", kGame}});
  game.tick(2);
  lua_State* L = game.script->lua();
  const int bare = make_bare_loop(game);
  const auto ours = [&] {
    for (int i = 0; i < kTicks; ++i) {
      game.engine->begin_tick();
      game.script->update(1.0 / 60);
    }
    game.script->collect_garbage();
  };
  const auto theirs = [&] {
    for (int i = 0; i < kTicks; ++i) {
      game.engine->begin_tick();
      lua_rawgeti(L, LUA_REGISTRYINDEX, bare);
      lua_pushnumber(L, 1.0 / 60);
      lua_call(L, 1, 0);
    }
    game.script->collect_garbage();
  };
  std::vector<Result> results;
  const auto measure = [&](const char* mode, const char* name, const char* goal, const char* how) {
    game.script->send("mode", {Value(std::string(mode))});
    results.push_back({name, take_turns(kBlocks, ours, theirs).ratio, "ratio", goal, how});
  };
  measure("vector", "lua_nodes_ratio", "at most 1.3",
          "10 000 nodes by node:translate(velocity, dt) in update, over 10 000 calls of a lua_CFunction with three unchecked numbers to the same "
          "Engine::set_position; 31 blocks of 10 ticks in turn, median, thread processor time");
  measure("numbers", "lua_nodes_numbers_ratio", "", "the same by node:translate(x, y, z)");
  measure("property", "lua_nodes_property_ratio", "", "the same by node.position = node.position + velocity * dt");
  return results;
}

}  // namespace tumble::bench
