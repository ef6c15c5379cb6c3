// What `tumble bench` measures: figures with a name, a goal and the way they were got. Ratios are medians over blocks
// that took turns in one process, by processor time, so that a busy machine harms both sides alike.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace tumble::bench {

struct Result {
  std::string name;
  double value = 0;
  std::string unit;   // "ratio", "ms", "frames/s"
  std::string goal;   // "at most 1.3"; empty: only told
  std::string how;    // what was run, in a sentence
};

struct Bench {
  std::string name;   // as the part of the command line calls it
  std::function<std::vector<Result>()> run;
};
// In the order of the report.
const std::vector<Bench>& all();

std::vector<Result> lua_nodes();
std::vector<Result> lua_wall();
std::vector<Result> drawing();
std::vector<Result> reload();
std::vector<Result> first_frame();
std::vector<Result> collector();
std::vector<Result> static_nodes();
std::vector<Result> idle_physics();

// Of this thread, ms.
double processor_ms();
// That passed, ms.
double wall_ms();
double median(std::vector<double> values);
// The smallest value that a share of the others (0..1) does not exceed.
double percentile(std::vector<double> values, double share);
// Runs a and b in turn, `blocks` times each after one round to warm up; the median of a's times over the median of b's.
struct Turns { double a = 0, b = 0, ratio = 0; };  // a, b: medians, ms
Turns take_turns(int blocks, const std::function<void()>& a, const std::function<void()>& b);

}  // namespace tumble::bench
