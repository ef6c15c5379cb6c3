// Bullet's collision world and islands. Motion is ours (solver.h): one pass here finds what may touch during a whole step.
#pragma once

#include <vector>

#include "physics/bullet/body_pair.h"

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

// Manifolds keep points up to the distance that the pair that is looked at may close in a step.
class PairDispatcher final : public btCollisionDispatcher {
 public:
  explicit PairDispatcher(btCollisionConfiguration* configuration);
  btPersistentManifold* getNewManifold(const btCollisionObject* a, const btCollisionObject* b) override;

  double seconds = 0;       // of the step that is to come
  double fall = 0;          // m: how far gravity alone takes a body in it
  bool triggers = false;    // are triggers looked at, or solids?
  double margin = 0;        // of the pair that is looked at, m
  std::vector<KeptContact*> kept;  // of bodies of one convex part; all others have manifolds
};

class StepWorld final : public btDiscreteDynamicsWorld {
 public:
  StepWorld(PairDispatcher& dispatcher, btBroadphaseInterface& broadphase, btSequentialImpulseConstraintSolver& solver,
            btCollisionConfiguration& configuration);

  // What may touch within the next `seconds`; then which islands sleep.
  void collide(double seconds, Vec3 gravity);
  // What is in triggers where everything is now.
  void collide_triggers();
  // Boxes of what may have moved, as far as it goes in the step to come; Bullet's own looks at everything.
  void updateAabbs() override;
  const btAlignedObjectArray<btRigidBody*>& movable() const { return m_nonStaticRigidBodies; }

  std::vector<btCollisionObject*> ghosts;  // that are in the world

 private:
  void enlarge(btCollisionObject& object);
  void wake_by_carriers();
  PairDispatcher& pairs_;
};

}  // namespace tumble
