#include "physics/bullet/bounce.h"

#include <algorithm>

#include "physics/bullet/materials.h"

namespace tumble {

namespace {

// Slower hits do not bounce, m/s.
constexpr double kSlowest = 0.1;
// Several points of a box, or several boxes, share a hit.
constexpr int kRounds = 4;

// Speed at which the bodies near each other at a point, given the velocities of their centres.
double approach(const btPersistentManifold& manifold, const btManifoldPoint& point, const btVector3& va, const btVector3& vb) {
  const btRigidBody &a = *state_of(manifold.getBody0())->rigid, &b = *state_of(manifold.getBody1())->rigid;
  const btVector3 spin_a = a.getAngularVelocity().cross(point.getPositionWorldOnA() - a.getWorldTransform().getOrigin());
  const btVector3 spin_b = b.getAngularVelocity().cross(point.getPositionWorldOnB() - b.getWorldTransform().getOrigin());
  return -point.m_normalWorldOnB.dot(va + spin_a - vb - spin_b);
}

btVector3 velocity(const btCollisionObject* object) { return state_of(object)->rigid->getLinearVelocity(); }

btVector3 velocity_before(const btCollisionObject* object) {
  const BodyState& body = *state_of(object);
  return body.dynamic() ? body.free_velocity : body.rigid->getLinearVelocity();
}

double mobility(const btRigidBody& body, const btVector3& position, const btVector3& normal) {
  if (body.getInvMass() == 0) return 0;
  const btVector3 lever = (position - body.getWorldTransform().getOrigin()).cross(normal);
  return body.getInvMass() + lever.dot(body.getInvInertiaTensorWorld() * lever);
}

void push(btRigidBody& body, const btVector3& position, const btVector3& impulse) {
  if (body.getInvMass() != 0) body.applyImpulse(impulse, position - body.getWorldTransform().getOrigin());
}

}  // namespace

void Bounce::prepare(btDispatcher& dispatcher, double h) {
  hits_.clear();
  for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
    btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(i);
    if (manifold.getNumContacts() == 0 || (!manifold.getBody0()->isActive() && !manifold.getBody1()->isActive())) continue;
    if (dispatcher.needsResponse(manifold.getBody0(), manifold.getBody1())) prepare(manifold, h);
  }
}

void Bounce::prepare(btPersistentManifold& manifold, double h) {
  const btCollisionObject *a = manifold.getBody0(), *b = manifold.getBody1();
  for (int p = 0; p < manifold.getNumContacts(); ++p) {
    btManifoldPoint& point = manifold.getContactPoint(p);
    const double before = approach(manifold, point, velocity_before(a), velocity_before(b));
    if (before < kSlowest) continue;
    const double restitution = contact_restitution(manifold, point);
    if (restitution <= 0) continue;
    // On the way through the gap forces go on: v^2 + 2 a d.
    const double gained = (approach(manifold, point, velocity(a), velocity(b)) - before) / h;
    const double speed2 = before * before + 2 * gained * point.getDistance();
    hits_.push_back({&manifold, &point, restitution * std::sqrt(std::max(0.0, speed2)), 0});
  }
}

void Bounce::apply() {
  std::erase_if(hits_, [](const Hit& hit) { return hit.point->getAppliedImpulse() <= 0; });
  for (int round = 0; round < kRounds; ++round)
    for (Hit& hit : hits_) give(hit);
  for (Hit& hit : hits_) hit.point->m_appliedImpulse += hit.impulse;
}

void Bounce::give(Hit& hit) {
  const btVector3& normal = hit.point->m_normalWorldOnB;
  BodyState &a = *state_of(hit.manifold->getBody0()), &b = *state_of(hit.manifold->getBody1());
  const btVector3 &at_a = hit.point->getPositionWorldOnA(), &at_b = hit.point->getPositionWorldOnB();
  const double missing = hit.leave + approach(*hit.manifold, *hit.point, a.rigid->getLinearVelocity(), b.rigid->getLinearVelocity());
  const double together = mobility(*a.rigid, at_a, normal) + mobility(*b.rigid, at_b, normal);
  if (together <= 0) return;
  const double total = std::max(0.0, hit.impulse + missing / together);
  push(*a.rigid, at_a, normal * (total - hit.impulse));
  push(*b.rigid, at_b, normal * (hit.impulse - total));
  hit.impulse = total;
}

void Bounce::forget() {
  for (Hit& hit : hits_) hit.point->m_appliedImpulse = 0;
}

}  // namespace tumble
