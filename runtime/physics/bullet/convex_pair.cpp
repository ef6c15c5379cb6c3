#include "physics/bullet/convex_pair.h"

#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btTriangleShape.h>

#include <algorithm>

#include "physics/bullet/contact_points.h"

namespace tumble {

bool is_served(int proxy_type) {
  switch (proxy_type) {
    case BOX_SHAPE_PROXYTYPE:
    case TRIANGLE_SHAPE_PROXYTYPE:
    case CONVEX_HULL_SHAPE_PROXYTYPE:
    case SPHERE_SHAPE_PROXYTYPE:
    case CAPSULE_SHAPE_PROXYTYPE:
    case CONE_SHAPE_PROXYTYPE:
    case CYLINDER_SHAPE_PROXYTYPE: return true;
    default: return false;
  }
}

bool convex_of(const btCollisionShape& shape, pairs::Convex& out) {
  switch (shape.getShapeType()) {
    case SPHERE_SHAPE_PROXYTYPE: out = pairs::make_sphere(static_cast<const btSphereShape&>(shape).getRadius()); return true;
    case BOX_SHAPE_PROXYTYPE: {
      const auto& box = static_cast<const btBoxShape&>(shape);
      out = pairs::make_box(from_bullet(box.getHalfExtentsWithMargin()));
      return true;
    }
    case CAPSULE_SHAPE_PROXYTYPE: {
      const auto& capsule = static_cast<const btCapsuleShape&>(shape);
      out = pairs::make_capsule(capsule.getRadius(), capsule.getHalfHeight());
      return true;
    }
    case CYLINDER_SHAPE_PROXYTYPE: {
      const btVector3 half = static_cast<const btCylinderShape&>(shape).getHalfExtentsWithMargin();
      out = pairs::make_cylinder(half.x(), half.y());
      return true;
    }
    case CONE_SHAPE_PROXYTYPE: {
      const auto& cone = static_cast<const btConeShape&>(shape);
      out = pairs::make_cone(cone.getRadius(), cone.getHeight() / 2);
      return true;
    }
    case CONVEX_HULL_SHAPE_PROXYTYPE: {
      const auto* solid = static_cast<const pairs::Polyhedron*>(shape.getUserPointer());
      if (solid) out = pairs::make_solid(*solid);
      return solid != nullptr;
    }
    case TRIANGLE_SHAPE_PROXYTYPE: {
      const btVector3* corners = static_cast<const btTriangleShape&>(shape).m_vertices1;
      out = pairs::make_triangle(from_bullet(corners[0]), from_bullet(corners[1]), from_bullet(corners[2]));
      return true;
    }
    default: return false;
  }
}

ConvexPair::ConvexPair(const btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper* a,
                       const btCollisionObjectWrapper* b, Use use)
    : btActivatingCollisionAlgorithm(info, a, b), use_(use), shared_(info.m_manifold) {}

ConvexPair::~ConvexPair() {
  if (manifold_) m_dispatcher->releaseManifold(manifold_);
}

void ConvexPair::getAllContactManifolds(btManifoldArray& manifolds) {
  if (manifold_) manifolds.push_back(manifold_);
}

// Made late: a manifold takes a kilobyte, and most pairs whose boxes overlap never touch.
void ConvexPair::own_manifold(const btCollisionObjectWrapper& a, const btCollisionObjectWrapper& b) {
  if (!manifold_) manifold_ = m_dispatcher->getNewManifold(a.getCollisionObject(), b.getCollisionObject());
}

// That already holds, or may hold, points of other triangles.
btPersistentManifold* ConvexPair::others_manifold(const btCollisionObjectWrapper& a, const btCollisionObjectWrapper& b,
                                                  btManifoldResult& result) const {
  if (shared_) return shared_;
  const bool triangle = a.getCollisionShape()->getShapeType() == TRIANGLE_SHAPE_PROXYTYPE ||
                        b.getCollisionShape()->getShapeType() == TRIANGLE_SHAPE_PROXYTYPE;
  // Only then is what the result carries sure to be alive: compounds leave there what a child had.
  return use_ == Use::closest_points && triangle ? result.getPersistentManifold() : nullptr;
}

void ConvexPair::processCollision(const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b, const btDispatcherInfo&,
                                  btManifoldResult* result) {
  pairs::Convex convex_a, convex_b;
  if (!convex_of(*a->getCollisionShape(), convex_a) || !convex_of(*b->getCollisionShape(), convex_b)) return;
  double margin = result->m_closestPointDistanceThreshold;
  if (margin <= 0 && use_ == Use::contacts) margin = gContactBreakingThreshold;
  pairs::Manifold found;
  pairs::collide(convex_a, from_bullet(a->getWorldTransform()), convex_b, from_bullet(b->getWorldTransform()), margin, cache_, found);

  btPersistentManifold* const others = others_manifold(*a, *b, *result);
  if (others || use_ == Use::closest_points) {
    if (found.count == 0) return;
    btPersistentManifold* const before = result->getPersistentManifold();
    if (!others) own_manifold(*a, *b);
    result->setPersistentManifold(others ? others : manifold_);
    add_points(found, *a, margin, *result);
    result->setPersistentManifold(before);
    return;
  }
  if (found.count > 0) own_manifold(*a, *b);
  if (!manifold_) return;
  result->setPersistentManifold(manifold_);
  write_points(found, *a, *b, margin, *manifold_);
}

btCollisionAlgorithm* ConvexPair::CreateFunc::CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                                       const btCollisionObjectWrapper* a,
                                                                       const btCollisionObjectWrapper* b) {
  return new (info.m_dispatcher1->allocateCollisionAlgorithm(sizeof(ConvexPair))) ConvexPair(info, a, b, use);
}

}  // namespace tumble
