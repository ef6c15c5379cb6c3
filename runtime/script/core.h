// What scripts/boot gets from the engine: the table `core`.
#pragma once

#include <string>
#include <utility>

#include "script/lua.h"

namespace tumble {

// Pushes the table; its `globals` is what games' files see.
void push_core(lua_State* L);
// Adds the functions that work on values to the table on top.
void push_value_functions(lua_State* L);
// Message and traceback of a failure that add_traceback joined.
std::pair<std::string, std::string> split_failure(lua_State* L, int index);

}  // namespace tumble
