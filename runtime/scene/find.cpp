#include <algorithm>

#include "base/error.h"
#include "base/text.h"
#include "scene/scene.h"

namespace tumble {

namespace {

std::vector<std::string_view> split(std::string_view path) {
  std::vector<std::string_view> names;
  for (std::size_t slash; (slash = path.find('/')) != path.npos; path.remove_prefix(slash + 1))
    names.push_back(path.substr(0, slash));
  names.push_back(path);
  return names;
}

}  // namespace

// Compares from the last name upwards; the nodes named must lie below `from`.
bool Scene::fits(NodeId node, const std::vector<std::string_view>& names, NodeId from) const {
  NodeId at = node;
  for (auto name = names.rbegin(); name != names.rend(); ++name) {
    if (at == root_ || at == from || label(pool_[at]) != *name) return false;
    at = pool_[at].parent;
  }
  return is_inside(at, from);
}

std::vector<NodeId> Scene::find_all(std::string_view path, NodeId from) const {
  if (!from) from = root_;
  const auto names = split(path);
  std::vector<NodeId> found;
  const auto entry = names_.find(names.back());
  if (entry == names_.end()) return found;
  for (const auto& [serial, node] : entry->second)
    if (fits(node, names, from)) found.push_back(node);
  // Of a path that is whole for one node and the end of another's, the whole one is meant.
  if (names.size() > 1)
    for (const NodeId node : found) {
      NodeId top = node;
      for (std::size_t i = 0; i < names.size(); ++i) top = pool_[top].parent;
      if (top == from) return {node};
    }
  return found;
}

NodeId Scene::find(std::string_view path, NodeId from) const {
  const auto found = find_all(path, from);
  return found.empty() ? NodeId{} : found.front();
}

NodeId Scene::find_id(const std::string& id) const {
  const auto found = ids_.find(id);
  return found == ids_.end() ? NodeId{} : found->second;
}

NodeId Scene::get_by_path(std::string_view path, NodeId from, const std::string& call) const {
  if (!from) from = root_;
  const auto found = find_all(path, from);
  if (found.size() == 1) return found.front();

  const std::string place = from == root_ ? "" : " below '" + this->path(from) + "'";
  if (found.empty()) {
    std::vector<std::string> known;
    each(from, [&](NodeId node, const SceneNode& content) {
      if (node == from) return;
      known.push_back(label(content));
      known.push_back(this->path(node));
    });
    fail(call, ": no node '", path, "'", place, did_you_mean(path, known));
  }
  std::vector<std::string> paths;
  for (const NodeId node : found) paths.push_back("'" + this->path(node) + "'");
  fail(call, ": ", found.size(), " nodes fit '", path, "'", place, ": ", join(paths), "; rename some or give a longer path");
}

std::string Scene::path(NodeId node) const {
  std::string path;
  for (NodeId at = node; at != root_; at = pool_[at].parent) path = label(pool_[at]) + (path.empty() ? "" : "/") + path;
  return path;
}

std::vector<NodeId> Scene::tagged(std::string_view tag) const {
  std::vector<NodeId> nodes;
  each(root_, [&](NodeId node, const SceneNode& content) {
    if (std::find(content.tags.begin(), content.tags.end(), tag) != content.tags.end()) nodes.push_back(node);
  });
  return nodes;
}

void Scene::each(NodeId from, const std::function<void(NodeId, SceneNode&)>& f) {
  SceneNode& node = pool_[from];
  f(from, node);
  for (const NodeId child : node.children) each(child, f);
}

void Scene::each(NodeId from, const std::function<void(NodeId, const SceneNode&)>& f) const {
  const SceneNode& node = pool_[from];
  f(from, node);
  for (const NodeId child : node.children) each(child, f);
}

bool Scene::is_inside(NodeId node, NodeId ancestor) const {
  for (; node; node = pool_[node].parent)
    if (node == ancestor) return true;
  return false;
}

bool Scene::enabled_in_tree(NodeId node) const {
  for (; node; node = pool_[node].parent)
    if (!pool_[node].enabled) return false;
  return true;
}

}  // namespace tumble
