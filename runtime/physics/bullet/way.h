// A body's way through the step that is over, as far as its ends and the velocities there tell.
//
// Free flight is a parabola, and told exactly. What was hit or led on its way did something else in between: then it is
// the parabola with those ends, or, where the velocities do not fit to them, a straight line.
#pragma once

#include "physics/bullet/body_state.h"

namespace tumble {

class Way {
 public:
  Way(const BodyState& body, double seconds);
  // Where Bullet's frame of the body was at a part of the step, 0 to 1.
  btTransform at(double part) const;

 private:
  Vec3 from_, along_, bend_;  // at s: from + along s + bend s^2
  Quat turned_;               // at the start
  Vec3 spin_;                 // by how much it turned, by its angular velocity, rad
  Quat rest_;                 // and what it turned beside that
};

// From its place when the step began to that when it ended, m; zero of what rests.
Vec3 straight_way(const BodyState& body);

}  // namespace tumble
