// A 64-bit hash over bytes as they come, for the world hash and for declaration keys. Not for security.
#pragma once

#include <bit>
#include <cstdint>
#include <string_view>

#include "base/math.h"

namespace tumble {

// FNV-1a over 64-bit words, with a final mix (splitmix64's) so that close inputs differ everywhere.
class Hash {
 public:
  Hash& add(std::uint64_t word) {
    state_ = (state_ ^ word) * 0x100000001b3ULL;
    state_ ^= state_ >> 32;
    return *this;
  }
  // By bits, but -0 and 0 are one number.
  Hash& add(double number) { return add(std::bit_cast<std::uint64_t>(number == 0 ? 0.0 : number)); }
  Hash& add(Vec3 v) { return add(v.x).add(v.y).add(v.z); }
  Hash& add(Quat q) { return add(q.x).add(q.y).add(q.z).add(q.w); }
  Hash& add(std::string_view text) {
    for (const char c : text) add(static_cast<std::uint64_t>(static_cast<unsigned char>(c)));
    return add(static_cast<std::uint64_t>(text.size()));
  }
  std::uint64_t value() const {
    std::uint64_t z = state_ + 0x9e3779b97f4a7c15ULL;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
  }

 private:
  std::uint64_t state_ = 0xcbf29ce484222325ULL;
};

}  // namespace tumble
