#include "engine/random.h"

#include <catch2/catch.hpp>
#include <cstdint>
#include <limits>
#include <vector>

using namespace tumble;

TEST_CASE("random: splitmix64 of seed 0 gives the published numbers as state", "[engine]") {
  const std::array<std::uint64_t, 4> expected = {0xe220a8397b1dcdafULL, 0x6e789e6aa1b965f4ULL, 0x06c45d188009454fULL, 0xf88bb8a8724c81ecULL};
  CHECK(Random(0).state() == expected);
}

TEST_CASE("random: the first number follows from the state by the generator's formula", "[engine]") {
  Random random(7);
  const std::uint64_t product = random.state()[1] * 5;
  CHECK(random.next() == ((product << 7 | product >> 57) * 9));
}

TEST_CASE("random: the same seed gives the same numbers, another seed others", "[engine]") {
  Random a(5), b(5), c(6);
  for (int i = 0; i < 100; ++i) {
    const std::uint64_t number = a.next();
    CHECK(number == b.next());
    CHECK(number != c.next());
  }
}

TEST_CASE("random: unit numbers lie in [0, 1), evenly", "[engine]") {
  Random random(1);
  double sum = 0, squares = 0;
  constexpr int kCount = 100000;
  for (int i = 0; i < kCount; ++i) {
    const double u = random.unit();
    REQUIRE(u >= 0);
    REQUIRE(u < 1);
    sum += u;
    squares += u * u;
  }
  // Four standard errors: sqrt(1/12/n) of the mean, sqrt(4/45/n) of the mean square.
  CHECK(sum / kCount == Approx(0.5).margin(0.0037));
  CHECK(squares / kCount == Approx(1.0 / 3).margin(0.0038));
}

TEST_CASE("random: between takes every number of its range alike, ends included", "[engine]") {
  Random random(1);
  std::vector<int> counts(6);
  for (int i = 0; i < 60000; ++i) ++counts.at(static_cast<std::size_t>(random.between(-2, 3) + 2));

  double chi_square = 0;
  for (const int count : counts) chi_square += (count - 10000.0) * (count - 10000.0) / 10000;
  CHECK(chi_square < 20.5);  // one in a thousand for five degrees of freedom
}

TEST_CASE("random: between takes a range of one and the whole range", "[engine]") {
  Random random(1);
  CHECK(random.between(4, 4) == 4);
  CHECK_NOTHROW(random.between(std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max()));
}
