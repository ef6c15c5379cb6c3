#include "script/sandbox.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "script/bind.h"
#include "script/coroutines.h"
#include "script/dispatch.h"
#include "script/pairs.h"
#include "script/script.h"

namespace tumble {

namespace {

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

// A handler runs inside the hook that stopped the call, where no other hook runs: it could loop for ever.
int guarded_handler(lua_State* L) {
  if (script_of(L).over_time()) return 1;
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_insert(L, 1);
  lua_call(L, 1, 1);
  return 1;
}

int sandbox_xpcall(lua_State* L) {
  const int count = lua_gettop(L);
  luaL_checktype(L, 2, LUA_TFUNCTION);
  lua_pushvalue(L, 2);
  lua_pushcclosure(L, guarded_handler, 1);
  lua_replace(L, 2);
  lua_pushboolean(L, 1);
  lua_pushvalue(L, 1);
  lua_rotate(L, 3, 2);
  const int status = lua_pcallk(L, count - 2, LUA_MULTRET, 2, 2, finish_pcall);
  return finish_pcall(L, status, 2);
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

// ---- library functions that count to whatever they are told, in C, where no watchdog reaches

constexpr lua_Integer kMostEntries = 10'000'000;

int call_original(lua_State* L) {
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_insert(L, 1);
  lua_call(L, lua_gettop(L) - 1, LUA_MULTRET);
  return lua_gettop(L);
}

// For functions whose first argument is the list.
int bounded_list(lua_State* L) {
  if (lua_istable(L, 1) && luaL_len(L, 1) > kMostEntries) return luaL_error(L, "a list of at most %d entries expected, got %I", static_cast<int>(kMostEntries), luaL_len(L, 1));
  return call_original(L);
}

int bounded_move(lua_State* L) {
  const lua_Integer from = luaL_checkinteger(L, 2), to = luaL_checkinteger(L, 3);
  if (to > from && static_cast<lua_Unsigned>(to) - static_cast<lua_Unsigned>(from) > static_cast<lua_Unsigned>(kMostEntries))
    return luaL_error(L, "table.move: at most %d entries expected", static_cast<int>(kMostEntries));
  return call_original(L);
}

int bounded_concat(lua_State* L) {
  const lua_Integer from = luaL_optinteger(L, 3, 1), to = luaL_opt(L, luaL_checkinteger, 4, luaL_len(L, 1));
  if (to > from && static_cast<lua_Unsigned>(to) - static_cast<lua_Unsigned>(from) > static_cast<lua_Unsigned>(kMostEntries))
    return luaL_error(L, "table.concat: at most %d entries expected", static_cast<int>(kMostEntries));
  return call_original(L);
}

int bounded_rep(lua_State* L) {
  std::size_t size = 0, gap = 0;
  luaL_checklstring(L, 1, &size);
  luaL_optlstring(L, 3, "", &gap);
  if (size + gap == 0) return lua_pushliteral(L, ""), 1;
  return call_original(L);
}

// Puts `wrapper` around the function of that name in the table on top.
void wrap_function(lua_State* L, const char* name, lua_CFunction wrapper) {
  lua_getfield(L, -1, name);
  lua_pushcclosure(L, wrapper, 1);
  lua_setfield(L, -2, name);
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
  wrap_function(L, "rep", bounded_rep);
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
  copy_library(L, "coroutine", {}, {{"resume", sandbox_resume}, {"wrap", sandbox_wrap}, {"close", sandbox_close}});
  make_read_only(L, "coroutine");
  lua_setfield(L, globals, "coroutine");
  for (const char* name : {"table", "utf8"}) {
    copy_library(L, name, {}, {});
    if (name[0] == 't') {
      for (const char* list : {"insert", "remove", "sort", "unpack"}) wrap_function(L, list, bounded_list);
      wrap_function(L, "move", bounded_move);
      wrap_function(L, "concat", bounded_concat);
    }
    make_read_only(L, name);
    lua_setfield(L, globals, name);
  }
  lua_settop(L, all - 1);
}

}  // namespace tumble
