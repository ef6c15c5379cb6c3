#include "base/hash.h"

#include <bit>
#include <catch2/catch.hpp>
#include <set>

using namespace tumble;

TEST_CASE("hash: equal input gives equal values, other order another one", "[base]") {
  CHECK(Hash().add(1.0).add(2.0).value() == Hash().add(1.0).add(2.0).value());
  CHECK(Hash().add(1.0).add(2.0).value() != Hash().add(2.0).add(1.0).value());
  CHECK(Hash().add(std::string_view("ab")).add(std::string_view("c")).value() !=
        Hash().add(std::string_view("a")).add(std::string_view("bc")).value());
}

TEST_CASE("hash: minus zero and zero are one number", "[base]") { CHECK(Hash().add(-0.0).value() == Hash().add(0.0).value()); }

TEST_CASE("hash: numbers that differ in one bit give values that differ in about half", "[base]") {
  double changed = 0;
  for (int bit = 0; bit < 64; ++bit) {
    const std::uint64_t word = 0x123456789abcdefULL;
    changed += std::popcount(Hash().add(word).value() ^ Hash().add(word ^ (std::uint64_t{1} << bit)).value());
  }
  CHECK(changed / 64 == Approx(32).margin(4));
}

TEST_CASE("hash: ten thousand neighbours do not collide", "[base]") {
  std::set<std::uint64_t> values;
  for (int i = 0; i < 10000; ++i) values.insert(Hash().add(Vec3{i * 1e-9, 0, 1}).value());
  CHECK(values.size() == 10000);
}
