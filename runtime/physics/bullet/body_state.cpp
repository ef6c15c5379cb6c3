#include "physics/bullet/body_state.h"

#include "physics/bullet/convex_pair.h"

#include <algorithm>

namespace tumble {

namespace {

bool locks(const std::string& letters, char axis) { return letters.find(axis) != std::string::npos; }

Vec3 linear_factor(const BodyDef& def) {
  return {locks(def.lock_position, 'x') ? 0.0 : 1.0, locks(def.lock_position, 'y') ? 0.0 : 1.0,
          locks(def.lock_position, 'z') ? 0.0 : 1.0};
}

Vec3 angular_factor(const BodyDef& def) {
  const Vec3 f = def.rotation_factor;
  return {locks(def.lock_rotation, 'x') ? 0.0 : f.x, locks(def.lock_rotation, 'y') ? 0.0 : f.y,
          locks(def.lock_rotation, 'z') ? 0.0 : f.z};
}

bool same(const ColliderDef& a, const ColliderDef& b) {
  return a.shape == b.shape && a.offset == b.offset && a.rotation == b.rotation && a.trigger == b.trigger;
}

bool own_materials(const BodyDef& def) {
  if (!(def.surface_velocity == Vec3{})) return true;
  for (const ColliderDef& collider : def.colliders)
    if (collider.friction || collider.restitution) return true;
  return false;
}

// How far its farthest corner may be from its origin, at most.
double extent_of(const btCollisionShape& shape) {
  btVector3 low, high;
  shape.getAabb(btTransform::getIdentity(), low, high);
  high = high.absolute();
  high.setMax(low.absolute());
  return high.length();
}

int flags_of(const BodyDef& def) {
  int flags = own_materials(def) ? btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK : 0;
  if (def.type == BodyType::fixed) flags |= btCollisionObject::CF_STATIC_OBJECT;
  if (def.type == BodyType::kinematic) flags |= btCollisionObject::CF_KINEMATIC_OBJECT;
  return flags;
}

}  // namespace

Vec3 BodyState::velocity_at(Vec3 point) const {
  const btVector3 arm = to_bullet(point) - rigid->getWorldTransform().getOrigin();
  return from_bullet(rigid->getVelocityInLocalPoint(arm));
}

void BodyState::place(const btTransform& at) {
  ++placed;
  travel = 0;
  center = from_bullet(at);
  rigid->setWorldTransform(at);
  if (ghost) ghost->setWorldTransform(at);
}

void BodyState::go(const Pose& to) {
  // A chord of quaternions is half the angle, for the small turns that matter.
  const Quat &from = center.rotation, &there = to.rotation;
  const double sign = dot(from, there) < 0 ? -1 : 1;
  const Quat chord{there.x - sign * from.x, there.y - sign * from.y, there.z - sign * from.z, there.w - sign * from.w};
  travel += distance(to.position, center.position) + 2 * length(chord) * extent;
  center = to;
  const btTransform at = to_bullet(to);
  rigid->setWorldTransform(at);
  if (ghost) ghost->setWorldTransform(at);
}

bool same_shapes(const BodyDef& a, const BodyDef& b) {
  if (a.type != b.type || a.trigger != b.trigger || a.colliders.size() != b.colliders.size()) return false;
  for (std::size_t i = 0; i < a.colliders.size(); ++i)
    if (!same(a.colliders[i], b.colliders[i])) return false;
  return true;
}

void apply_numbers(BodyState& body) {
  body.has_belt = !(body.def.surface_velocity == Vec3{});
  btRigidBody& rigid = *body.rigid;
  if (body.dynamic()) rigid.setMassProps(body.mass.mass, to_bullet(body.mass.inertia));
  rigid.setLinearFactor(to_bullet(linear_factor(body.def)));
  rigid.setAngularFactor(to_bullet(angular_factor(body.def)));
  rigid.updateInertiaTensor();
  rigid.setCollisionFlags(flags_of(body.def));
  if (!body.dynamic()) return;
  rigid.setLinearVelocity(to_bullet(body.def.velocity) * rigid.getLinearFactor());
  rigid.setAngularVelocity(to_bullet(body.def.angular_velocity));
}

void build(BodyState& body, const Pose& pose) {
  body.wire.reset();
  body.mass = mass_properties(body.def);
  body.frame = {body.mass.center, body.mass.axes};
  auto solids = std::make_unique<ShapeSet>(body.def, false, body.frame);
  auto triggers = std::make_unique<ShapeSet>(body.def, true, body.frame);

  if (solids->empty()) body.nothing = std::make_unique<btEmptyShape>();
  btRigidBody::btRigidBodyConstructionInfo info(body.mass.mass, nullptr, solids->empty() ? body.nothing.get() : solids->root(),
                                                to_bullet(body.mass.inertia));
  info.m_startWorldTransform = body.to_center(pose);
  body.rigid = std::make_unique<btRigidBody>(info);
  body.rigid->setUserPointer(&body);
  body.rigid->setUserIndex(0);
  // Forces and the gyroscopic moment are ours (world_step.cpp).
  body.rigid->setFlags((body.rigid->getFlags() & ~BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY) | BT_DISABLE_WORLD_GRAVITY);
  body.ghost.reset();
  if (!triggers->empty()) {
    body.ghost = std::make_unique<btCollisionObject>();
    body.ghost->setCollisionShape(triggers->root());
    body.ghost->setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT | btCollisionObject::CF_NO_CONTACT_RESPONSE);
    body.ghost->setUserPointer(&body);
    body.ghost->setUserIndex(1);
    body.ghost->setWorldTransform(info.m_startWorldTransform);
  }
  body.solids = std::move(solids);
  body.triggers = std::move(triggers);
  apply_numbers(body);
  body.last_good = info.m_startWorldTransform;
  body.center = from_bullet(info.m_startWorldTransform);
  const std::vector<Piece>& pieces = body.solids->pieces();
  body.is_convex = pieces.size() == 1 && convex_of(*pieces[0].shape, body.convex);
  body.convex_at = body.is_convex ? from_bullet(pieces[0].local) : Pose{};
  body.extent = extent_of(*body.rigid->getCollisionShape());
  body.trigger_extent = body.ghost ? extent_of(*body.ghost->getCollisionShape()) : 0;
}

}  // namespace tumble
