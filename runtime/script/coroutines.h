// Coroutines that tell the runtime which of them runs, so that the watchdog finds a loop in any of them.
#pragma once

#include "script/lua.h"

namespace tumble {

// coroutine.wrap and coroutine.resume of scripts: what the watchdog stopped stays stopped.
int sandbox_wrap(lua_State* L);
int sandbox_resume(lua_State* L);
// coroutine.close, whose __close functions the watchdog sees as well.
int sandbox_close(lua_State* L);
// coroutine.resume for boot's tasks, which report the failure themselves.
int boot_resume(lua_State* L);

}  // namespace tumble
