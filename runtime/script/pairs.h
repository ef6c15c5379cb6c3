// The order in which scripts walk tables: the same in every run.
#pragma once

#include "script/lua.h"

namespace tumble {

// pairs and next visit numbers in ascending order, strings by their bytes, false, true, then objects kind by kind, in each
// kind oldest first (nodes, their bodies and joints by the age of the node or joint). Why, and what it costs: docs/decisions/0005-order-of-pairs.md.
int sandbox_pairs(lua_State* L);
int sandbox_next(lua_State* L);
// The keys of the table at `index` in that order, as a list on top of the stack.
void push_sorted_keys(lua_State* L, int index);

}  // namespace tumble
