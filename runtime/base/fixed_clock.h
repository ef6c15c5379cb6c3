// Real time cut into ticks of one length, for a loop that draws as often as it can.
//
// A frame that took long is caught up with, by so many ticks at most: a computer that is too slow slows the game down,
// where it would else fall further behind with each frame. Whole ticks are dropped then, and told; what is left of one is
// kept. Frames of any lengths that come to the same sum, none dropped, give the same ticks.
#pragma once

namespace tumble {

class FixedClock {
 public:
  // Ticks of so many seconds, above 0, and at most so many a frame, 1 or more.
  FixedClock(double tick_seconds, int most_ticks);

  // A frame begins, so many seconds after the last one; negative ones count as none. Ticks that the last frame did not
  // take are still due.
  void begin_frame(double seconds);
  // Takes a tick that is due in this frame; false where there is none, and the frame can be drawn.
  bool take_tick();
  // How much of the next tick has gone, 0 up to 1.
  double part_of_tick() const { return rest_ / tick_; }
  // Seconds that were dropped since the clock was made; always whole ticks.
  double dropped_seconds() const { return dropped_ * tick_; }

 private:
  double tick_, rest_ = 0;  // s
  double dropped_ = 0;      // ticks; a double, since a computer that slept for days may drop more than an int holds
  int most_, due_ = 0;
};

}  // namespace tumble
