// Fields that are described rather than bound: components, joints, and tables inside them.
#pragma once

#include "base/value.h"
#include "script/bind.h"

namespace tumble {

// __index and __newindex of an object whose key is no row: stack is (object, key[, value]). Throws Error for a name
// that neither the described struct nor, on nodes, an event has.
int index_described(lua_State* L, const Area& area);
int newindex_described(lua_State* L, const Area& area);
// A copy of the component, or of the table inside one or inside a joint, at `index`; nothing for any other object.
std::optional<Value> described_value(lua_State* L, int index);

// Arithmetic, equality and length of vec3, quat and color; `#node.children` and its entries; `#body.colliders`; sound.groups; freeing of hits.
void open_value_operators(lua_State* L);
void open_children(lua_State* L);
void open_views(lua_State* L);
void open_sound_groups(lua_State* L);
void open_hit_collection(lua_State* L);

}  // namespace tumble
