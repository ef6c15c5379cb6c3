// Lua's headers. Our Lua is compiled as C++, so they are included as C++: an error then runs destructors.
#pragma once

#include <lua.h>

#include <lauxlib.h>
#include <lualib.h>
