// Our contact search (physics/pairs) in the place of Bullet's: for two convex shapes, and for the parts of compounds.
//
// What matters of how Bullet 3.24 calls such an algorithm:
// - Pairs of bodies of one convex part have a BodyPair. CompoundPair makes one of these for a part that is near, without a
//   manifold, and keeps it as long. It owns its manifold, and writes all points of it anew in every pass.
// - btConvexConcaveCollisionAlgorithm, now used by queries only (MeshPair stands in its place), has one manifold for a
//   mesh and makes an algorithm for every triangle and pass. It hands that manifold to the algorithm, or, if the result has
//   a distance threshold, asks for a "closest points" algorithm without one; either way the result already carries it.
//   Points of other triangles are in it, so that here they are only added, as Bullet does it: by btManifoldResult, which
//   replaces or drops some of them.
// - btCompoundCollisionAlgorithm keeps an algorithm for every child, each with a manifold of its own, but only while the
//   threshold is 0. With a threshold it makes "closest points" algorithms for one call, and their manifolds, with all
//   contacts, are gone before the solver sees them. Hence CompoundPair.
// - Queries (contactTest, contactPairTest) take "closest points" algorithms and a result that overrides addContactPoint.
#pragma once

#include <BulletCollision/CollisionDispatch/btActivatingCollisionAlgorithm.h>

#include "physics/bullet/convert.h"
#include "physics/pairs/collide.h"

namespace tumble {

// The shape as the search sees it: as large as it says, without Bullet's margins around it. Hulls carry their
// pairs::Polyhedron as user pointer (shapes.cpp sets it); false for one without, and for shapes that are not served.
bool convex_of(const btCollisionShape& shape, pairs::Convex& out);
// Does convex_of know this kind of shape (a BroadphaseNativeTypes)?
bool is_served(int proxy_type);

class ConvexPair final : public btActivatingCollisionAlgorithm {
 public:
  enum class Use { contacts, closest_points };
  ConvexPair(const btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b,
             Use use);
  ~ConvexPair() override;

  // Points are found up to result->m_closestPointDistanceThreshold apart; where that is 0, as Bullet's own near callback
  // leaves it, contacts are found up to gContactBreakingThreshold, as Bullet's own algorithms do.
  void processCollision(const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b, const btDispatcherInfo&,
                        btManifoldResult* result) override;
  btScalar calculateTimeOfImpact(btCollisionObject*, btCollisionObject*, const btDispatcherInfo&, btManifoldResult*) override { return 1; }
  void getAllContactManifolds(btManifoldArray& manifolds) override;

  struct CreateFunc final : btCollisionAlgorithmCreateFunc {
    explicit CreateFunc(Use given) : use(given) {}
    btCollisionAlgorithm* CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper* a,
                                                   const btCollisionObjectWrapper* b) override;
    Use use;
  };

 private:
  void own_manifold(const btCollisionObjectWrapper& a, const btCollisionObjectWrapper& b);
  btPersistentManifold* others_manifold(const btCollisionObjectWrapper& a, const btCollisionObjectWrapper& b,
                                        btManifoldResult& result) const;

  Use use_;
  btPersistentManifold* shared_;            // of a mesh; not ours
  btPersistentManifold* manifold_ = nullptr;  // ours, made when there is a first point
  pairs::Cache cache_;
};

}  // namespace tumble
