// Bullet's world, stepped one substep at a time by us: forces, damping, sleep and kinematic paths are not Bullet's.
#pragma once

#include "physics/bullet/bounce.h"

namespace tumble {

// Which pairs of objects are looked at at all; decided when their boxes first meet.
class PairFilter final : public btOverlapFilterCallback {
 public:
  bool needBroadphaseCollision(btBroadphaseProxy* a, btBroadphaseProxy* b) const override;
};

class StepWorld final : public btDiscreteDynamicsWorld {
 public:
  using btDiscreteDynamicsWorld::btDiscreteDynamicsWorld;

  void substep(double h);
  // After the contacts of a substep were read.
  void end_substep() { bounce_.forget(); }
  // The solver's randomness starts anew, so that a world does not depend on those before it.
  void seed() { static_cast<btSequentialImpulseConstraintSolver*>(getConstraintSolver())->setRandSeed(0); }

 private:
  Bounce bounce_;
};

}  // namespace tumble
