// How names on objects and modules find their rows: one metatable a kind, made from the areas.
#pragma once

#include "script/bind.h"

namespace tumble {

// Puts a metatable for every tag into the registry, and every module into the table at `globals`.
void open_areas(lua_State* L, int globals);
// Puts the functions of scripted rows in their modules, from the table { task = { after = ... } } at `exports`.
void provide_scripted(lua_State* L, int exports);
// A table whose content can be read and not written; writing names the way out. Leaves it in place of the table on top.
void make_read_only(lua_State* L, const char* name);
// Throws "node 'ball' has no 'apply_impulse'; it belongs to the body: ...".
[[noreturn]] void fail_unknown(lua_State* L, const Area& area, const std::string& owner, const std::string& name);

}  // namespace tumble
