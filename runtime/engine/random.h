// Seeded random numbers, the same on every machine: xoshiro256** (Blackman and Vigna 2018), seeded by splitmix64.
#pragma once

#include <array>
#include <cstdint>

namespace tumble {

class Random {
 public:
  explicit Random(std::uint64_t seed = 1);
  std::uint64_t next();
  double unit();                             // [0, 1), 53 bits
  std::int64_t between(std::int64_t low, std::int64_t high);  // inclusive, without bias
  const std::array<std::uint64_t, 4>& state() const { return state_; }

 private:
  std::array<std::uint64_t, 4> state_;
};

}  // namespace tumble
