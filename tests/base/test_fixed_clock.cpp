#include "base/fixed_clock.h"

#include <catch2/catch.hpp>

#include <random>

using namespace tumble;

namespace {

int ticks_of_frame(FixedClock& clock, double seconds) {
  clock.begin_frame(seconds);
  int ticks = 0;
  while (clock.take_tick()) ++ticks;
  return ticks;
}

}  // namespace

TEST_CASE("fixed clock: a tick comes when all of its time has gone, and what is over is kept", "[base]") {
  FixedClock clock(0.25, 4);

  CHECK(ticks_of_frame(clock, 0.125) == 0);
  CHECK(clock.part_of_tick() == 0.5);
  CHECK(ticks_of_frame(clock, 0.125) == 1);
  CHECK(clock.part_of_tick() == 0);
  CHECK(ticks_of_frame(clock, 0.625) == 2);
  CHECK(clock.part_of_tick() == 0.5);
  CHECK(ticks_of_frame(clock, 0) == 0);
  CHECK(ticks_of_frame(clock, -5) == 0);
  CHECK(clock.part_of_tick() == 0.5);
}

TEST_CASE("fixed clock: frames of random lengths give the ticks of their sum", "[base]") {
  constexpr double kTick = 1.0 / 60;
  FixedClock clock(kTick, 6);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> length(0, 6 * kTick);

  double sum = 0;
  int ticks = 0;
  for (int i = 0; i < 10000; ++i) {
    const double frame = length(random);
    sum += frame;
    ticks += ticks_of_frame(clock, frame);
  }

  // 500 s of sums of doubles are off by a millionth of a tick at most; this seed's sum is no nearer to a whole tick.
  CHECK(ticks == static_cast<int>(sum / kTick));
  CHECK(ticks + clock.part_of_tick() == Approx(sum / kTick).epsilon(1e-10));
  CHECK(clock.dropped_seconds() == 0);
}

TEST_CASE("fixed clock: beyond the most ticks of a frame whole ticks are dropped and told", "[base]") {
  FixedClock clock(0.25, 4);

  CHECK(ticks_of_frame(clock, 3.125) == 4);  // 12 and a half were due
  CHECK(clock.dropped_seconds() == 2);
  CHECK(clock.part_of_tick() == 0.5);
  CHECK(ticks_of_frame(clock, 0.25) == 1);   // and all is as before
  CHECK(ticks_of_frame(clock, 1.25) == 4);
  CHECK(clock.dropped_seconds() == 2.25);
}

TEST_CASE("fixed clock: a computer that slept for a year drops the year", "[base]") {
  FixedClock clock(1.0 / 60, 6);
  constexpr double kYear = 365.0 * 24 * 3600;

  CHECK(ticks_of_frame(clock, kYear) == 6);
  CHECK(clock.dropped_seconds() == Approx(kYear - 0.1).epsilon(0).margin(2.0 / 60));
}

TEST_CASE("fixed clock: ticks that a frame left are due in the next", "[base]") {
  FixedClock clock(0.25, 4);

  clock.begin_frame(0.75);
  CHECK(clock.take_tick());

  CHECK(ticks_of_frame(clock, 0.25) == 3);
  CHECK(clock.dropped_seconds() == 0);
}
