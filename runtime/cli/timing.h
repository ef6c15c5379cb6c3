// How long ticks take, by the processor's time of this program.
#pragma once

#include <vector>

#include "tumble/tumble.h"

namespace tumble::cli {

struct Timing {
  int ticks = 0;
  double median = 0, most_of_99 = 0, worst = 0;  // ms of one tick; most_of_99: only one in a hundred takes longer
};

// Ticks the game so often, or until it is finished.
Timing time_ticks(Runtime& runtime, int ticks);

}  // namespace tumble::cli
