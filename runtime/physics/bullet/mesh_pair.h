// A convex shape against a mesh: the points of all triangles in reach are made anew in every pass and chosen from together.
//
// Bullet's own adds each triangle's points to one manifold of four, where those of past passes linger and those of other
// triangles are lost; and it lets the edges within a flat stop what slides over them.
#pragma once

#include <BulletCollision/CollisionDispatch/btActivatingCollisionAlgorithm.h>
#include <BulletCollision/CollisionShapes/btTriangleCallback.h>

#include <vector>

#include "physics/bullet/contact_points.h"

namespace tumble {

class MeshPair final : public btActivatingCollisionAlgorithm {
 public:
  // `first`: the mesh is the first of the two.
  MeshPair(const btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b,
           bool first);
  ~MeshPair() override;

  void processCollision(const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b, const btDispatcherInfo&,
                        btManifoldResult* result) override;
  btScalar calculateTimeOfImpact(btCollisionObject*, btCollisionObject*, const btDispatcherInfo&, btManifoldResult*) override { return 1; }
  void getAllContactManifolds(btManifoldArray& manifolds) override;

  struct CreateFunc final : btCollisionAlgorithmCreateFunc {
    explicit CreateFunc(bool is_first) : first(is_first) {}
    btCollisionAlgorithm* CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper* a,
                                                   const btCollisionObjectWrapper* b) override;
    bool first;
  };

 private:
  // Points whose normals are alike share a manifold: a floor, a wall, a ceiling, and one more.
  static constexpr int kMostManifolds = 4;
  void write(std::vector<Touch>& touches, const btCollisionObjectWrapper& convex, const btCollisionObjectWrapper& mesh, double margin);

  bool first_;
  int used_ = 0;  // manifolds that hold points
  btPersistentManifold* manifolds_[kMostManifolds] = {};  // ours, made when there is a first point
};

// Is this kind of shape (a BroadphaseNativeTypes) a mesh of triangles?
bool is_mesh(int proxy_type);

}  // namespace tumble
