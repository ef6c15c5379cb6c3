// Stops a call into scripts that runs too long.
#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "script/lua.h"

namespace tumble {

// A thread of its own looks at the calling thread's CPU time (a busy machine stops nobody) and, once the limit has
// passed, sets a hook on the running coroutine, which raises an error there. No hook is set before that: a permanent
// count hook would double the time of every script.
class Watchdog {
 public:
  explicit Watchdog(double limit_seconds);
  ~Watchdog();

  // Between these the limit holds; nested calls count as one.
  void enter(lua_State* L);
  void leave();
  // The coroutine that runs now.
  void set_running(lua_State* L) { running_.store(L); }
  bool tripped() const { return tripped_.load(); }
  // After the failure was reported: the next call begins with a full limit.
  void reset(lua_State* L);

 private:
  void watch();
  double cpu_seconds() const;
  static void hook(lua_State* L, lua_Debug* record);

  const double limit_;
  int depth_ = 0;
  std::atomic<lua_State*> running_{nullptr};
  std::atomic<bool> armed_{false}, tripped_{false}, ending_{false};
  std::atomic<double> deadline_{0};
  std::atomic<clockid_t> clock_{0};
  std::mutex mutex_;
  std::condition_variable wake_;
  std::thread thread_;
};

}  // namespace tumble
