#include "script/coroutines.h"

#include "script/script.h"
#include "script/types.h"

namespace tumble {

namespace {

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

}  // namespace

int sandbox_wrap(lua_State* L) {
  luaL_checktype(L, 1, LUA_TFUNCTION);
  lua_State* co = lua_newthread(L);
  lua_pushvalue(L, 1);
  lua_xmove(L, co, 1);
  lua_pushcclosure(L, wrapped, 1);
  return 1;
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
int sandbox_resume(lua_State* L) {
  const int results = boot_resume(L);
  if (script_of(L).over_time()) {
    lua_settop(L, -1);
    return lua_error(L);
  }
  return results;
}


int sandbox_close(lua_State* L) {
  lua_State* co = coroutine_at(L, 1);
  lua_Debug record;
  const bool idle = lua_status(co) == LUA_YIELD || (lua_status(co) == LUA_OK && !lua_getstack(co, 0, &record)) || lua_status(co) > LUA_YIELD;
  if (!idle) return luaL_error(L, "cannot close a running coroutine");
  Script& script = script_of(L);
  lua_State* outer = script.stack();
  script.set_running(co);
  const int status = lua_resetthread(co);
  script.set_running(outer);
  if (script.over_time()) return luaL_error(L, "stopped while closing a coroutine");
  lua_pushboolean(L, status == LUA_OK);
  if (status == LUA_OK) return 1;
  lua_xmove(co, L, 1);
  return 2;
}

}  // namespace tumble
