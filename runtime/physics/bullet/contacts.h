// Which bodies touch, from step to step, and the events that follow: each pair that begins ends exactly once.
#pragma once

#include <memory>
#include <vector>

#include "physics/bullet/collision.h"

namespace tumble {

// Two bodies that touch, or one in the other's triggers; it lives as long as they do so.
struct Pair {
  BodyState *a = nullptr, *b = nullptr;  // a is the older
  bool trigger = false;
  bool told = false;           // has its enter been told?
  std::uint64_t seen = 0;      // the last step in which they touched
  double depth = 0;            // smallest distance in that step, m
  std::size_t index = 0;       // in the book
  ContactEvent event;          // of that step; ask told()
  KeptContact* kept = nullptr; // where it is read from, when it is asked for
  bool unread = false;
  EventKind kind = EventKind::enter;  // of the last step
  // Of a trigger, in the step in which it was found:
  double inside = 1;           // a part of the step at which they touched
  double left = 0;             // if they do not any more at its end: since when, s before that, below 0
};

class ContactBook {
 public:
  void begin_step() { ++step_; }
  // After a step: what was found and solved.
  void observe(Collision& collision);
  // Contacts of these, the only ones that can have changed.
  void end_step(double seconds, const std::vector<BodyState*>& awake, const std::vector<BodyState*>& carriers, Events& events);
  // The body leaves or jumps: its pairs end now.
  void end_pairs(BodyState& body, Events& events);
  int touching() const;        // pairs of solids
  const std::vector<std::unique_ptr<Pair>>& pairs() const { return pairs_; }

 private:
  Pair* find(const BodyState& older, const BodyState& younger, bool trigger);
  Pair* find_any(const BodyState& a, const BodyState& b, bool trigger);
  Pair& make(BodyState& a, BodyState& b, bool trigger);
  void drop(Pair& pair);
  Pair& pair_of(BodyState& a, BodyState& b, bool trigger);
  void observe(const btPersistentManifold& manifold);

  std::vector<std::unique_ptr<Pair>> pairs_;
  std::uint64_t step_ = 0;
};

// Two bodies that touched go on touching up to this distance, m: a resting body's contacts breathe.
constexpr double kStillTouching = 0.005;
// Most contacts stay and nobody asks: what there is to tell of them is found out when somebody does.
const ContactEvent& told(Pair& pair);
// The event as `body` sees it, as if it were a.
ContactEvent seen_from(Pair& pair, const BodyState& body);
// The contact that it is read from is about to go.
void lose_contact(Pair& pair);

}  // namespace tumble
