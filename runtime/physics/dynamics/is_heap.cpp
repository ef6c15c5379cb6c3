// Which islands are solved as heaps, and for how long at most.
#include <algorithm>
#include <cmath>

#include "physics/dynamics/heap.h"

namespace tumble::dynamics {

namespace {

constexpr std::size_t kFewest = 8, kFewBodies = 3;  // contacts, or bodies
constexpr std::size_t kCrowd = 60;   // contacts from which on fast bodies are not looked at in each substep
constexpr int kMostRounds = 80;
// Contacts times rounds: a tick is not to take seconds for one blow. Where bodies have more contacts than ever lie around
// one, they were put into each other, and there is nothing to be got right yet.
constexpr double kMostSolves = 1e6, kMostAround = 8;

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

int most_rounds(double contacts, double around, int least) {
  const double most = kMostSolves / std::max(1.0, contacts) * std::min(1.0, std::pow(kMostAround / around, 2));
  return static_cast<int>(std::clamp<double>(most, std::max(least, kFewRounds), std::max(least, kMostRounds)));
}

}  // namespace tumble::dynamics
