// Which islands are solved as heaps.
#include <algorithm>

#include "physics/dynamics/heap.h"

namespace tumble::dynamics {

namespace {

constexpr std::size_t kFewest = 8, kFewBodies = 3;  // contacts, or bodies
constexpr std::size_t kCrowd = 60;   // contacts from which on fast bodies are not looked at in each substep

bool plain(const Mover& mover) {
  if (!mover.pushable) return true;
  const Vec3 i = mover.inertia, m = mover.inverse_mass;
  return mover.turn_factor == Vec3{1, 1, 1} && m.x > 0 && m.x == m.y && m.x == m.z && i.x > 0 && i.y > 0 && i.z > 0 && !mover.bound;
}

}  // namespace

bool is_heap(const Island& island) {
  if ((island.contacts.size() < kFewest && island.movers.size() < kFewBodies) || !island.mechanisms.empty() || island.bouncy) return false;
  if (!island.looks.empty() && island.contacts.size() < kCrowd) return false;
  if (std::any_of(island.contacts.begin(), island.contacts.end(), [](const Contact* contact) { return contact->rolling > 0 || contact->spinning > 0; })) return false;
  return std::all_of(island.movers.begin(), island.movers.end(), [](const Mover* mover) { return plain(*mover); });
}

}  // namespace tumble::dynamics
