#include "base/fixed_clock.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace tumble {

FixedClock::FixedClock(double tick_seconds, int most_ticks) : tick_(tick_seconds), most_(most_ticks) {
  assert(tick_seconds > 0 && most_ticks >= 1);
}

void FixedClock::begin_frame(double seconds) {
  rest_ += std::max(seconds, 0.0);
  // Not rest_ / tick_ alone: its rounding could count a tick that is not there yet.
  const double whole = std::floor((rest_ - std::fmod(rest_, tick_)) / tick_ + 0.5);
  rest_ = std::fmod(rest_, tick_);
  const double due = due_ + whole;
  due_ = static_cast<int>(std::min(due, static_cast<double>(most_)));
  dropped_ += due - due_;
}

bool FixedClock::take_tick() {
  if (due_ == 0) return false;
  --due_;
  return true;
}

}  // namespace tumble
