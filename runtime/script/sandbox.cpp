#include "script/sandbox.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "script/bind.h"
#include "script/dispatch.h"
#include "script/memory.h"
#include "script/script.h"

namespace tumble {

namespace {

// ---- the order of keys

// Rank: numbers, strings, booleans, objects. Objects by age.
struct KeyOrder {
  int rank = 0;
  double number = 0;
  const char* text = nullptr;
  std::size_t size = 0;
  std::uint64_t age = 0;
};

std::uint64_t age_of(lua_State* L, int index) {
  if (const NodeId* node = object_at<NodeId>(L, index, Tag::node)) {
    const SceneNode* n = script_of(L).live_engine().scene.get(*node);
    return n ? n->serial : (std::uint64_t{node->generation} << 32 | node->index);
  }
  switch (lua_type(L, index)) {
    case LUA_TTABLE: return LuaMemory::serial(lua_topointer(L, index));
    case LUA_TFUNCTION: return lua_iscfunction(L, index) ? 0 : LuaMemory::serial(lua_topointer(L, index));
    case LUA_TTHREAD: return LuaMemory::serial(static_cast<const char*>(lua_topointer(L, index)) - LUA_EXTRASPACE);
    default: return 0;
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
    case LUA_TUSERDATA: order.rank = 4; order.age = age_of(L, index); break;
    default: order.rank = 5; order.age = age_of(L, index); break;
  }
  return order;
}

bool before(const KeyOrder& a, const KeyOrder& b) {
  if (a.rank != b.rank) return a.rank < b.rank;
  if (a.rank == 0) return a.number < b.number;
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

// ---- texts without addresses

int sandbox_tostring(lua_State* L) {
  luaL_checkany(L, 1);
  switch (lua_type(L, 1)) {
    case LUA_TTABLE:
    case LUA_TFUNCTION:
    case LUA_TTHREAD:
      if (luaL_getmetafield(L, 1, "__tostring") != LUA_TNIL) {
        lua_pushvalue(L, 1);
        lua_call(L, 1, 1);
      } else if (luaL_getmetafield(L, 1, "__name") == LUA_TSTRING) {
        return 1;
      } else {
        lua_pushstring(L, luaL_typename(L, 1));
      }
      return 1;
    default: luaL_tolstring(L, 1, nullptr); return 1;
  }
}

int sandbox_print(lua_State* L) {
  std::string line;
  const int count = lua_gettop(L);
  for (int i = 1; i <= count; ++i) {
    lua_pushcfunction(L, sandbox_tostring);
    lua_pushvalue(L, i);
    lua_call(L, 1, 1);
    std::size_t size = 0;
    const char* text = lua_tolstring(L, -1, &size);
    if (i > 1) line += '\t';
    if (text) line.append(text, size);
    lua_pop(L, 1);
  }
  script_of(L).log(LogLevel::print, line);
  return 0;
}

// string.format, whose %p shows addresses and whose %s goes through our tostring.
int sandbox_format(lua_State* L) {
  std::size_t size = 0;
  const char* format = luaL_checklstring(L, 1, &size);
  int argument = 1;
  for (std::size_t i = 0; i + 1 < size; ++i) {
    if (format[i] != '%') continue;
    if (format[++i] == '%') continue;
    ++argument;
    while (i < size && std::strchr("-+ #0123456789.", format[i]) && format[i]) ++i;
    if (i < size && format[i] == 'p') return luaL_error(L, "string.format: %%p shows addresses, which differ in every run; use %%s");
    if (i < size && format[i] == 's' && !lua_isnone(L, argument) && lua_type(L, argument) != LUA_TSTRING) {
      lua_pushcfunction(L, sandbox_tostring);
      lua_pushvalue(L, argument);
      lua_call(L, 1, 1);
      lua_replace(L, argument);
    }
  }
  const int count = lua_gettop(L);
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_insert(L, 1);
  lua_call(L, count, 1);
  return 1;
}

// ---- metatables

int sandbox_setmetatable(lua_State* L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  const int type = lua_type(L, 2);
  luaL_argexpected(L, type == LUA_TNIL || type == LUA_TTABLE, 2, "nil or table");
  if (type == LUA_TTABLE)
    for (const char* key : {"__gc", "__mode"}) {
      lua_pushstring(L, key);
      if (lua_rawget(L, 2) != LUA_TNIL)
        return luaL_error(L, "setmetatable: %s is not available: when memory is freed differs from run to run", key);
      lua_pop(L, 1);
    }
  if (luaL_getmetafield(L, 1, "__metatable") != LUA_TNIL) return luaL_error(L, "setmetatable: this table's metatable is locked");
  lua_settop(L, 2);
  lua_setmetatable(L, 1);
  return 1;
}

// ---- protected calls: what the watchdog stopped stays stopped

int finish_pcall(lua_State* L, int status, lua_KContext extra) {
  Script& script = script_of(L);
  if (status != LUA_OK && status != LUA_YIELD) {
    if (script.over_time()) return lua_error(L);
    lua_pushboolean(L, 0);
    lua_pushvalue(L, -2);
    return 2;
  }
  return lua_gettop(L) - static_cast<int>(extra);
}

int sandbox_pcall(lua_State* L) {
  luaL_checkany(L, 1);
  lua_pushboolean(L, 1);
  lua_insert(L, 1);
  const int status = lua_pcallk(L, lua_gettop(L) - 2, LUA_MULTRET, 0, 0, finish_pcall);
  return finish_pcall(L, status, 0);
}

int sandbox_xpcall(lua_State* L) {
  const int count = lua_gettop(L);
  luaL_checktype(L, 2, LUA_TFUNCTION);
  lua_pushboolean(L, 1);
  lua_pushvalue(L, 1);
  lua_rotate(L, 3, 2);
  const int status = lua_pcallk(L, count - 2, LUA_MULTRET, 2, 2, finish_pcall);
  return finish_pcall(L, status, 2);
}

// ---- coroutines

// Resumes `co` with the `count` values on top of L; leaves its results there, or its error. True if it went well.
bool resume(lua_State* L, lua_State* co, int count, int& results) {
  Script& script = script_of(L);
  if (!lua_checkstack(co, count)) luaL_error(L, "too many arguments to resume");
  if (lua_status(co) == LUA_OK && lua_gettop(co) == 0) {
    lua_pop(L, count);
    lua_pushliteral(L, "cannot resume a coroutine that has ended");
    return false;
  }
  lua_xmove(L, co, count);
  lua_State* outer = script.stack();
  script.set_running(co);
  const int status = lua_resume(co, L, count, &results);
  script.set_running(outer);
  if (status == LUA_OK || status == LUA_YIELD) {
    luaL_checkstack(L, results + 1, "too many results");
    lua_xmove(co, L, results);
    return true;
  }
  lua_xmove(co, L, 1);
  return false;
}

lua_State* coroutine_at(lua_State* L, int index) {
  lua_State* co = lua_tothread(L, index);
  luaL_argexpected(L, co, index, "coroutine");
  return co;
}

int wrapped(lua_State* L) {
  lua_State* co = lua_tothread(L, lua_upvalueindex(1));
  int results = 0;
  if (resume(L, co, lua_gettop(L), results)) return results;
  if (lua_status(co) != LUA_OK && lua_status(co) != LUA_YIELD) lua_resetthread(co);
  return lua_error(L);
}

int sandbox_wrap(lua_State* L) {
  luaL_checktype(L, 1, LUA_TFUNCTION);
  lua_State* co = lua_newthread(L);
  lua_pushvalue(L, 1);
  lua_xmove(L, co, 1);
  lua_pushcclosure(L, wrapped, 1);
  return 1;
}

// ---- chance

int sandbox_random(lua_State* L) {
  Random& random = script_of(L).random();
  switch (lua_gettop(L)) {
    case 0: return lua_pushnumber(L, random.unit()), 1;
    case 1: {
      const lua_Integer high = luaL_checkinteger(L, 1);
      luaL_argcheck(L, high >= 1, 1, "interval is empty");
      return lua_pushinteger(L, random.between(1, high)), 1;
    }
    default: {
      const lua_Integer low = luaL_checkinteger(L, 1), high = luaL_checkinteger(L, 2);
      luaL_argcheck(L, low <= high, 2, "interval is empty");
      return lua_pushinteger(L, random.between(low, high)), 1;
    }
  }
}

// ---- a few that math lacks

int math_clamp(lua_State* L) {
  const double v = luaL_checknumber(L, 1), low = luaL_checknumber(L, 2), high = luaL_checknumber(L, 3);
  return lua_pushvalue(L, v < low ? 2 : v > high ? 3 : 1), 1;
}
int math_lerp(lua_State* L) {
  const double a = luaL_checknumber(L, 1), b = luaL_checknumber(L, 2), t = luaL_checknumber(L, 3);
  return lua_pushnumber(L, a + (b - a) * t), 1;
}
int math_round(lua_State* L) {
  const double v = std::round(luaL_checknumber(L, 1));
  if (lua_Integer i; lua_numbertointeger(v, &i)) return lua_pushinteger(L, i), 1;
  return lua_pushnumber(L, v), 1;
}
int math_sign(lua_State* L) {
  const double v = luaL_checknumber(L, 1);
  return lua_pushinteger(L, (v > 0) - (v < 0)), 1;
}
int math_approach(lua_State* L) {
  const double v = luaL_checknumber(L, 1), goal = luaL_checknumber(L, 2), step = std::abs(luaL_checknumber(L, 3));
  return lua_pushnumber(L, v < goal ? std::min(v + step, goal) : std::max(v - step, goal)), 1;
}

void copy_functions(lua_State* L, int from, int to, std::initializer_list<const char*> names) {
  for (const char* name : names) {
    lua_getfield(L, from, name);
    lua_setfield(L, to, name);
  }
}

// Copies a library without some names and adds some functions; leaves it on top.
void copy_library(lua_State* L, const char* name, std::initializer_list<const char*> without, std::initializer_list<luaL_Reg> with) {
  lua_newtable(L);
  lua_getglobal(L, name);
  for (lua_pushnil(L); lua_next(L, -2);) {
    lua_pushvalue(L, -2);
    lua_insert(L, -2);
    lua_rawset(L, -5);
  }
  lua_pop(L, 1);
  for (const char* one : without) {
    lua_pushnil(L);
    lua_setfield(L, -2, one);
  }
  for (const luaL_Reg& one : with) {
    lua_pushcfunction(L, one.func);
    lua_setfield(L, -2, one.name);
  }
}

}  // namespace

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

int boot_resume(lua_State* L) {
  lua_State* co = coroutine_at(L, 1);
  int results = 0;
  const bool ok = resume(L, co, lua_gettop(L) - 1, results);
  if (!ok) results = 1;
  lua_pushboolean(L, ok);
  lua_insert(L, -(results + 1));
  return results + 1;
}

// What the watchdog stopped stays stopped.
static int sandbox_resume(lua_State* L) {
  const int results = boot_resume(L);
  if (script_of(L).over_time()) {
    lua_settop(L, -1);
    return lua_error(L);
  }
  return results;
}

void open_sandbox(lua_State* L, int globals) {
  globals = lua_absindex(L, globals);
  lua_pushglobaltable(L);
  const int all = lua_gettop(L);
  copy_functions(L, all, globals, {"assert", "error", "ipairs", "select", "tonumber", "type", "getmetatable", "rawequal", "rawget", "rawlen"});
  for (const luaL_Reg& one : std::initializer_list<luaL_Reg>{{"pairs", sandbox_pairs},
                                                             {"next", sandbox_next},
                                                             {"tostring", sandbox_tostring},
                                                             {"print", sandbox_print},
                                                             {"setmetatable", sandbox_setmetatable},
                                                             {"pcall", sandbox_pcall},
                                                             {"xpcall", sandbox_xpcall}}) {
    lua_pushcfunction(L, one.func);
    lua_setfield(L, globals, one.name);
  }
  copy_library(L, "string", {"dump"}, {});
  lua_getfield(L, -1, "format");
  lua_pushcclosure(L, sandbox_format, 1);
  lua_setfield(L, -2, "format");
  // Methods on strings go through the same table, and its metatable is out of reach.
  lua_pushliteral(L, "");
  lua_getmetatable(L, -1);
  lua_pushvalue(L, -3);
  lua_setfield(L, -2, "__index");
  lua_pushliteral(L, "string");
  lua_setfield(L, -2, "__metatable");
  lua_pop(L, 2);
  make_read_only(L, "string");
  lua_setfield(L, globals, "string");
  copy_library(L, "math", {"randomseed"}, {{"random", sandbox_random}, {"clamp", math_clamp}, {"lerp", math_lerp}, {"round", math_round}, {"sign", math_sign}, {"approach", math_approach}});
  make_read_only(L, "math");
  lua_setfield(L, globals, "math");
  copy_library(L, "coroutine", {}, {{"resume", sandbox_resume}, {"wrap", sandbox_wrap}});
  make_read_only(L, "coroutine");
  lua_setfield(L, globals, "coroutine");
  for (const char* name : {"table", "utf8"}) {
    copy_library(L, name, {}, {});
    make_read_only(L, name);
    lua_setfield(L, globals, name);
  }
  lua_settop(L, all - 1);
}

}  // namespace tumble
