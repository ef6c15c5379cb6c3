#include "engine/random.h"

#include <bit>
#include <cassert>

namespace tumble {

Random::Random(std::uint64_t seed) {
  // splitmix64: also a seed of zero or one gives a state without long runs of zeros.
  for (std::uint64_t& word : state_) {
    std::uint64_t z = seed += 0x9e3779b97f4a7c15ULL;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    word = z ^ (z >> 31);
  }
}

std::uint64_t Random::next() {
  auto& s = state_;
  const std::uint64_t result = std::rotl(s[1] * 5, 7) * 9;
  const std::uint64_t shifted = s[1] << 17;
  s[2] ^= s[0];
  s[3] ^= s[1];
  s[1] ^= s[2];
  s[0] ^= s[3];
  s[2] ^= shifted;
  s[3] = std::rotl(s[3], 45);
  return result;
}

double Random::unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }

std::int64_t Random::between(std::int64_t low, std::int64_t high) {
  assert(low <= high);
  const std::uint64_t count = static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low) + 1;
  if (count == 0) return static_cast<std::int64_t>(next());  // the whole range
  // The lowest 2^64 mod count words would make some results likelier than others; draw again at those.
  const std::uint64_t surplus = (0 - count) % count;
  std::uint64_t word = next();
  while (word < surplus) word = next();
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(low) + word % count);
}

}  // namespace tumble
