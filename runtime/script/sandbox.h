// What scripts may use of Lua itself: nothing that reaches outside the game or differs from run to run.
#pragma once

#include "script/lua.h"

namespace tumble {

// Fills the table at `globals` with Lua's functions and libraries in the form that games get.
//   pairs and next visit keys in a fixed order: numbers ascending, strings by their bytes, false, true, then everything
//   else oldest first (nodes by the age of the node). So tables keyed by nodes or tables are walked alike in every run.
//   No address shows in any text. No io, os, debug, load, rawset; no __gc, no weak tables; no bytecode.
void open_sandbox(lua_State* L, int globals);

// Sorted keys of the table at `index`, as a list on top of the stack.
void push_sorted_keys(lua_State* L, int index);

// coroutine.resume that tells the watchdog which coroutine runs: for boot's tasks.
int boot_resume(lua_State* L);

}  // namespace tumble
