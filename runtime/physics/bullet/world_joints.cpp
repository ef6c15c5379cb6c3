// Joints of a world.
#include <algorithm>

#include "physics/bullet/impl.h"

namespace tumble {

namespace {

void check_freedoms(const FixedDef&) {}
void check_freedoms(const HingeDef& hinge) { check_limits(hinge.angle); }
void check_freedoms(const SliderDef& slider) { check_limits(slider.position); }
void check_freedoms(const CylindricalDef& cylindrical) {
  check_limits(cylindrical.slide);
  check_limits(cylindrical.turn);
}
void check_freedoms(const BallDef&) {}
void check_freedoms(const UniversalDef& universal) {
  check_limits(universal.turn_a);
  check_limits(universal.turn_b);
}
void check_freedoms(const RagdollDef& ragdoll) { check_limits(ragdoll.twist); }

void check(const World& world, const JointDef& def) {
  const std::string call = "joint." + joint_kind_name(def.kind);
  check_axes(def, call);
  for (const BodyId body : {def.a, def.b})
    if (body && !world.has(body)) fail(call, ": one of its bodies was removed; make the joint while both are there");
  if (!def.a && !def.b) fail(call, ": neither a nor b is given; give at least one body, the other is the world then");
  if (def.a == def.b) fail(call, ": a and b are the same body; give two different ones, or leave b out for the world");
  std::visit([](const auto& kind) { check_freedoms(kind); }, def.kind);
}

// The joint's frame in both bodies, so that every freedom is 0 now.
void place(JointPart& joint) {
  joint.local_a = {joint.def.anchor, joint_frame(joint.def)};
  const Pose world = joint.a ? joint.a->pose() * joint.local_a : joint.local_a;
  joint.local_b = joint.b ? inverse(joint.b->pose()) * world : world;
}

}  // namespace

JointId World::add(const JointDef& def, std::uint64_t user) {
  check(*this, def);
  Impl& world = *impl_;
  auto part = std::make_unique<JointPart>();
  JointPart& joint = *part;
  joint.def = def;
  joint.user = user;
  joint.a = def.a ? &world.body(def.a) : nullptr;
  joint.b = def.b ? &world.body(def.b) : nullptr;
  joint.serial = world.next_joint++;
  place(joint);
  joint.id = world.joints.add({std::move(part)});
  for (BodyState* body : {joint.a, joint.b})
    if (body) body->joints.push_back(&joint);
  world.update_live(joint);
  return joint.id;
}

void World::remove(JointId id) { impl_->remove_joint(impl_->joint(id)); }
bool World::has(JointId joint) const { return impl_->joints.get(joint) != nullptr; }
std::uint64_t World::user(JointId joint) const { return impl_->joint(joint).user; }
const JointDef& World::def(JointId joint) const { return impl_->joint(joint).def; }
JointState World::state(JointId joint) const { return tumble::state_of(impl_->joint(joint)); }

void World::configure(JointId id, const JointDef& def) {
  check(*this, def);
  Impl& world = *impl_;
  JointPart& joint = world.joint(id);
  if (!(def.a == joint.def.a) || !(def.b == joint.def.b))
    fail("joint.", joint_kind_name(def.kind), ": a and b cannot be changed; destroy the joint and make a new one");
  const bool moved = !(def.anchor == joint.def.anchor) || !(joint_frame(def) == joint_frame(joint.def)) || def.kind.index() != joint.def.kind.index();
  const std::size_t kind = joint.def.kind.index();
  const std::vector<bool> before = locks_of(joint);
  const bool filter = def.collide_connected != joint.def.collide_connected;
  joint.def = def;
  if (def.kind.index() != kind || locks_of(joint) != before) world.solver.joints_changed();  // else its mechanism goes on, with what it knows
  if (moved) {
    place(joint);
    joint.link.positions.clear();
  }
  world.update_live(joint);
  note_drives(joint);
  for (BodyState* body : {joint.a, joint.b})
    if (body) world.wake(*body);
  if (filter && joint.a && joint.b) world.overlaps.renew(*joint.a, *joint.b);
}

// Does it hold now? Its partners collide again where it does not.
void World::Impl::update_live(JointPart& joint) {
  const auto there = [](const BodyState* body) { return !body || body->enabled; };
  const bool wanted = joint.def.enabled && !joint.broken && there(joint.a) && there(joint.b);
  if (wanted == joint.live) return;
  joint.live = wanted;
  solver.joints_changed();
  if (wanted) {
    note_drives(joint);
    live.insert(std::upper_bound(live.begin(), live.end(), &joint,
                                 [](const JointPart* x, const JointPart* y) { return x->serial < y->serial; }),
                &joint);
  } else {
    std::erase(live, &joint);
    joint.force = joint.torque = {};
  }
  for (BodyState* body : {joint.a, joint.b})
    if (body) wake(*body);
  if (!joint.def.collide_connected && joint.a && joint.b) overlaps.renew(*joint.a, *joint.b);
}

void World::Impl::remove_joint(JointPart& joint) {
  joint.def.enabled = false;
  update_live(joint);
  for (BodyState* body : {joint.a, joint.b})
    if (body) std::erase(body->joints, &joint);
  joints.remove(joint.id);
}

}  // namespace tumble
