// What the engine's own files share: the data behind engine.h.
#pragma once

#include <limits>
#include <map>
#include <set>

#include "base/error.h"
#include "engine/engine.h"
#include "engine/shape_files.h"

namespace tumble {

// What restart_scene gives a node back, beside its handle.
struct FirstNode {
  NodeDef def;          // without children
  NodeId parent;
  bool given_id = false;
  std::uint64_t serial = 0;
  Origin origin = Origin::declared;
};

struct Engine::Private {
  // By node index; emptied before a node goes.
  struct Extra {
    std::unique_ptr<BodyComponent> body;
    std::vector<JointRef> joints;  // by age
  };
  std::vector<Extra> extras;
  std::map<NodeId, FirstNode> first_nodes;
  std::map<JointRef, JointRecord> first_joints;
  std::uint64_t next_joint_serial = 1;
  NodeId loaded_root;      // also while it is destroyed; none before a load
  NodeId own_camera;       // the one that camera() made
  bool camera_checked = false;
  ShapeFiles shape_files;

  // What an animation did last: `to` is where its time went from `from`, not yet brought back into the clip.
  struct Playing {
    std::string clip;
    double applied = std::numeric_limits<double>::quiet_NaN();  // time that nodes were moved to
    double from = 0, to = 0;
    std::uint64_t tick = 0;
  };
  std::map<NodeId, Playing> animations;   // of all nodes that have one, and of some that had
  std::vector<AnimationEnd> animation_ends;
  std::set<std::string> said;             // hints about animations

  Extra& extra(NodeId node) {
    if (node.index >= extras.size()) extras.resize(node.index + 1);
    return extras[node.index];
  }
  // By age, parents before their children.
  std::vector<NodeId> first_nodes_by_age() const;
  const Extra* find(NodeId node) const { return node.index < extras.size() ? &extras[node.index] : nullptr; }
};

// Runs what may throw; its errors then begin with the call that the author wrote.
template <class F>
void worded(const std::string& call, F&& f) {
  try {
    f();
  } catch (const Error& error) {
    const std::string text = error.what();
    if (text.starts_with(call)) throw;
    fail(call, ": ", text);
  }
}

// Handles as the world's user numbers.
template <class T>
std::uint64_t pack(Handle<T> handle) {
  return std::uint64_t{handle.generation} << 32 | handle.index;
}
template <class T>
Handle<T> unpack(std::uint64_t number) {
  return {static_cast<std::uint32_t>(number), static_cast<std::uint32_t>(number >> 32)};
}

}  // namespace tumble
