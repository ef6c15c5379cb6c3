#include "physics/world.h"

#include <algorithm>

#include "base/hash.h"
#include "base/text.h"
#include "physics/bullet/impl.h"

namespace tumble {

namespace {

bool older(const BodyState* a, const BodyState* b) { return a->serial < b->serial; }

}  // namespace

// ---- the world

World::Impl::Impl(const WorldSettings& given) : settings(given) {
  install_material_callbacks();
  apply_settings();
}

// Pairs end while the book that knows them is there.
World::Impl::~Impl() {
  bodies.each([&](BodyId, Body& body) {
    overlaps.leave(body.state->solid_box);
    overlaps.leave(body.state->trigger_box);
  });
}

void World::Impl::apply_settings() {
  if (!team || team->asked_for() != settings.threads) team = std::make_unique<Team>(settings.threads);
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
  impl_->overlaps.each([](Overlap& overlap) {  // a look found their friction
    if (overlap.pair) overlap.pair->spoil();
  });
  if (new_gravity || !settings.sleeping) impl_->bodies.each([&](BodyId, Body& body) { impl_->wake(*body.state); });
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
  body.solid_box = {&body, body.rigid.get(), false, false, nullptr, {}};
  body.trigger_box = {&body, body.ghost.get(), true, false, nullptr, {}};
  body.enabled = true;
  body.was_asleep = false;
  wake(body);
  stir(body);
  body.boxed = {};
  collision.fit(body);
  wake_around(body);
}

void World::Impl::leave(BodyState& body) {
  wake_touching(body);
  book.end_pairs(body, events);
  overlaps.leave(body.solid_box);
  overlaps.leave(body.trigger_box);
  awake.leave(body);
  body.enabled = body.moving = body.stirred = false;
  body.force = body.torque = {};
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
      joint->live = false;
      solver.joints_changed();
      std::erase(live, joint);
    }
  const bool enabled = body.enabled;
  if (enabled) leave(body);
  build(body, pose);
  if (enabled) enter(body);
  for (JointPart* joint : held) update_live(*joint);
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

// What is known of contacts has their friction, and who meets whom is asked only where boxes meet anew. What sleeps on it
// may have nothing to lie on now.
void World::Impl::refresh_pairs(BodyState& body) {
  if (!body.enabled) return;
  for (Pair* pair : body.pairs) wake(pair->a == &body ? *pair->b : *pair->a);
  body.boxed = {};
  collision.fit(body);
  overlaps.renew(body.solid_box);
  overlaps.renew(body.trigger_box);
  stir(body);
}

// ---- waking

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
  if (!body.solid_box.leaf) return;
  overlaps.boxes().each_in(body.solid_box.box(), false, [this](const Occupant& other) { wake(*other.body); });
}

void World::Impl::stir(BodyState& body) {
  if (body.dynamic()) return;
  body.active = body.def.type == BodyType::kinematic;
  if (!body.stirred) carriers.insert(std::upper_bound(carriers.begin(), carriers.end(), &body, older), &body);
  body.stirred = true;
  overlaps.stir(body);
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
  stats.islands = impl_->solver.islands();
  stats.substeps = impl_->solver.most_substeps();
  stats.step_ms = impl_->step_ms;
  stats.awake = static_cast<int>(impl_->awake.bodies().size());
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
