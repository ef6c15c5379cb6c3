// What the debug view sees of the world.
#include "physics/bullet/impl.h"

namespace tumble {

namespace {

std::unique_ptr<const BodyWire> wire_of_body(const BodyDef& def) {
  auto result = std::make_unique<BodyWire>();
  for (const ColliderDef& collider : def.colliders) {
    Wire& wire = collider.trigger.value_or(def.trigger) ? result->triggers : result->solids;
    const Pose place{collider.offset, normalized(collider.rotation)};
    for (const WireLine& line : wire_of(collider.shape)) wire.push_back({place * line.from, place * line.to});
  }
  return result;
}

DebugState state_of(const BodyState& body) {
  if (body.def.type == BodyType::fixed) return DebugState::fixed;
  if (body.def.type == BodyType::kinematic) return DebugState::kinematic;
  return body.awake() ? DebugState::awake : DebugState::asleep;
}

DebugBody seen(const BodyState& state) {
  if (!state.wire) state.wire = wire_of_body(state.def);
  DebugBody body;
  body.body = state.id;
  body.state = state_of(state);
  body.solids = &state.wire->solids;
  body.triggers = &state.wire->triggers;
  btVector3 low, high;
  const btCollisionObject& object = state.solids->empty() && state.ghost ? *state.ghost : *state.rigid;
  object.getCollisionShape()->getAabb(object.getWorldTransform(), low, high);
  body.low = from_bullet(low);
  body.high = from_bullet(high);
  body.center = state.mass.center;
  body.velocity = from_bullet(state.rigid->getLinearVelocity());
  body.angular_velocity = from_bullet(state.rigid->getAngularVelocity());
  return body;
}

}  // namespace

void World::each_debug_body(const std::function<void(const DebugBody&)>& f) const {
  impl_->bodies.each([&](BodyId, const Body& body) {
    if (body.state->enabled) f(seen(*body.state));
  });
}

void World::each_debug_joint(const std::function<void(const DebugJoint&)>& f) const {
  for (const JointPart* joint : impl_->live)
    f({joint->def.a, joint->def.b, joint->local_a, joint->local_b, joint->a ? joint->a->mass.center : joint->local_a.position,
       joint->b ? joint->b->mass.center : joint->local_b.position, &joint->def.kind});
}

void World::each_contact(const std::function<void(const ContactEvent&)>& f) const {
  for (const auto& pair : impl_->book.pairs())
    if (!pair->trigger) f(told(*pair));
}

}  // namespace tumble
