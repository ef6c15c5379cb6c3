#include "physics/bullet/crowd.h"

#include <algorithm>

#include "base/hash.h"
#include "physics/dynamics/mover.h"

namespace tumble {

namespace {

constexpr double kDeep = 0.1;  // of the smaller one's extent; nothing that rests gets there
constexpr int kEnough = 24;    // deep contacts of a body, about; twelve balls of one size have room around another

bool is_deep(const KeptContact& kept) {
  return kept.a->mover && kept.b->mover && kept.contact.nearest() < -kDeep * std::min(kept.a->extent, kept.b->extent);
}

// In [0, 1), of the pair.
double lot(const KeptContact& kept) {
  return static_cast<double>(Hash().add(std::uint64_t{kept.a->serial}).add(std::uint64_t{kept.b->serial}).value() >> 11) * 0x1p-53;
}

}  // namespace

Crowd::Crowd(const std::vector<KeptContact*>& found) {
  for (const KeptContact* kept : found) {
    if (!is_deep(*kept)) continue;
    for (dynamics::Mover* mover : {kept->a->mover, kept->b->mover}) any_ |= ++mover->deep > kEnough;
  }
}

bool Crowd::leaves_out(const KeptContact& kept) const {
  if (!any_ || !is_deep(kept)) return false;
  const int least = std::min(kept.a->mover->deep, kept.b->mover->deep);  // many may lie on a large one
  return lot(kept) * least >= kEnough;
}

}  // namespace tumble
