// Which bodies are awake. What sleeps costs a step nothing: nobody walks over it.
#pragma once

#include <vector>

#include "physics/bullet/overlaps.h"

namespace tumble {

class Awake {
 public:
  explicit Awake(Overlaps& overlaps) : overlaps_(overlaps) {}

  // Wakes a dynamic body and all that is joined to it; one that was awake begins its rest anew.
  void wake(BodyState& body);
  void sleep(BodyState& body);
  void leave(BodyState& body);          // out of the world
  // By age; who wakes is among them from the next sort() on in its place.
  const std::vector<BodyState*>& bodies() const { return bodies_; }
  void sort();
  // Puts each island to sleep in which all are still; `still` tells of a body.
  template <class F>
  void settle(int islands, const F& still) {
    restless_.assign(static_cast<std::size_t>(islands), false);
    for (BodyState* body : bodies_)
      if (!still(*body) && body->island >= 0) restless_[static_cast<std::size_t>(body->island)] = true;
    settle_restful();
  }
  // Who woke or fell asleep since the last call and is not as he was then, by age.
  std::vector<BodyState*> take_changes();

 private:
  void settle_restful();
  void lay_down(BodyState& body);
  void note(BodyState& body);

  Overlaps& overlaps_;
  std::vector<BodyState*> bodies_, changes_;
  std::vector<bool> restless_;
  bool sorted_ = true;
};

}  // namespace tumble
