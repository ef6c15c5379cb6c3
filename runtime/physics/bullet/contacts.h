// Which bodies touch, from step to step, and the events that follow: each pair that begins ends exactly once.
#pragma once

#include <memory>
#include <vector>

#include "physics/bullet/step_world.h"

namespace tumble {

// Two bodies that touch, or one in the other's triggers; it lives as long as they do so.
struct Pair {
  BodyState *a = nullptr, *b = nullptr;  // a is the older
  bool trigger = false;
  bool told = false;           // has its enter been told?
  std::uint64_t seen = 0;      // the last step in which they touched
  double depth = 0;            // smallest distance in that step, m
  std::size_t index = 0;       // in the book
  ContactEvent event;          // of that step
};

class ContactBook {
 public:
  void begin_step() { ++step_; }
  // After a step: what was found and solved.
  void observe(PairDispatcher& pairs);
  void end_step(Events& events);
  // The body leaves or jumps: its pairs end now.
  void end_pairs(BodyState& body, Events& events);
  int touching() const;        // pairs of solids
  const std::vector<std::unique_ptr<Pair>>& pairs() const { return pairs_; }

 private:
  Pair* find(const BodyState& a, const BodyState& b, bool trigger);
  Pair& make(BodyState& a, BodyState& b, bool trigger);
  void drop(Pair& pair);
  struct Found;
  void observe(const Found& found);
  void note(Pair& pair, const Found& found, bool swapped);
  static void read(btPersistentManifold& manifold, Found& found);
  static void read(const KeptContact& kept, Found& found);

  std::vector<std::unique_ptr<Pair>> pairs_;
  std::uint64_t step_ = 0;
};

// The event as `body` sees it, as if it were a.
ContactEvent seen_from(const Pair& pair, const BodyState& body);

}  // namespace tumble
