// A contact of bodies that move far in a step against their size, while they are apart: looked for anew in each substep.
//
// A step's look finds one plane between two bodies. What flies past an edge of the other would be stopped by that plane
// where there is nothing left of the other; within a substep it does not get that far.
#pragma once

#include <optional>

#include "physics/bullet/body_state.h"
#include "physics/dynamics/contact.h"
#include "physics/pairs/collide.h"

namespace tumble {

class Chase {
 public:
  // Of two single convex parts; nothing where the bodies are slow, or where one of them is a mesh.
  struct Where {           // a body, and which of its parts: as Bullet tells it
    const BodyState& body;
    int part = -1, index = -1;
  };
  static std::optional<Chase> of(const Where& a, const Where& b, double apart, double seconds);

  // Makes the contact what it is now; it may be without points, and get some later.
  void look(dynamics::Contact& contact, double h);

 private:
  struct Part {
    pairs::Convex shape;
    Pose local;          // in the mover's frame
    Pose fixed;          // the mover's, of what does not move
    Pose pose(const dynamics::Mover& mover) const;
  };
  static bool find_part(const Where& where, Part& out);

  Part a_, b_;
  pairs::Cache cache_;
};

}  // namespace tumble
