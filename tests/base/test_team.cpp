#include "base/team.h"

#include <catch2/catch.hpp>

#include <numeric>

using namespace tumble;

TEST_CASE("team: each part is done once, by any number of threads", "[base]") {
  for (const int threads : {1, 2, 5}) {
    Team team(threads);
    for (const std::size_t count : {0, 1, 7, 64, 1000, 4097})
      for (const std::size_t grain : {1, 3, 64}) {
        std::vector<int> done(count, 0);
        team.each(count, grain, [&](std::size_t from, std::size_t to) {
          for (std::size_t i = from; i < to; ++i) ++done[i];
        });
        CHECK(std::all_of(done.begin(), done.end(), [](int times) { return times == 1; }));
      }
  }
}

TEST_CASE("team: many short pieces of work follow one another", "[base]") {
  Team team(2);
  std::vector<double> values(500);
  std::iota(values.begin(), values.end(), 0.0);
  for (int round = 0; round < 5000; ++round)
    team.each(values.size(), 50, [&](std::size_t from, std::size_t to) {
      for (std::size_t i = from; i < to; ++i) values[i] += 1;
    });
  for (std::size_t i = 0; i < values.size(); ++i) CHECK(values[i] == static_cast<double>(i) + 5000);
}

TEST_CASE("team: one that had nothing to do ends as well", "[base]") {
  Team never(4);
  Team once(4);
  int sum = 0;
  once.each(3, 10, [&](std::size_t from, std::size_t to) { sum += static_cast<int>(to - from); });
  CHECK(sum == 3);
}
