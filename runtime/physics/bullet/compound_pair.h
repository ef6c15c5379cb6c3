// A compound against anything: every child's contacts by the algorithm for its kind, each with a manifold of its own that
// lives on from pass to pass, also with a distance threshold (convex_pair.h says why Bullet's own does not do).
#pragma once

#include <BulletCollision/CollisionDispatch/btActivatingCollisionAlgorithm.h>

#include "physics/bullet/convert.h"

namespace tumble {

class CompoundPair final : public btActivatingCollisionAlgorithm {
 public:
  // `second`: the compound is the second of the two. Where both are, the first's children each meet the second as such.
  CompoundPair(const btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b,
               bool second);
  ~CompoundPair() override;

  void processCollision(const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b, const btDispatcherInfo& info,
                        btManifoldResult* result) override;
  btScalar calculateTimeOfImpact(btCollisionObject*, btCollisionObject*, const btDispatcherInfo&, btManifoldResult*) override { return 1; }
  void getAllContactManifolds(btManifoldArray& manifolds) override;

  struct CreateFunc final : btCollisionAlgorithmCreateFunc {
    explicit CreateFunc(bool is_second) : second(is_second) {}
    btCollisionAlgorithm* CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper* a,
                                                   const btCollisionObjectWrapper* b) override;
    bool second;
  };

 private:
  void process_child(int index, const btCollisionObjectWrapper& child, const btCollisionObjectWrapper& other, const btDispatcherInfo& info,
                     btManifoldResult& result);
  void drop(int index);
  void drop_all();

  bool second_;
  btAlignedObjectArray<btCollisionAlgorithm*> children_;  // by the child's index; null while its box is off the other's
};

}  // namespace tumble
