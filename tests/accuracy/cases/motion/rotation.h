// Rotations seen from outside, frame by frame.
#pragma once

#include "accuracy/scenes.h"

namespace tumble::accuracy {

// The smallest rotation that takes `from` to `to`, as a world axis times an angle (at most half a turn).
Vec3 turn_between(Quat from, Quat to);

// An angle brought within half a turn of zero.
double within_half_turn(double angle);

// How far a body has turned by its poses against how far its velocity says, in rad. Whole turns cannot be seen in two
// poses: each step counts as the number of them that is nearest to what the velocity says.
class TurnWatch {
 public:
  TurnWatch(const Simulation& scene, BodyIndex body);
  void after_step(double seconds);
  double turned() const { return turned_; }
  double reported() const { return reported_; }

 private:
  const Simulation& scene_;
  BodyIndex body_;
  Quat rotation_;
  Vec3 velocity_;
  double turned_ = 0, reported_ = 0;
};

}  // namespace tumble::accuracy
