// The tree of nodes: names, paths, transforms. It owns the nodes; everyone else holds a NodeId.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "scene/node.h"

namespace tumble {

class Scene {
 public:
  Scene();

  NodeId root() const { return root_; }
  SceneNode* get(NodeId node) { return pool_.get(node); }
  const SceneNode* get(NodeId node) const { return pool_.get(node); }
  SceneNode& operator[](NodeId node) { return pool_[node]; }
  const SceneNode& operator[](NodeId node) const { return pool_[node]; }
  std::size_t size() const { return pool_.size(); }  // the root included

  // A node without components, last among its parent's children (the root's, where no parent is given). An empty id
  // gets a new one; an id that is taken is an Error. `handle` and `serial`, where given, were reserved or had before.
  NodeId add(const std::string& name, NodeId parent = {}, const std::string& id = "", NodeId handle = {},
             std::uint64_t serial = 0);
  NodeId reserve() { return pool_.reserve(); }
  void release(NodeId reserved) { pool_.remove(reserved); }
  // With all its descendants, at once. Those with `keep` true keep their handles reserved for a later add().
  void remove(NodeId node, const std::function<bool(NodeId)>& keep = {});
  // Keeps the world transform where `keep_world`, else the local one. A parent below the node itself is an Error.
  void set_parent(NodeId node, NodeId parent, bool keep_world);
  void sort_children(NodeId node);  // by age
  void rename(NodeId node, const std::string& name);
  void set_id(NodeId node, const std::string& id);

  // ---- finding. A path is names joined by '/': it fits every node below `from` whose own name and those of its
  // parents end so. A node without a name goes by its id.
  NodeId find(std::string_view path, NodeId from = {}) const;  // the oldest; the default handle where there is none
  std::vector<NodeId> find_all(std::string_view path, NodeId from = {}) const;  // by age
  NodeId find_id(const std::string& id) const;
  // Error where there is none (with the nearest path) or where several have that name (with their paths).
  NodeId get_by_path(std::string_view path, NodeId from, const std::string& call) const;
  std::string path(NodeId node) const;                         // from the root down; "" for the root
  std::vector<NodeId> tagged(std::string_view tag) const;      // tree order
  // Depth first, parents first. The callback may not add, remove or reorder.
  void each(NodeId from, const std::function<void(NodeId, SceneNode&)>& f);
  void each(NodeId from, const std::function<void(NodeId, const SceneNode&)>& f) const;
  bool is_inside(NodeId node, NodeId ancestor) const;          // or the same
  bool enabled_in_tree(NodeId node) const;                     // it and all its ancestors are

  // ---- transforms; all numbers finite, scales above 0, rotations of length 1
  void set_position(NodeId node, Vec3 position);
  void set_rotation(NodeId node, Quat rotation);
  void set_scale(NodeId node, Vec3 scale);
  void set_local(NodeId node, const Transform& local);
  // Like set_local, but nothing is drawn in between and a kinematic body jumps.
  void jump(NodeId node, const Transform& local);
  const Transform& world(NodeId node) const;
  Transform local_from_world(NodeId node, const Transform& world) const;
  // Written by the physics: not listed as touched, but watched nodes below it are.
  void set_from_physics(NodeId node, const Pose& world);
  void set_watched(NodeId node, bool watched);
  void set_free(NodeId node, bool free);
  // Watched nodes whose world transform was written since the last call, by themselves or an ancestor, in order of
  // the first writing. Nodes that nobody watches cost nothing here.
  std::vector<NodeId> take_touched();
  // The node was seen to already; what is below it stays listed.
  void untouch(NodeId node) { pool_[node].touched = false; }
  // Begins tick number `tick`: what is written from now on is drawn interpolated from where it is now.
  void begin_tick(std::uint64_t tick) { tick_ = tick; }
  // World transform between the last tick (alpha 0) and this one (alpha 1), given that of the parent.
  Transform interpolated(const SceneNode& node, const Transform& parent_world, double alpha) const;
  Transform interpolated_world(NodeId node, double alpha) const;

 private:
  void claim_id(NodeId node, const std::string& id);
  std::string new_id();
  void list_name(NodeId node);
  void unlist_name(NodeId node);
  bool fits(NodeId node, const std::vector<std::string_view>& names, NodeId from) const;

  void write_local(NodeId node, const Transform& local, bool jump);
  void keep_previous(SceneNode& node);
  void world_changed(NodeId node, bool jump);
  void children_changed(const SceneNode& node, bool jump);
  void hold_in_place(NodeId node);
  void list_touched(NodeId id, SceneNode& node, bool jump);

  // Invariants of the cached world transforms: below an unknown one all are unknown; a watched node's is known or the
  // node is listed; a free node's is known always, for it is the truth and `local` follows from it.
  Pool<SceneNode> pool_;
  NodeId root_;
  std::uint64_t next_serial_ = 1;
  std::uint64_t next_id_ = 1;
  std::uint64_t tick_ = 0;
  std::unordered_map<std::string, NodeId> ids_;  // looked up only, never walked
  std::map<std::string, std::map<std::uint64_t, NodeId>, std::less<>> names_;  // name or id -> by age
  std::vector<NodeId> touched_;
};

}  // namespace tumble
