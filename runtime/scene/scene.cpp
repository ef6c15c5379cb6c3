#include "scene/scene.h"

#include <algorithm>
#include <cassert>

namespace tumble {

namespace {

void check_name(const std::string& name) {
  if (name.find('/') != name.npos) fail("name '", name, "' must not contain '/', which parts the names in a path");
}

}  // namespace

Scene::Scene() { root_ = add("root", {}, "root"); }

NodeId Scene::add(const std::string& name, NodeId parent, const std::string& id, NodeId handle, std::uint64_t serial) {
  if (!parent) parent = root_;  // none yet, for the root itself
  check_name(name);
  claim_id({}, id);

  SceneNode node;
  node.name = name;
  node.id = id.empty() ? new_id() : id;
  node.given_id = !id.empty();
  node.parent = parent;
  node.serial = serial ? serial : next_serial_;
  next_serial_ = std::max(next_serial_, node.serial + 1);
  node.moved_tick = tick_;
  if (!handle) handle = pool_.reserve();
  pool_.place(handle, std::move(node));

  ids_[pool_[handle].id] = handle;
  list_name(handle);
  if (parent) pool_[parent].children.push_back(handle);
  return handle;
}

void Scene::remove(NodeId id, const std::function<bool(NodeId)>& keep) {
  assert(id != root_);
  std::erase(pool_[pool_[id].parent].children, id);
  std::vector<NodeId> going;
  each(id, [&](NodeId below, SceneNode&) { going.push_back(below); });
  // Children first: the last freed handle is given out next, so a tree that is built again gets the same ones.
  for (auto it = going.rbegin(); it != going.rend(); ++it) {
    unlist_name(*it);
    ids_.erase(pool_[*it].id);
    if (keep && keep(*it)) pool_.vacate(*it);
    else pool_.remove(*it);
  }
}

void Scene::set_parent(NodeId id, NodeId parent, bool keep_world) {
  if (is_inside(parent, id))
    fail("node.parent: '", path(parent), "' is ", parent == id ? "the node itself" : "below '" + path(id) + "'",
         "; a node cannot hang below itself");
  const Transform before = world(id);
  SceneNode& node = pool_[id];
  std::erase(pool_[node.parent].children, id);
  node.parent = parent;
  pool_[parent].children.push_back(id);
  Transform local = node.local;
  if (keep_world || node.free) local = local_from_world(id, before);
  write_local(id, local, false);
  node.previous = local;  // the old one was in another parent's space
}

void Scene::sort_children(NodeId id) {
  auto& children = pool_[id].children;
  std::stable_sort(children.begin(), children.end(),
                   [&](NodeId a, NodeId b) { return pool_[a].serial < pool_[b].serial; });
}

void Scene::rename(NodeId node, const std::string& name) {
  check_name(name);
  unlist_name(node);
  pool_[node].name = name;
  list_name(node);
}

void Scene::set_id(NodeId node, const std::string& id) {
  if (pool_[node].id == id) return;
  claim_id(node, id);
  unlist_name(node);
  ids_.erase(pool_[node].id);
  pool_[node].id = id.empty() ? new_id() : id;
  pool_[node].given_id = !id.empty();
  ids_[pool_[node].id] = node;
  list_name(node);
}

// Makes an id free for `node`: one that we made gives way, an author's does not.
void Scene::claim_id(NodeId node, const std::string& id) {
  const auto taken = ids_.find(id);
  if (id.empty() || taken == ids_.end() || taken->second == node) return;
  const NodeId owner = taken->second;
  if (pool_[owner].given_id)
    fail("id '", id, "' is taken by node '", path(owner), "'; every id may stand once in a scene: change or leave out one of them");
  unlist_name(owner);
  ids_.erase(taken);
  pool_[owner].id = new_id();
  ids_[pool_[owner].id] = owner;
  list_name(owner);
}

std::string Scene::new_id() {
  std::string id;
  do id = "n" + std::to_string(next_id_++);
  while (ids_.contains(id));
  return id;
}

void Scene::list_name(NodeId node) { names_[label(pool_[node])][pool_[node].serial] = node; }

void Scene::unlist_name(NodeId node) {
  const auto entry = names_.find(label(pool_[node]));
  entry->second.erase(pool_[node].serial);
  if (entry->second.empty()) names_.erase(entry);
}

}  // namespace tumble
