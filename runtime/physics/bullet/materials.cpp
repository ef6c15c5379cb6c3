#include "physics/bullet/materials.h"

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>

#include <algorithm>

namespace tumble {

namespace {

int rank(Combine rule) {
  switch (rule) {
    case Combine::multiply: return 0;
    case Combine::average: return 1;
    case Combine::min: return 2;
    case Combine::max: return 3;
  }
  return 0;
}

const Materials& materials(const BodyState& body) { return *body.materials; }

double friction_of(const BodyState& body, const ColliderDef* collider) {
  if (collider && collider->friction) return *collider->friction;
  return body.def.friction.value_or(materials(body).friction);
}

double restitution_of(const BodyState& body, const ColliderDef* collider) {
  if (collider && collider->restitution) return *collider->restitution;
  return body.def.restitution.value_or(materials(body).restitution);
}

double friction(const BodyState& a, const ColliderDef* ca, const BodyState& b, const ColliderDef* cb) {
  const Combine rule = rule_of(a.def.friction_combine, b.def.friction_combine, materials(a).friction_combine);
  return combine(rule, friction_of(a, ca), friction_of(b, cb));
}

double restitution(const BodyState& a, const ColliderDef* ca, const BodyState& b, const ColliderDef* cb) {
  const Combine rule = rule_of(a.def.restitution_combine, b.def.restitution_combine, materials(a).restitution_combine);
  return combine(rule, restitution_of(a, ca), restitution_of(b, cb));
}

btScalar bodies_friction(const btCollisionObject* a, const btCollisionObject* b) {
  return friction(*state_of(a), nullptr, *state_of(b), nullptr);
}

btScalar no_restitution(const btCollisionObject*, const btCollisionObject*) { return 0; }

const ColliderDef* collider_at(const BodyState& body, int part, int index) {
  if (body.solids->empty()) return nullptr;
  return &body.def.colliders[static_cast<std::size_t>(body.solids->collider_of(part, index))];
}

// A moving belt: friction pulls towards the difference of the two surfaces' own velocities.
void set_belt(btManifoldPoint& point, const BodyState& a, const BodyState& b) {
  const Vec3 belt = belt_between(a, b);
  const btVector3 normal = point.m_normalWorldOnB, along = to_bullet(belt) - normal * normal.dot(to_bullet(belt));
  if (along.length2() < 1e-18) return;
  point.m_lateralFrictionDir1 = along.normalized();
  point.m_lateralFrictionDir2 = normal.cross(point.m_lateralFrictionDir1);
  point.m_contactMotion1 = along.length();
  point.m_contactMotion2 = 0;
  point.m_contactPointFlags |= BT_CONTACT_FLAG_LATERAL_FRICTION_INITIALIZED;
}

bool contact_added(btManifoldPoint& point, const btCollisionObjectWrapper* wrap_a, int part_a, int index_a,
                   const btCollisionObjectWrapper* wrap_b, int part_b, int index_b) {
  const btCollisionObject *object_a = wrap_a->getCollisionObject(), *object_b = wrap_b->getCollisionObject();
  if (is_ghost(object_a) || is_ghost(object_b)) return true;
  const BodyState &a = *state_of(object_a), &b = *state_of(object_b);
  const ColliderDef *ca = collider_at(a, part_a, index_a), *cb = collider_at(b, part_b, index_b);
  point.m_combinedFriction = friction(a, ca, b, cb);
  if (a.has_belt || b.has_belt) set_belt(point, a, b);
  return true;
}

}  // namespace

Surface surface_between(const BodyState& a, const BodyState& b) {
  const ColliderDef *ca = &a.def.colliders[static_cast<std::size_t>(a.solids->pieces()[0].collider)];
  const ColliderDef *cb = &b.def.colliders[static_cast<std::size_t>(b.solids->pieces()[0].collider)];
  return {friction(a, ca, b, cb), restitution(a, ca, b, cb)};
}

Vec3 belt_between(const BodyState& a, const BodyState& b) {
  if (!a.has_belt && !b.has_belt) return {};
  return b.pose().rotation * b.def.surface_velocity - a.pose().rotation * a.def.surface_velocity;
}

double contact_restitution(const btPersistentManifold& manifold, const btManifoldPoint& point) {
  const BodyState &a = *state_of(manifold.getBody0()), &b = *state_of(manifold.getBody1());
  return restitution(a, collider_at(a, point.m_partId0, point.m_index0), b, collider_at(b, point.m_partId1, point.m_index1));
}

double combine(Combine rule, double a, double b) {
  switch (rule) {
    case Combine::average: return (a + b) / 2;
    case Combine::min: return std::min(a, b);
    case Combine::max: return std::max(a, b);
    case Combine::multiply: break;
  }
  return a * b;
}

Combine rule_of(const std::optional<Combine>& a, const std::optional<Combine>& b, Combine world) {
  if (a && b) return rank(*a) > rank(*b) ? *a : *b;
  return a ? *a : b ? *b : world;
}

void install_material_callbacks() {
  gCalculateCombinedFrictionCallback = bodies_friction;
  gCalculateCombinedRestitutionCallback = no_restitution;
  gContactAddedCallback = contact_added;
}

}  // namespace tumble
