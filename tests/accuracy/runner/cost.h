// What a scene costs, as a ratio to stock Bullet at its defaults, measured in turns inside one process.
#pragma once

#include <optional>

#include "accuracy/case.h"

namespace tumble::accuracy {

struct Cost {
  double us_per_tick = 0;                // CPU time of this thread, median of the blocks
  std::optional<double> ratio, low, high;  // to stock at its defaults: median and bootstrap 95 %; empty where stock cannot run it
};

// Plays the recorded scene again, nothing read, beside stock Bullet, in blocks A B B A ... until `budget_ms` of CPU
// time are used or the scene ends. Nothing where the scene has too few steps to measure.
std::optional<Cost> measure_cost(const Recorder& scene, const EngineKind& engine, const Knobs& knobs, double budget_ms);

}  // namespace tumble::accuracy
