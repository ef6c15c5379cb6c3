#include <cassert>

#include "scene/scene.h"

namespace tumble {

namespace {

[[maybe_unused]] bool is_sound(const Transform& t) {
  return is_finite(t.position) && is_finite(t.rotation) && is_finite(t.scale) && t.scale.x > 0 && t.scale.y > 0 && t.scale.z > 0;
}

}  // namespace

void Scene::set_position(NodeId node, Vec3 position) {
  Transform local = pool_[node].local;
  local.position = position;
  write_local(node, local, false);
}

void Scene::set_rotation(NodeId node, Quat rotation) {
  Transform local = pool_[node].local;
  local.rotation = rotation;
  write_local(node, local, false);
}

void Scene::set_scale(NodeId node, Vec3 scale) {
  Transform local = pool_[node].local;
  local.scale = scale;
  write_local(node, local, false);
}

void Scene::set_local(NodeId node, const Transform& local) { write_local(node, local, false); }
void Scene::jump(NodeId node, const Transform& local) { write_local(node, local, true); }

const Transform& Scene::world(NodeId id) const {
  const SceneNode& node = pool_[id];
  if (!node.world_valid) {
    node.world = node.parent ? world(node.parent) * node.local : node.local;
    node.world_valid = true;
  }
  return node.world;
}

Transform Scene::local_from_world(NodeId node, const Transform& world) const {
  const NodeId parent = pool_[node].parent;
  return parent ? relative(this->world(parent), world) : world;
}

void Scene::write_local(NodeId id, const Transform& local, bool jump) {
  assert(is_sound(local));
  SceneNode& node = pool_[id];
  keep_previous(node);
  node.local = local;
  if (jump) node.previous = local;
  world_changed(id, jump);
  if (node.free) world(id);
}

void Scene::keep_previous(SceneNode& node) {
  if (node.moved_tick == tick_) return;
  node.previous = node.local;
  node.moved_tick = tick_;
}

void Scene::world_changed(NodeId id, bool jump) {
  SceneNode& node = pool_[id];
  if (node.watched) list_touched(id, node, jump);
  // What is below an unknown transform is unknown and listed already; only a jump has more to tell it.
  if (!node.world_valid && !jump) return;
  node.world_valid = false;
  children_changed(node, jump);
}

void Scene::children_changed(const SceneNode& node, bool jump) {
  for (const NodeId child : node.children) {
    if (pool_[child].free) hold_in_place(child);
    else world_changed(child, jump);
  }
}

// A free node whose parent moved: the world pose stays, the local one follows from it. Its scale is its parent's too.
void Scene::hold_in_place(NodeId id) {
  SceneNode& node = pool_[id];
  const Transform& parent = world(node.parent);
  keep_previous(node);
  const Transform local = relative(parent, node.world);
  node.local.position = local.position;
  node.local.rotation = local.rotation;
  const Vec3 scale = (parent * node.local).scale;
  if (distance(scale, node.world.scale) <= 1e-12 * length(scale)) return;
  node.world.scale = scale;
  if (node.watched) list_touched(id, node, false);
  children_changed(node, false);
}

void Scene::list_touched(NodeId id, SceneNode& node, bool jump) {
  if (node.touched) {
    node.jumped |= jump;
    return;
  }
  node.touched = true;
  node.jumped = jump;
  touched_.push_back(id);
}

void Scene::set_from_physics(NodeId id, const Pose& pose) {
  SceneNode& node = pool_[id];
  keep_previous(node);
  const Transform& before = world(id);
  const Transform local = local_from_world(id, {pose.position, pose.rotation, before.scale});
  node.local.position = local.position;
  node.local.rotation = local.rotation;
  node.world = {pose.position, pose.rotation, before.scale};
  children_changed(node, false);
}

void Scene::set_watched(NodeId id, bool watched) {
  world(id);
  pool_[id].watched = watched;
}

void Scene::set_free(NodeId id, bool free) {
  world(id);
  pool_[id].free = free;
}

std::vector<NodeId> Scene::take_touched() {
  std::vector<NodeId> touched;
  for (const NodeId id : touched_) {
    SceneNode* node = pool_.get(id);
    if (!node || !node->touched) continue;
    node->touched = false;
    world(id);
    if (node->watched) touched.push_back(id);
  }
  touched_.clear();
  return touched;
}

Transform Scene::interpolated(const SceneNode& node, const Transform& parent_world, double alpha) const {
  if (node.moved_tick != tick_ || alpha >= 1) return parent_world * node.local;
  return parent_world * between(node.previous, node.local, alpha);
}

Transform Scene::interpolated_world(NodeId id, double alpha) const {
  const SceneNode& node = pool_[id];
  return interpolated(node, node.parent ? interpolated_world(node.parent, alpha) : Transform{}, alpha);
}

}  // namespace tumble
