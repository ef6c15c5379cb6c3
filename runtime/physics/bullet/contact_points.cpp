#include "physics/bullet/contact_points.h"

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>

#include <algorithm>

#include "physics/bullet/same_points.h"

namespace tumble {

namespace {

struct Side {
  const btCollisionObjectWrapper& wrap;
  const btCollisionObject& object() const { return *wrap.getCollisionObject(); }
  btVector3 local(const btVector3& world) const { return object().getWorldTransform().invXform(world); }
};

void combine_materials(const btCollisionObject& a, const btCollisionObject& b, btManifoldPoint& point) {
  point.m_combinedFriction = gCalculateCombinedFrictionCallback(&a, &b);
  point.m_combinedRestitution = gCalculateCombinedRestitutionCallback(&a, &b);
  point.m_combinedRollingFriction = gCalculateCombinedRollingFrictionCallback(&a, &b);
  point.m_combinedSpinningFriction = gCalculateCombinedSpinningFrictionCallback(&a, &b);
  if ((a.getCollisionFlags() | b.getCollisionFlags()) & btCollisionObject::CF_HAS_CONTACT_STIFFNESS_DAMPING) {
    point.m_combinedContactDamping1 = gCalculateCombinedContactDampingCallback(&a, &b);
    point.m_combinedContactStiffness1 = gCalculateCombinedContactStiffnessCallback(&a, &b);
    point.m_contactPointFlags |= BT_CONTACT_FLAG_CONTACT_STIFFNESS_DAMPING;
  }
}

// On the manifold's first and second body; its normal goes from the second to the first, ours from b to a.
btManifoldPoint make_point(const Side& first, const Side& second, const Touch& touch, bool swapped) {
  const pairs::Point& at = touch.point;
  const btVector3 on_first = to_bullet(swapped ? at.on_b : at.on_a), on_second = to_bullet(swapped ? at.on_a : at.on_b);
  btManifoldPoint point(first.local(on_first), second.local(on_second), to_bullet(swapped ? -touch.normal : touch.normal), at.separation);
  point.m_positionWorldOnA = on_first;
  point.m_positionWorldOnB = on_second;
  combine_materials(first.object(), second.object(), point);
  btPlaneSpace1(point.m_normalWorldOnB, point.m_lateralFrictionDir1, point.m_lateralFrictionDir2);
  // The wrappers know what btManifoldResult is told by setShapeIdentifiers: a compound's child, or part and triangle.
  point.m_partId0 = first.wrap.m_partId;
  point.m_partId1 = second.wrap.m_partId;
  point.m_index0 = first.wrap.m_index;
  point.m_index1 = second.wrap.m_index;
  if (touch.part >= 0) {
    (swapped ? point.m_partId0 : point.m_partId1) = touch.part;
    (swapped ? point.m_index0 : point.m_index1) = touch.index;
  }
  return point;
}

double size_of(const Side& side) { return side.wrap.getCollisionShape()->getAngularMotionDisc(); }

// A corner stays where it is on its own body, a crossing of edges on one of the two.
double moved(const btManifoldPoint& old, const btManifoldPoint& made) {
  return std::sqrt(std::min((old.m_localPointA - made.m_localPointA).length2(), (old.m_localPointB - made.m_localPointB).length2()));
}

void take_over(const btManifoldPoint& old, btManifoldPoint& made) {
  made.m_appliedImpulse = old.m_appliedImpulse;
  made.m_prevRHS = old.m_prevRHS;
  made.m_appliedImpulseLateral1 = old.m_appliedImpulseLateral1;
  made.m_appliedImpulseLateral2 = old.m_appliedImpulseLateral2;
  made.m_lifeTime = old.m_lifeTime;
}

void tell_added(const Side& first, const Side& second, btPersistentManifold& manifold) {
  const int flags = first.object().getCollisionFlags() | second.object().getCollisionFlags();
  if (!gContactAddedCallback || !(flags & btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK)) return;
  for (int i = 0; i < manifold.getNumContacts(); ++i) {
    btManifoldPoint& point = manifold.getContactPoint(i);
    gContactAddedCallback(point, &first.wrap, point.m_partId0, point.m_index0, &second.wrap, point.m_partId1, point.m_index1);
  }
}

// Bullet drops points further apart than its manifold's threshold, which it takes from the sizes of the bodies.
void allow(btPersistentManifold& manifold, double margin) {
  if (manifold.getContactBreakingThreshold() < margin) manifold.setContactBreakingThreshold(margin);
}

}  // namespace

void OldPoints::add(const btPersistentManifold& manifold) {
  for (int i = 0; i < manifold.getNumContacts() && count_ < kMost; ++i) points_[count_++] = manifold.getContactPoint(i);
}

void OldPoints::give(btPersistentManifold& manifold, double near) {
  const auto distance = [&](int i, int k) {
    const btManifoldPoint &from = points_[i], &to = manifold.getContactPoint(k);
    return from.m_normalWorldOnB.dot(to.m_normalWorldOnB) < kSameNormal ? INFINITY : moved(from, to);
  };
  match_points(count_, manifold.getNumContacts(), near, distance, [&](int i, int k) { take_over(points_[i], manifold.getContactPoint(k)); });
}

void write_points(const Touch* touches, int count, const btCollisionObjectWrapper& a, const btCollisionObjectWrapper& b, double margin,
                  OldPoints& old, btPersistentManifold& manifold) {
  const bool swapped = manifold.getBody0() != a.getCollisionObject();
  const Side first{swapped ? b : a}, second{swapped ? a : b};
  allow(manifold, margin);
  manifold.setNumContacts(count);
  for (int i = 0; i < count; ++i) manifold.getContactPoint(i) = make_point(first, second, touches[i], swapped);
  old.give(manifold, kSamePoint * std::min(size_of(first), size_of(second)));
  tell_added(first, second, manifold);
}

void write_points(const pairs::Manifold& found, const btCollisionObjectWrapper& a, const btCollisionObjectWrapper& b, double margin,
                  btPersistentManifold& manifold) {
  Touch touches[4];
  for (int i = 0; i < found.count; ++i) touches[i] = {found.points[i], found.normal};
  OldPoints old;
  old.add(manifold);
  write_points(touches, found.count, a, b, margin, old, manifold);
}

void add_points(const pairs::Manifold& found, const btCollisionObjectWrapper& a, double margin, btManifoldResult& result) {
  allow(*result.getPersistentManifold(), margin);
  // The result has an order of the two of its own, and wants the point and the normal on its second.
  const bool swapped = result.getBody0Internal() != a.getCollisionObject();
  const btVector3 normal = to_bullet(swapped ? -found.normal : found.normal);
  for (int i = 0; i < found.count; ++i)
    result.addContactPoint(normal, to_bullet(swapped ? found.points[i].on_a : found.points[i].on_b), found.points[i].separation);
}

}  // namespace tumble
