// Pairs of occupants whose boxes overlap and that may meet, and which of them a step has to look at: those of which at
// least one side is awake. A pair is there exactly as long as the boxes overlap, so that none is looked up.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "physics/bullet/body_pair.h"
#include "physics/bullet/boxes.h"

namespace tumble {

struct Overlap {
  enum Kind : unsigned char { bodies, solids, triggers };  // two of one convex part each; any other two; one is a trigger
  Occupant *a = nullptr, *b = nullptr;
  std::uint32_t at_a = 0, at_b = 0;             // where it is in their lists
  std::uint32_t place = kNowhere;               // in the list of active ones
  Kind kind = bodies;
  std::optional<BodyPair> pair;                 // of kind `bodies`
  btCollisionAlgorithm* algorithm = nullptr;    // of the others, once they were looked at

  static constexpr std::uint32_t kNowhere = ~0u;
};

class Overlaps {
 public:
  // A pair costs about a kilobyte once it touches, and bodies in one spot make pairs by the square of their number:
  // beyond this many further pairs pass through each other, rather than take all memory, until there is room for them. A
  // pile of 8000 has 100 000.
  static constexpr std::size_t kMost = 300'000;

  explicit Overlaps(btCollisionDispatcher& dispatcher) : dispatcher_(dispatcher) {}
  ~Overlaps();
  const Boxes& boxes() const { return boxes_; }
  bool has_triggers() const { return triggers_ > 0; }
  void tidy() { boxes_.tidy(); }

  // Puts it in the world, or makes its box another.
  void set_box(Occupant& occupant, const btDbvtVolume& box);
  void leave(Occupant& occupant);
  // Who meets whom is asked again, and what was known of its pairs is forgotten.
  void renew(Occupant& occupant);
  void renew(BodyState& a, BodyState& b);  // of these two alone
  // Were pairs left out for want of room that there is now? Then all who are awake are to meet_again().
  bool left_out() const { return left_out_ && count() < kMost / 2; }
  template <class Bodies>
  void meet_again(const Bodies& bodies) {
    left_out_ = false;
    for (BodyState* body : bodies)
      for (Occupant* occupant : {&body->solid_box, &body->trigger_box}) meet_missing(*occupant);
  }

  // The body woke, or is to be looked at; or not any more.
  void stir(BodyState& body);
  void settle(BodyState& body);
  std::vector<Overlap*>& active(Overlap::Kind kind) { return active_[kind]; }
  // The contacts that the last look found, of bodies of one convex part.
  std::vector<KeptContact*> found;
  template <class F>
  void each(const F& f) {
    for (Overlap& overlap : all_)
      if (overlap.a) f(overlap);
  }

 private:
  void meet(Occupant& occupant, const btDbvtVolume* before);
  void meet_missing(Occupant& occupant);
  std::size_t count() const { return all_.size() - unused_.size(); }
  void add(Occupant& a, Occupant& b);
  void drop(Overlap& overlap);
  void activate(Overlap& overlap);
  void deactivate(Overlap& overlap);

  btCollisionDispatcher& dispatcher_;
  Boxes boxes_;
  int triggers_ = 0;           // occupants
  bool left_out_ = false, lacking_ = false;  // now; ever
  std::deque<Overlap> all_;
  std::vector<Overlap*> unused_;
  std::vector<Overlap*> active_[3];
};

}  // namespace tumble
