#include "script/watchdog.h"

#include <pthread.h>
#include <time.h>

#include <chrono>

#include "script/script.h"
#include "script/types.h"

namespace tumble {

Watchdog::Watchdog(double limit_seconds) : limit_(limit_seconds), thread_([this] { watch(); }) {}

Watchdog::~Watchdog() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

double Watchdog::cpu_seconds() const {
  timespec t{};
  clock_gettime(clock_.load(), &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

void Watchdog::enter(lua_State* L) {
  if (depth_++ > 0) return;
  clockid_t clock{};
  pthread_getcpuclockid(pthread_self(), &clock);
  clock_ = clock;
  running_ = L;
  deadline_ = cpu_seconds() + limit_;
  armed_ = true;
}

void Watchdog::leave() {
  if (--depth_ == 0) armed_ = false;
}

void Watchdog::reset(lua_State* L) {
  tripped_ = false;
  lua_sethook(L, nullptr, 0, 0);
  deadline_ = cpu_seconds() + limit_;
}

void Watchdog::watch() {
  std::unique_lock lock(mutex_);
  while (!ending_) {
    wake_.wait_for(lock, std::chrono::milliseconds(50));
    if (ending_ || !armed_ || cpu_seconds() < deadline_) continue;
    tripped_ = true;
    // Lua documents lua_sethook as the one call that may come while a state runs (from a signal handler); here it
    // comes from a thread, and is repeated while the limit stays exceeded, since another coroutine may run by then.
    if (lua_State* L = running_.load()) lua_sethook(L, &Watchdog::hook, LUA_MASKCOUNT, 1);
  }
}

void Watchdog::hook(lua_State* L, lua_Debug*) {
  if (!script_of(L).over_time()) return lua_sethook(L, nullptr, 0, 0);
  luaL_where(L, 0);  // the function that the hook interrupts
  lua_pushfstring(L, "stopped: it ran for more than %f seconds of computing in one call; is a loop without an end in it?",
                  script_of(L).host().time_limit);
  lua_concat(L, 2);
  lua_error(L);
}

}  // namespace tumble
