#include "bench/bench.h"

#include <time.h>

#include <algorithm>

namespace tumble::bench {

namespace {
double ms_of(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}
}  // namespace

const std::vector<Bench>& all() {
  static const std::vector<Bench> list = {
      {"lua_nodes", lua_nodes}, {"lua_wall", lua_wall},   {"drawing", drawing},          {"reload", reload},
      {"first_frame", first_frame}, {"collector", collector}, {"static_nodes", static_nodes}, {"idle_physics", idle_physics},
  };
  return list;
}

double processor_ms() { return ms_of(CLOCK_THREAD_CPUTIME_ID); }
double wall_ms() { return ms_of(CLOCK_MONOTONIC); }

double percentile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  const auto last = static_cast<double>(values.size() - 1);
  return values[static_cast<std::size_t>(last * share + 0.5)];
}

double median(std::vector<double> values) { return percentile(std::move(values), 0.5); }

Turns take_turns(int blocks, const std::function<void()>& a, const std::function<void()>& b) {
  std::vector<double> times_a, times_b;
  for (int i = 0; i <= blocks; ++i) {
    const double begin = processor_ms();
    a();
    const double middle = processor_ms();
    b();
    const double end = processor_ms();
    if (i == 0) continue;
    times_a.push_back(middle - begin);
    times_b.push_back(end - middle);
  }
  const double of_a = median(times_a), of_b = median(times_b);
  return {of_a, of_b, of_a / of_b};
}

}  // namespace tumble::bench
