// Fields that are described rather than bound: components, joints, and tables inside them.
#pragma once

#include "script/bind.h"

namespace tumble {

// __index and __newindex of an object whose key is no row: stack is (object, key[, value]). Throws Error for a name
// that neither the described struct nor, on nodes, an event has.
int index_described(lua_State* L, const Area& area);
int newindex_described(lua_State* L, const Area& area);

// Arithmetic, equality and length of vec3, quat and color; `#node.children` and its entries; sound.groups; freeing of hits.
void open_value_operators(lua_State* L);
void open_children(lua_State* L);
void open_sound_groups(lua_State* L);
void open_hit_collection(lua_State* L);

}  // namespace tumble
