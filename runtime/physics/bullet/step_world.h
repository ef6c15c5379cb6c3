// Bullet's world, stepped one substep at a time by us: forces, damping, sleep and kinematic paths are not Bullet's.
#pragma once

#include "physics/bullet/bounce.h"

namespace tumble {

// Which pairs of objects are looked at at all; decided when their boxes first meet.
class PairFilter final : public btOverlapFilterCallback {
 public:
  // A pair costs about a kilobyte once it touches, and bodies in one spot make pairs by the square of their number:
  // beyond this many further pairs pass through each other, rather than take all memory. A pile of 8000 has 100 000.
  static constexpr int kMostPairs = 300'000;
  const btOverlappingPairCache* pairs = nullptr;

  bool needBroadphaseCollision(btBroadphaseProxy* a, btBroadphaseProxy* b) const override;
};

class StepWorld final : public btDiscreteDynamicsWorld {
 public:
  StepWorld(btDispatcher& dispatcher, btBroadphaseInterface& broadphase, btSequentialImpulseConstraintSolver& solver,
            btCollisionConfiguration& configuration);

  void substep(double h);
  // After the contacts of a substep were read.
  void end_substep() { bounce_.forget(); }
  // Boxes of what may have moved; Bullet's own looks at everything.
  void updateAabbs() override;
  const btAlignedObjectArray<btRigidBody*>& movable() const { return m_nonStaticRigidBodies; }

  std::vector<btCollisionObject*> ghosts;  // that are in the world

 private:
  Bounce bounce_;
};

}  // namespace tumble
