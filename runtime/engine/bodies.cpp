// Bodies of nodes: made, changed and removed together with what the scene and the joints must know of them.

#include <algorithm>

#include "base/text.h"
#include "engine/colliders.h"
#include "engine/engine_private.h"

namespace tumble {

namespace {

void check_groups(const BodyDef& def, std::vector<std::string> known, const std::string& call) {
  known.push_back("default");
  const auto check = [&](const char* field, const std::string& group) {
    if (!group.empty() && std::find(known.begin(), known.end(), group) == known.end())
      fail(call, ": body.", field, ": unknown group '", group, "'", did_you_mean(group, known), "; groups are listed in game.json: ",
           "physics.groups");
  };
  check("group", def.group);
  for (const std::string& group : def.collides_with) check("collides_with", group);
}

// Only a world can tell whether such a shape can be built.
bool is_made_of_points(const ColliderDef& collider) {
  const ShapeKind kind = collider.shape.shape;
  return kind == ShapeKind::hull || kind == ShapeKind::mesh || kind == ShapeKind::height_field;
}

}  // namespace

BodyComponent* Engine::body(NodeId node) {
  return const_cast<BodyComponent*>(std::as_const(*this).body(node));
}

const BodyComponent* Engine::body(NodeId node) const {
  const auto* extra = scene.get(node) ? private_->find(node) : nullptr;
  return extra ? extra->body.get() : nullptr;
}

NodeId Engine::node_of(BodyId body) const {
  return world_ && world_->has(body) ? unpack<SceneNode>(world_->user(body)) : NodeId{};
}

std::pair<NodeId, NodeId> Engine::nodes_of(const ContactEvent& contact) const {
  return {unpack<SceneNode>(contact.user_a), unpack<SceneNode>(contact.user_b)};
}

BodyDef Engine::body_def(NodeId node) const {
  const BodyComponent& component = *body(node);
  BodyDef def = component.def;
  if (!component.id) return def;
  def.velocity = world_->velocity(component.id);
  def.angular_velocity = world_->angular_velocity(component.id);
  return def;
}

// As the world gets it; throws where that is not possible, before anything is changed.
BodyDef Engine::physical(NodeId node, const BodyDef& def, const std::string& call) const {
  check_groups(def, settings.physics.groups, call);
  const BodyDef physical = fitted(def, scene[node].mesh, scene.world(node).scale, [this](const Shape& shape) { return with_points(shape); }, call);
  if (!with_world_ && std::any_of(physical.colliders.begin(), physical.colliders.end(), is_made_of_points))
    worded(call, [&] { World(settings.physics).add(physical, {}, 0); });
  return physical;
}

void Engine::set_body(NodeId node, const std::optional<BodyDef>& def, const std::string& call) {
  if (!def) remove_body(node);
  else if (body(node)) change_body(node, *def, call);
  else make_body(node, *def, call);
}

void Engine::configure_body(NodeId node, const BodyDef& def, const std::string& call) { set_body(node, def, call); }

void Engine::make_body(NodeId node, const BodyDef& def, const std::string& call) {
  const BodyDef physical = this->physical(node, def, call);
  const Transform& place = scene.world(node);
  auto component = std::make_unique<BodyComponent>();
  component->def = def;
  component->scale = place.scale;
  component->placed = {place.position, place.rotation};
  if (with_world_) {
    auto first = world_ ? nullptr : std::make_unique<World>(settings.physics);
    worded(call, [&] { component->id = (first ? *first : *world_).add(physical, component->placed, pack(node)); });
    if (first) world_ = std::move(first);
    if (!scene.enabled_in_tree(node)) world_->set_enabled(component->id, false);
  }
  private_->extra(node).body = std::move(component);
  scene.set_watched(node, true);
  scene.set_free(node, def.type == BodyType::dynamic);
  warn_of_nested_bodies(node);
  for (const JointRef joint : private_->extra(node).joints) activate(joint);
}

void Engine::change_body(NodeId node, const BodyDef& def, const std::string& call) {
  const BodyDef physical = this->physical(node, def, call);
  BodyComponent& component = *body(node);
  if (component.id) worded(call, [&] { world_->configure(component.id, physical); });
  const bool new_type = component.def.type != def.type;
  component.def = def;
  component.scale = scene.world(node).scale;
  if (!new_type) return;
  scene.set_free(node, def.type == BodyType::dynamic);
  warn_of_nested_bodies(node);
}

void Engine::remove_body(NodeId node) {
  const BodyComponent* component = body(node);
  if (!component) return;
  for (const JointRef joint : private_->extra(node).joints) deactivate(joint);
  if (component->id) world_->remove(component->id);
  private_->extra(node).body.reset();
  scene.set_watched(node, false);
  scene.set_free(node, false);
}

// After its mesh or its world scale has changed. Anchors on it are in its frame and stretch along.
void Engine::refit_body(NodeId node) {
  BodyComponent& component = *body(node);
  const Vec3 ratio = unscaled(scene.world(node).scale, component.scale);
  change_body(node, body_def(node), "node '" + scene.path(node) + "'");
  if (ratio == Vec3{1, 1, 1}) return;
  for (const JointRef joint : private_->extra(node).joints) {
    JointRecord& record = joints_[joint];
    if (record.a != node) continue;
    record.def.anchor = scaled(record.def.anchor, ratio);
    if (record.id) world_->configure(record.id, record.def);
  }
}

void Engine::set_mesh(NodeId node, const std::optional<Shape>& mesh, const std::string& call) {
  const std::optional<Shape> before = std::exchange(scene[node].mesh, mesh ? std::optional(settled(*mesh)) : mesh);
  ask_for_files(node);
  const BodyComponent* component = body(node);
  if (!component || !component->def.colliders.empty() || component->def.fit == Fit::node) return;
  try {
    change_body(node, body_def(node), call);
  } catch (const Error&) {
    scene[node].mesh = before;
    throw;
  }
}

void Engine::want_stay(NodeId node, bool on) {
  BodyComponent* component = body(node);
  if (!component) return;
  component->wants_stay = on;
  if (component->id) world_->want_stay(component->id, on);
}

// A body is on while its node and all above it are enabled.
void Engine::refresh_enabled(NodeId node) {
  if (!world_) return;
  scene.each(node, [this](NodeId below, SceneNode&) {
    const BodyComponent* component = body(below);
    if (!component || !component->id) return;
    const bool enabled = scene.enabled_in_tree(below);
    if (enabled != world_->enabled(component->id)) world_->set_enabled(component->id, enabled);
  });
}

void Engine::warn_of_nested_bodies(NodeId node) const {
  if (!log || body(node)->def.type != BodyType::dynamic) return;
  for (NodeId above = scene[node].parent; above; above = scene[above].parent) {
    const BodyComponent* component = body(above);
    if (!component || component->def.type != BodyType::dynamic) continue;
    return warn("node '" + scene.path(node) + "': a dynamic body does not follow the dynamic body '" + scene.path(above) +
                "' above it; use a joint or a second collider");
  }
}

void Engine::configure_physics(const WorldSettings& physics) {
  settings.physics = physics;
  if (world_) world_->configure(physics);
}

}  // namespace tumble
