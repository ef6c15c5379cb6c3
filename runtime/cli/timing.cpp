#include "cli/timing.h"

#include <time.h>

#include <algorithm>

namespace tumble::cli {

namespace {

// The time that this program ran, not the time that passed: other programs do not count.
double processor_ms() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

}  // namespace

Timing time_ticks(Runtime& runtime, int ticks) {
  std::vector<double> times;
  while (static_cast<int>(times.size()) < ticks && !runtime.is_finished() && !runtime.wants_quit() && runtime.is_loaded()) {
    const double before = processor_ms();
    runtime.tick();
    times.push_back(processor_ms() - before);
  }
  if (times.empty()) return {};
  std::sort(times.begin(), times.end());
  const std::size_t count = times.size();
  return {static_cast<int>(count), times[count / 2], times[std::min(count - 1, count * 99 / 100)], times.back()};
}

}  // namespace tumble::cli
