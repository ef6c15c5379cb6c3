#include "physics/world.h"

#include <algorithm>

#include "base/hash.h"
#include "base/text.h"
#include "physics/bullet/impl.h"

namespace tumble {

namespace {

bool older(const BodyState* a, const BodyState* b) { return a->serial < b->serial; }

struct WakeAll final : btBroadphaseAabbCallback {
  explicit WakeAll(World::Impl& owner) : world(owner) {}
  bool process(const btBroadphaseProxy* proxy) override {
    BodyState& body = *state_of(static_cast<btCollisionObject*>(proxy->m_clientObject));
    if (body.dynamic()) world.wake(body);
    return true;
  }
  World::Impl& world;
};

}  // namespace

// ---- the world

World::Impl::Impl(const WorldSettings& given) : settings(given) {
  install_material_callbacks();
  filter.pairs = broadphase.getOverlappingPairCache();
  broadphase.getOverlappingPairCache()->setOverlapFilterCallback(&filter);
  bullet.setGravity({0, 0, 0});
  apply_settings();
}

World::Impl::~Impl() {
  joints.each([&](JointId, Joint& joint) {
    if (joint.part->live) bullet.removeConstraint(joint.part->constraint.get());
  });
  bodies.each([&](BodyId, Body& body) {
    if (!body.state->enabled) return;
    if (body.state->ghost) bullet.removeCollisionObject(body.state->ghost.get());
    bullet.removeRigidBody(body.state->rigid.get());
  });
}

void World::Impl::apply_settings() {
  materials = {settings.default_friction, settings.default_restitution, settings.friction_combine, settings.restitution_combine};
}

World::World(const WorldSettings& settings) : impl_(std::make_unique<Impl>(settings)) {}
World::~World() = default;
const WorldSettings& World::settings() const { return impl_->settings; }

void World::configure(const WorldSettings& settings) {
  const bool new_gravity = !(settings.gravity == impl_->settings.gravity);
  const bool new_groups = settings.groups != impl_->settings.groups;
  if (new_groups) impl_->change_groups(settings.groups);
  impl_->settings = settings;
  impl_->apply_settings();
  for (KeptContact* kept : impl_->dispatcher.kept) kept->spoil();  // a look found their friction
  if (new_gravity || !settings.sleeping)
    for (BodyState* body : impl_->dynamics) impl_->wake(*body);
}

// All or nothing: a body may be in a group that is no more.
void World::Impl::change_groups(const std::vector<std::string>& groups) {
  const std::vector<std::string> before = std::exchange(settings.groups, groups);
  const auto set_all = [&] { bodies.each([&](BodyId, Body& body) { set_groups(*body.state, "physics.groups"); }); };
  try {
    set_all();
  } catch (const Error&) {
    settings.groups = before;
    set_all();
    throw;
  }
  bodies.each([&](BodyId, Body& body) { refresh_pairs(*body.state); });
}

std::uint32_t World::group_bit(const std::string& group) const {
  if (const auto bit = impl_->find_group(group)) return *bit;
  impl_->fail_group("physics", group);
}

std::optional<std::uint32_t> World::Impl::find_group(const std::string& name) const {
  const auto at = std::find(settings.groups.begin(), settings.groups.end(), name);
  if (at != settings.groups.end()) return 2u << (at - settings.groups.begin());
  if (name.empty() || name == "default") return 1;
  return {};
}

void World::Impl::fail_group(const char* where, const std::string& name) const {
  fail(where, ": no collision group '", name, "'; ",
       settings.groups.empty() ? "list it in physics.groups" : "the groups are " + join(settings.groups),
       did_you_mean(name, settings.groups));
}

void World::Impl::set_groups(BodyState& body, const char* where) {
  const auto bit = [&](const std::string& name) -> std::uint32_t {
    if (const auto found = find_group(name)) return *found;
    fail_group(where, name);
  };
  const std::uint32_t group = bit(body.def.group);
  std::uint32_t mask = body.def.collides_with.empty() ? ~0u : 0;
  for (const std::string& name : body.def.collides_with) mask |= bit(name);
  body.group = group;
  body.mask = mask;
}

// ---- bodies come and go

BodyId World::add(const BodyDef& def, const Pose& pose, std::uint64_t user) {
  Impl& world = *impl_;
  auto state = std::make_unique<BodyState>();
  state->def = def;
  state->user = user;
  state->materials = &world.materials;
  world.set_groups(*state, "body");
  build(*state, {pose.position, normalized(pose.rotation)});
  BodyState& body = *state;
  body.serial = world.next_serial++;
  body.id = world.bodies.add({std::move(state)});
  world.enter(body);
  return body.id;
}

void World::remove(BodyId id) {
  Impl& world = *impl_;
  BodyState& body = world.body(id);
  while (!body.joints.empty()) world.remove_joint(*body.joints.back());
  if (body.enabled) world.leave(body);
  world.bodies.remove(id);
}

bool World::has(BodyId body) const { return impl_->bodies.get(body) != nullptr; }
std::uint64_t World::user(BodyId body) const { return impl_->body(body).user; }

void World::Impl::enter(BodyState& body) {
  body.boxed = {};
  bullet.addRigidBody(body.rigid.get(), 1, -1);  // who meets whom is PairFilter's business
  if (body.ghost) {
    bullet.addCollisionObject(body.ghost.get(), 1, -1);
    bullet.ghosts.push_back(body.ghost.get());
  }
  body.enabled = true;
  body.still_seconds = 0;
  body.still_at = body.center;
  body.was_asleep = false;
  if (body.dynamic()) {
    dynamics.insert(std::upper_bound(dynamics.begin(), dynamics.end(), &body, older), &body);
    wake(body);
  } else {
    body.rigid->forceActivationState(ISLAND_SLEEPING);
  }
  stir(body);
  wake_around(body);
}

void World::Impl::leave(BodyState& body) {
  wake_touching(body);
  book.end_pairs(body, events);
  if (body.ghost) {
    bullet.removeCollisionObject(body.ghost.get());
    std::erase(bullet.ghosts, body.ghost.get());
  }
  bullet.removeRigidBody(body.rigid.get());
  body.enabled = false;
  body.moving = false;
  body.force = body.torque = {};
  std::erase(dynamics, &body);
  std::erase(carriers, &body);
  std::erase(moved, body.id);
}

void World::set_enabled(BodyId id, bool enabled) {
  Impl& world = *impl_;
  BodyState& body = world.body(id);
  if (body.enabled == enabled) return;
  if (enabled) world.enter(body);
  else {
    body.enabled = false;  // joints look at it
    for (JointPart* joint : body.joints) world.update_live(*joint);
    body.enabled = true;
    world.leave(body);
  }
  for (JointPart* joint : body.joints) world.update_live(*joint);
}

bool World::enabled(BodyId body) const { return impl_->body(body).enabled; }

// ---- descriptions

BodyDef World::def(BodyId id) const {
  const BodyState& body = impl_->body(id);
  BodyDef def = body.def;
  def.velocity = from_bullet(body.rigid->getLinearVelocity());
  def.angular_velocity = from_bullet(body.rigid->getAngularVelocity());
  return def;
}

void World::Impl::rebuild(BodyState& body, const Pose& pose) {
  std::vector<JointPart*> held = body.joints;
  for (JointPart* joint : held)
    if (joint->live) {
      bullet.removeConstraint(joint->constraint.get());
      joint->live = false;
      solver.joints_changed();
      std::erase(live, joint);
    }
  const bool enabled = body.enabled;
  if (enabled) leave(body);
  build(body, pose);
  if (enabled) enter(body);
  for (JointPart* joint : held) {
    joint->constraint.reset();
    update_live(*joint);
  }
}

void World::configure(BodyId id, const BodyDef& def) {
  Impl& world = *impl_;
  BodyState& body = world.body(id);
  const BodyDef before = body.def;
  body.def = def;
  try {
    world.set_groups(body, "body");
    if (!same_shapes(before, def)) {
      for (const bool trigger : {false, true}) ShapeSet(def, trigger, {});  // refuses what cannot be built
    }
  } catch (...) {
    body.def = before;
    world.set_groups(body, "body");
    throw;
  }

  const Pose pose = body.pose();
  if (!same_shapes(before, def)) {
    world.rebuild(body, pose);
    return;
  }
  const MassProperties mass = tumble::mass_properties(def);
  if (mass.center == body.mass.center && mass.axes == body.mass.axes) {
    body.mass = mass;
    apply_numbers(body);
    world.refresh_pairs(body);
    if (body.dynamic()) world.wake(body);
    return;
  }
  world.rebuild(body, pose);
}

// Bullet keeps the friction of known contact points, and asks who meets whom only where boxes meet anew.
void World::Impl::refresh_pairs(BodyState& body) {
  if (!body.enabled) return;
  body.boxed = {};
  bullet.refreshBroadphaseProxy(body.rigid.get());
  if (body.ghost) bullet.refreshBroadphaseProxy(body.ghost.get());
  stir(body);
}

// ---- waking

void World::Impl::wake(BodyState& body) {
  if (!body.dynamic() || !body.enabled) return;
  body.rigid->forceActivationState(ACTIVE_TAG);
  body.rigid->setDeactivationTime(0);
  body.still_seconds = 0;
  body.still_at = body.center;
}

void World::Impl::wake_touching(BodyState& body) {
  for (Pair* pair : body.pairs)
    if (!pair->trigger) wake(pair->a == &body ? *pair->b : *pair->a);
}

void World::Impl::wake_heap(BodyState& body) {
  std::vector<BodyState*> heap = {&body};
  while (!heap.empty()) {
    const BodyState& next = *heap.back();
    heap.pop_back();
    for (const Pair* pair : next.pairs) {
      BodyState& other = pair->a == &next ? *pair->b : *pair->a;
      if (pair->trigger || !other.dynamic() || other.awake()) continue;
      wake(other);
      heap.push_back(&other);
    }
  }
}

void World::Impl::wake_around(BodyState& body) {
  if (body.solids->empty()) return;
  btVector3 low, high;
  body.rigid->getAabb(low, high);
  WakeAll callback(*this);
  broadphase.aabbTest(low, high, callback);
}

void World::Impl::stir(BodyState& body) {
  if (body.dynamic()) return;
  if (body.def.type == BodyType::kinematic) body.rigid->forceActivationState(ACTIVE_TAG);
  if (body.ghost) body.ghost->forceActivationState(ACTIVE_TAG);
  if (std::find(carriers.begin(), carriers.end(), &body) == carriers.end())
    carriers.insert(std::upper_bound(carriers.begin(), carriers.end(), &body, older), &body);
}

// ---- what there is

std::vector<ContactEvent> World::contacts(BodyId id) const {
  const BodyState& body = impl_->body(id);
  std::vector<Pair*> pairs;
  for (Pair* pair : body.pairs)
    if (!pair->trigger) pairs.push_back(pair);
  const auto other = [&](const Pair* pair) { return pair->a == &body ? pair->b : pair->a; };
  std::sort(pairs.begin(), pairs.end(), [&](const Pair* x, const Pair* y) { return older(other(x), other(y)); });
  std::vector<ContactEvent> result;
  for (Pair* pair : pairs) result.push_back(seen_from(*pair, body));
  return result;
}

std::vector<BodyId> World::overlapping(BodyId id) const {
  const BodyState& body = impl_->body(id);
  std::vector<const BodyState*> others;
  for (const Pair* pair : body.pairs)
    if (pair->trigger) others.push_back(pair->a == &body ? pair->b : pair->a);
  std::sort(others.begin(), others.end(), older);
  std::vector<BodyId> result;
  for (const BodyState* other : others) result.push_back(other->id);
  return result;
}

const std::vector<BodyId>& World::moved() const { return impl_->moved; }
void World::want_stay(BodyId body, bool on) { impl_->body(body).want_stay = on; }

WorldStats World::stats() const {
  WorldStats stats;
  stats.bodies = static_cast<int>(impl_->bodies.size());
  stats.joints = static_cast<int>(impl_->live.size());
  stats.contacts = impl_->book.touching();
  stats.step_ms = impl_->step_ms;
  for (const BodyState* body : impl_->dynamics) stats.awake += body->awake();
  return stats;
}

std::uint64_t World::hash() const {
  std::vector<const BodyState*> all;
  impl_->bodies.each([&](BodyId, const Body& body) { all.push_back(body.state.get()); });
  std::sort(all.begin(), all.end(), older);
  Hash hash;
  for (const BodyState* body : all) {
    const Pose center = from_bullet(body->rigid->getWorldTransform());
    hash.add(center.position).add(center.rotation);
    hash.add(from_bullet(body->rigid->getLinearVelocity())).add(from_bullet(body->rigid->getAngularVelocity()));
  }
  return hash.value();
}

}  // namespace tumble
