#include "script/pairs.h"

#include <algorithm>
#include <cstring>
#include <vector>

#include "script/memory.h"
#include "script/script.h"
#include "script/types.h"

namespace tumble {

namespace {

// Rank: numbers, strings, booleans, objects. Objects by age.
struct KeyOrder {
  int rank = 0;
  double number = 0;
  const char* text = nullptr;
  std::size_t size = 0;
  std::uint64_t age = 0;
};

// Of a C function: its address, whose order within the program is fixed, or the closure's serial behind all of them.
std::uint64_t age_of_function(lua_State* L, int index) {
  constexpr std::uint64_t behind = std::uint64_t{1} << 62;
  if (!lua_iscfunction(L, index)) return behind + LuaMemory::serial(lua_topointer(L, index));
  const bool closure = lua_getupvalue(L, index, 1) != nullptr;
  if (!closure) return reinterpret_cast<std::uintptr_t>(lua_tocfunction(L, index));
  lua_pop(L, 1);
  return behind + LuaMemory::serial(lua_topointer(L, index));
}

std::uint64_t age_of(lua_State* L, int index) {
  switch (lua_type(L, index)) {
    case LUA_TTABLE: return LuaMemory::serial(lua_topointer(L, index));
    case LUA_TFUNCTION: return age_of_function(L, index);
    case LUA_TTHREAD: return LuaMemory::serial(static_cast<const char*>(lua_topointer(L, index)) - LUA_EXTRASPACE);
    default: return 0;
  }
}

std::uint64_t age_of_node(Script& script, NodeId node) {
  const SceneNode* n = script.live_engine().scene.get(node);
  return n ? n->serial : (std::uint64_t{node.generation} << 32 | node.index);
}

// Objects: those of nodes and joints by the age of these, which does not depend on when a script first saw them (a
// frame() may have, and pictures are drawn at any rate); values by their own.
void order_object(lua_State* L, int index, KeyOrder& order) {
  Script& script = script_of(L);
  const Tag tag = tag_at(L, index);
  order.rank = 4;
  order.number = tag_index(tag);
  if (tag == Tag::node) {
    order.age = age_of_node(script, *object_at<NodeId>(L, index, tag));
  } else if ((tag >= Tag::body && tag <= Tag::animation) || tag == Tag::children) {
    order.age = age_of_node(script, object_at<ComponentData>(L, index, tag)->node);
  } else if (tag == Tag::joint) {
    const JointRecord* joint = script.live_engine().joint(*object_at<JointRef>(L, index, tag));
    order.age = joint ? joint->serial : 0;
  } else {
    order.age = static_cast<Object<int>*>(lua_touserdata(L, index))->serial;
  }
}

KeyOrder order_of(lua_State* L, int index) {
  KeyOrder order;
  switch (lua_type(L, index)) {
    case LUA_TNUMBER: order.number = lua_tonumber(L, index); break;
    case LUA_TSTRING:
      order.rank = 1;
      order.text = lua_tolstring(L, index, &order.size);
      break;
    case LUA_TBOOLEAN: order.rank = lua_toboolean(L, index) ? 3 : 2; break;
    case LUA_TUSERDATA: order_object(L, index, order); break;
    default:
      order.rank = 4 + lua_type(L, index);   // tables, functions, coroutines
      order.age = age_of(L, index);
      break;
  }
  return order;
}

bool before(const KeyOrder& a, const KeyOrder& b) {
  if (a.rank != b.rank) return a.rank < b.rank;
  if (a.rank == 0) return a.number < b.number;
  if (a.rank == 4 && a.number != b.number) return a.number < b.number;
  if (a.rank == 1) {
    const int c = std::memcmp(a.text, b.text, std::min(a.size, b.size));
    return c != 0 ? c < 0 : a.size < b.size;
  }
  return a.age < b.age;
}

// Is Lua's own order the fixed one already, as in any plain list? Costs no memory.
bool in_order(lua_State* L, int index) {
  KeyOrder last;
  bool first = true, ordered = true;
  for (lua_pushnil(L); lua_next(L, index); lua_pop(L, 1)) {
    const KeyOrder order = order_of(L, -2);
    if (!first && !before(last, order)) {
      ordered = false;
      lua_pop(L, 2);
      break;
    }
    last = order;
    first = false;
  }
  return ordered;
}

int step_plain(lua_State* L) {
  lua_settop(L, 2);
  if (lua_next(L, 1)) return 2;
  lua_pushnil(L);
  return 1;
}

// Walks the list of keys in upvalue 1; upvalue 2 counts. Keys that were removed meanwhile are passed over.
int step_sorted(lua_State* L) {
  for (;;) {
    const lua_Integer i = lua_tointeger(L, lua_upvalueindex(2)) + 1;
    lua_pushinteger(L, i);
    lua_replace(L, lua_upvalueindex(2));
    if (lua_rawgeti(L, lua_upvalueindex(1), i) == LUA_TNIL) return 1;
    lua_pushvalue(L, -1);
    if (lua_rawget(L, 1) != LUA_TNIL) return 2;
    lua_pop(L, 2);
  }
}

}  // namespace

int sandbox_pairs(lua_State* L) {
  luaL_checkany(L, 1);
  if (luaL_getmetafield(L, 1, "__pairs") != LUA_TNIL) {
    lua_pushvalue(L, 1);
    lua_call(L, 1, 3);
    return 3;
  }
  luaL_checktype(L, 1, LUA_TTABLE);
  if (in_order(L, 1)) {
    lua_pushcfunction(L, step_plain);
  } else {
    push_sorted_keys(L, 1);
    lua_pushinteger(L, 0);
    lua_pushcclosure(L, step_sorted, 2);
  }
  lua_pushvalue(L, 1);
  lua_pushnil(L);
  return 3;
}

// The key after the given one in the fixed order: a walk over the table, without memory.
int sandbox_next(lua_State* L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  lua_settop(L, 2);
  const bool from_start = lua_isnil(L, 2);
  const KeyOrder given = from_start ? KeyOrder{} : order_of(L, 2);
  lua_pushnil(L);  // 3: the best so far
  bool found = false;
  KeyOrder best;
  for (lua_pushnil(L); lua_next(L, 1); lua_pop(L, 1)) {
    const KeyOrder order = order_of(L, -2);
    if (!from_start && (!before(given, order) || lua_rawequal(L, -2, 2))) continue;
    if (found && !before(order, best)) continue;
    found = true;
    best = order;
    lua_pushvalue(L, -2);
    lua_replace(L, 3);
  }
  if (!found) return lua_pushnil(L), 1;
  lua_pushvalue(L, 3);
  lua_pushvalue(L, 3);
  lua_rawget(L, 1);
  return 2;
}

void push_sorted_keys(lua_State* L, int index) {
  index = lua_absindex(L, index);
  lua_newtable(L);
  const int keys = lua_gettop(L);
  std::vector<std::pair<KeyOrder, lua_Integer>> order;
  lua_newtable(L);  // keys as Lua gives them
  for (lua_pushnil(L); lua_next(L, index); lua_pop(L, 1)) {
    order.emplace_back(order_of(L, -2), static_cast<lua_Integer>(order.size()) + 1);
    lua_pushvalue(L, -2);
    lua_rawseti(L, keys + 1, order.back().second);
  }
  std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return before(a.first, b.first); });
  for (std::size_t i = 0; i < order.size(); ++i) {
    lua_rawgeti(L, keys + 1, order[i].second);
    lua_rawseti(L, keys, static_cast<lua_Integer>(i) + 1);
  }
  lua_settop(L, keys);
}

}  // namespace tumble
