// Poses, velocities, forces and sleep of single bodies.
#include "physics/bullet/impl.h"

namespace tumble {

Pose World::pose(BodyId body) const { return impl_->body(body).pose(); }

void World::teleport(BodyId id, const Pose& pose) {
  Impl& world = *impl_;
  BodyState& body = world.body(id);
  body.moving = false;
  if (body.enabled) {
    world.wake_touching(body);
    world.book.end_pairs(body, world.events);
  }
  body.place(body.to_center({pose.position, normalized(pose.rotation)}));
  body.last_good = body.rigid->getWorldTransform();
  if (!body.enabled) return;
  world.refresh_pairs(body);  // old contact points are of the old place
  world.wake(body);
  world.wake_around(body);
  for (JointPart* joint : body.joints)
    for (BodyState* partner : {joint->a, joint->b})
      if (partner) world.wake(*partner);
}

void World::move(BodyId id, const Pose& pose) {
  BodyState& body = impl_->body(id);
  if (body.def.type != BodyType::kinematic || !body.enabled) return teleport(id, pose);
  const btTransform to = body.to_center({pose.position, normalized(pose.rotation)});
  if (to == body.rigid->getWorldTransform()) {
    body.moving = false;
    return;
  }
  body.path.to = to;
  if (!body.moving) impl_->wake_heap(body);
  body.moving = true;
  impl_->stir(body);
}

Vec3 World::velocity(BodyId body) const { return from_bullet(impl_->body(body).rigid->getLinearVelocity()); }
Vec3 World::angular_velocity(BodyId body) const { return from_bullet(impl_->body(body).rigid->getAngularVelocity()); }
Vec3 World::velocity_at(BodyId body, Vec3 point) const { return impl_->body(body).velocity_at(point); }

void World::set_velocity(BodyId id, Vec3 velocity) {
  BodyState& body = impl_->body(id);
  if (!body.dynamic()) return;
  body.rigid->setLinearVelocity(to_bullet(velocity) * body.rigid->getLinearFactor());
  impl_->wake(body);
}

void World::set_angular_velocity(BodyId id, Vec3 velocity) {
  BodyState& body = impl_->body(id);
  if (!body.dynamic()) return;
  body.rigid->setAngularVelocity(to_bullet(velocity));
  impl_->wake(body);
}

void World::apply_force(BodyId id, Vec3 force) {
  BodyState& body = impl_->body(id);
  if (!body.dynamic() || !body.enabled) return;
  body.force += force;
  impl_->wake(body);
}

void World::apply_force(BodyId id, Vec3 force, Vec3 point) {
  apply_force(id, force);
  apply_torque(id, cross(point - from_bullet(impl_->body(id).rigid->getWorldTransform().getOrigin()), force));
}

void World::apply_torque(BodyId id, Vec3 torque) {
  BodyState& body = impl_->body(id);
  if (!body.dynamic() || !body.enabled) return;
  body.torque += torque;
  impl_->wake(body);
}

void World::apply_impulse(BodyId id, Vec3 impulse) {
  BodyState& body = impl_->body(id);
  if (!body.dynamic()) return;
  body.rigid->applyCentralImpulse(to_bullet(impulse));
  impl_->wake(body);
}

void World::apply_impulse(BodyId id, Vec3 impulse, Vec3 point) {
  apply_impulse(id, impulse);
  apply_angular_impulse(id, cross(point - from_bullet(impl_->body(id).rigid->getWorldTransform().getOrigin()), impulse));
}

void World::apply_angular_impulse(BodyId id, Vec3 impulse) {
  BodyState& body = impl_->body(id);
  if (!body.dynamic()) return;
  body.rigid->updateInertiaTensor();  // Bullet keeps one in the world
  body.rigid->applyTorqueImpulse(to_bullet(impulse));
  impl_->wake(body);
}

bool World::asleep(BodyId id) const {
  const BodyState& body = impl_->body(id);
  return body.dynamic() && body.enabled && !body.active;
}

void World::sleep(BodyId id) {
  BodyState& body = impl_->body(id);
  impl_->awake.sleep(body);
}

void World::wake(BodyId body) { impl_->wake(impl_->body(body)); }

MassProperties World::mass_properties(BodyId body) const { return impl_->body(body).mass; }
Vec3 World::momentum(BodyId body) const { return velocity(body) * impl_->body(body).mass.mass; }

double World::kinetic_energy(BodyId id) const {
  const BodyState& body = impl_->body(id);
  const Vec3 v = velocity(id);
  const Vec3 spin = conjugate(from_bullet(body.rigid->getWorldTransform().getRotation())) * angular_velocity(id);
  return (body.mass.mass * dot(v, v) + dot(scaled(body.mass.inertia, spin), spin)) / 2;
}

}  // namespace tumble
