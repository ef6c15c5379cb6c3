// What scripts may use of Lua itself: nothing that reaches outside the game or differs from run to run.
#pragma once

#include "script/lua.h"

namespace tumble {

// Fills the table at `globals` with Lua's functions and libraries in the form that games get.
//   No address shows in any text. No io, os, debug, load, rawset; no __gc, no weak tables; no bytecode.
void open_sandbox(lua_State* L, int globals);

}  // namespace tumble
