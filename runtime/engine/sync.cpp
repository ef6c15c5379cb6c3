// The one place where scene and physics meet: what scripts write to transforms, and what a step moves.

#include <utility>

#include "engine/engine_private.h"

namespace tumble {

namespace {

constexpr int kWritesUntilHint = 60;  // a second of ticks: long enough to be no accident

bool same_scale(Vec3 a, Vec3 b) { return distance(a, b) <= 1e-9 * length(b); }

}  // namespace

// ---- written by scripts

// Dynamic bodies jump at once, so that queries in the same tick find them; others are brought along before the step.
void Engine::write_local(NodeId node, const Transform& local) {
  const BodyComponent* component = body(node);
  if (!component || component->def.type != BodyType::dynamic) return scene.set_local(node, local);
  scene.jump(node, local);
  sync_body(node);
  scene.untouch(node);
}

void Engine::set_position(NodeId node, Vec3 position) {
  Transform local = scene[node].local;
  local.position = position;
  write_local(node, local);
}

void Engine::set_rotation(NodeId node, Quat rotation) {
  Transform local = scene[node].local;
  local.rotation = normalized(rotation);
  write_local(node, local);
}

void Engine::set_scale(NodeId node, Vec3 scale) {
  Transform local = scene[node].local;
  local.scale = scale;
  write_local(node, local);
}

void Engine::set_world_position(NodeId node, Vec3 position) {
  const NodeId parent = scene[node].parent;
  set_position(node, parent ? from_parent(scene.world(parent), position) : position);
}

void Engine::set_world_rotation(NodeId node, Quat rotation) {
  const NodeId parent = scene[node].parent;
  set_rotation(node, parent ? conjugate(scene.world(parent).rotation) * rotation : rotation);
}

void Engine::teleport(NodeId node, Vec3 position, std::optional<Quat> rotation) {
  Transform local = scene[node].local;
  local.position = position;
  if (rotation) local.rotation = normalized(*rotation);
  scene.jump(node, local);
  if (!body(node)) return;
  sync_body(node);
  scene.untouch(node);
}

void Engine::set_enabled(NodeId node, bool enabled) {
  scene[node].enabled = enabled;
  refresh_enabled(node);
}

void Engine::set_parent(NodeId node, NodeId parent) {
  if (!parent) parent = scene.root();
  if (node == scene.root()) fail("node.parent: the root of all nodes has no parent; move its children");
  if (!alive(parent)) fail("node.parent: the new parent was destroyed; choose a node that is alive");
  scene.set_parent(node, parent, true);
  refresh_enabled(node);
  scene.each(node, [this](NodeId below, SceneNode&) {
    if (body(below)) warn_of_nested_bodies(below);
  });
}

// ---- scene to physics

// Brings the world's body to where its node is.
void Engine::sync_body(NodeId node) {
  BodyComponent* component = body(node);
  if (!component || !component->id) return;
  const Transform& place = scene.world(node);
  if (!same_scale(place.scale, component->scale)) refit_body(node);
  const Pose pose{place.position, place.rotation};
  // The world's own pose of a body that only we move may differ from ours in the last digits.
  const bool dynamic = component->def.type == BodyType::dynamic;
  if (pose == (dynamic ? world_->pose(component->id) : component->placed)) return;
  component->placed = pose;

  const bool carries = component->def.type == BodyType::kinematic && !scene[node].jumped && world_->enabled(component->id);
  if (carries) return world_->move(component->id, pose);
  world_->teleport(component->id, pose);
  if (component->def.type == BodyType::fixed && !scene[node].jumped) note_static_write(node, *component);
}

void Engine::note_static_write(NodeId node, BodyComponent& body) const {
  if (body.written_tick == tick) return;
  body.writes_in_a_row = body.written_tick + 1 == tick ? body.writes_in_a_row + 1 : 1;
  body.written_tick = tick;
  if (body.writes_in_a_row < kWritesUntilHint || std::exchange(body.hinted, true)) return;
  warn("node '" + scene.path(node) + "': its static body has been moved in " + std::to_string(kWritesUntilHint) +
       " ticks in a row; with body = \"kinematic\" it pushes and carries what it touches");
}

// ---- the step

void Engine::step(double seconds) {
  animate(seconds);
  if (!world_) return;
  for (const NodeId node : scene.take_touched()) sync_body(node);
  world_->step(seconds);
  for (const BodyId body : world_->moved()) scene.set_from_physics(unpack<SceneNode>(world_->user(body)), world_->pose(body));
}

}  // namespace tumble
