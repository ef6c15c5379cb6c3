// Contact points of our search as Bullet's, with what the solver found at them in the pass before.
#pragma once

#include <BulletCollision/CollisionDispatch/btManifoldResult.h>

#include "physics/bullet/convert.h"
#include "physics/pairs/manifold.h"

namespace tumble {

// A point with its own normal and, where b is a mesh, the triangle that it lies on.
struct Touch {
  pairs::Point point;
  Vec3 normal;         // from b to a
  int part = -1, index = -1;
};

// The points of the pass before, of one manifold or of several of one pair.
class OldPoints {
 public:
  static constexpr int kMost = 16;
  void add(const btPersistentManifold& manifold);
  // Points of the manifold that lie near an old one, on either body, take over its impulses.
  void give(btPersistentManifold& manifold, double near);

 private:
  int count_ = 0;
  btManifoldPoint points_[kMost];
};

// Makes these, at most four, the only points of a manifold of the two bodies (in either order). What Bullet does at
// btManifoldResult::addContactPoint is done for every point: combined friction and restitution, identifiers,
// gContactAddedCallback.
void write_points(const Touch* touches, int count, const btCollisionObjectWrapper& a, const btCollisionObjectWrapper& b, double margin,
                  OldPoints& old, btPersistentManifold& manifold);
// The same of one pair of shapes, whose wrappers know the identifiers.
void write_points(const pairs::Manifold& found, const btCollisionObjectWrapper& a, const btCollisionObjectWrapper& b, double margin,
                  btPersistentManifold& manifold);

// Adds them to those of the result's manifold by Bullet's own way.
void add_points(const pairs::Manifold& found, const btCollisionObjectWrapper& a, double margin, btManifoldResult& result);

}  // namespace tumble
