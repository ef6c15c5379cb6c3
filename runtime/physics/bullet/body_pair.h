// Two bodies of one convex part each whose boxes overlap: the most frequent pair by far, and all our own. Its contact is
// kept here from step to step as the solver wants it; no manifold of Bullet's is made.
#pragma once

#include <memory>
#include <vector>

#include "physics/bullet/body_state.h"
#include "physics/dynamics/contact.h"
#include "physics/pairs/collide.h"

namespace tumble {

// Between steps arms are about the centres of mass of both bodies, impulses are forces.
struct KeptContact {
  BodyState *a, *b;
  std::size_t index = 0;       // in the list of those that the last look found
  dynamics::Contact contact;
  Pair* pair = nullptr;        // in the book, while they touch
  bool touching = false;       // after the step
  double* margin = nullptr;    // of the pair's last look
  // What is here is not what a look would find: the next step looks anew.
  void spoil() { *margin = -1; }
};

class BodyPair {
 public:
  // Of two bodies with `convex`. `found` gets its contact in each look that finds points.
  BodyPair(BodyState& a, BodyState& b, std::vector<KeptContact*>& found) : a_(a), b_(b), found_(found) {}
  ~BodyPair();
  BodyPair(const BodyPair&) = delete;
  BodyPair& operator=(const BodyPair&) = delete;

  // What may touch within a step in which what pulls them takes them nearer by so much (m). `margin` is asked for only where the last
  // look does not hold any more. Looks of different pairs do not depend on each other.
  template <class Margin>
  void look(double fall, const Margin& margin) {
    if (!still_holds(fall)) look_anew(margin());
  }
  // After a look: is there anything? Then it is told.
  bool tell() {
    if (near_) add_to_found();
    return near_;
  }
  void spoil() { margin_ = -1; }
  const dynamics::Contact& contact() const { return kept_->contact; }  // after a look that found points

 private:
  bool still_holds(double fall) const;
  void look_anew(double margin);
  void write(const pairs::Manifold& found);
  void add_to_found();

  BodyState &a_, &b_;
  std::vector<KeptContact*>& found_;
  std::unique_ptr<KeptContact> kept_;
  pairs::Cache cache_;
  double margin_ = -1;         // of the last look, m; below 0 where there was none
  double travel_ = 0;          // of both bodies, by then
  unsigned placed_ = 0;        // likewise
  bool near_ = false;          // did it find points?
};

}  // namespace tumble
