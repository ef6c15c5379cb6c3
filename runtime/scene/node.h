// A node and the components that the scene itself keeps. Bodies and joints are the world's, behaviours the scripts'.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/handle.h"
#include "base/shape.h"
#include "scene/components.h"

namespace tumble {

struct SceneNode;
using NodeId = Handle<SceneNode>;

struct Transform {
  Vec3 position;
  Quat rotation;
  Vec3 scale{1, 1, 1};
  bool operator==(const Transform&) const = default;
};
// The child's transform in the parent's space. Under a parent of unequal scale a turned child would be sheared; its
// scale is then taken along its own axes, which is what is drawn and simulated, without shear.
Transform operator*(const Transform& parent, const Transform& child);
// The child for which parent * child is `world`.
Transform relative(const Transform& parent, const Transform& world);
// Positions and scales along the line, rotations the short way round.
Transform between(const Transform& a, const Transform& b, double t);
inline Vec3 to_parent(const Transform& t, Vec3 p) { return t.position + t.rotation * scaled(t.scale, p); }
inline Vec3 from_parent(const Transform& t, Vec3 p) { return unscaled(conjugate(t.rotation) * (p - t.position), t.scale); }

// Where a node came from: it decides what a reload, scene.load and scene.restart do with it.
enum class Origin : std::uint8_t { declared, loaded, added };

struct SceneNode {
  std::string name;                     // may be empty; without '/'
  std::string id;                       // lasting, unique in the scene
  bool given_id = false;                // by the author; one that we made yields to an equal one from a file
  std::vector<std::string> tags;
  NodeId parent;
  std::vector<NodeId> children;
  std::uint64_t serial = 0;             // age: later nodes have larger ones
  Transform local;                      // write through Scene
  Transform previous;                   // local at the start of the tick in which it moved last
  std::uint64_t moved_tick = 0;
  bool watched = false;                 // listed by Scene::take_touched when its world transform is written
  bool touched = false;                 // in that list now
  bool jumped = false;                  // among the writes that listed it was a jump: no carrying
  bool free = false;                    // owns its world pose, as a dynamic body: a parent that moves leaves it behind
  bool visible = true, enabled = true;
  bool dying = false;                   // destroyed, until the end of the tick
  Origin origin = Origin::added;
  std::optional<Shape> mesh;
  std::optional<Material> material;
  std::optional<Light> light;
  std::optional<Camera> camera;
  std::optional<Sky> sky;
  std::optional<Sound> sound;
  std::optional<Particles> particles;
  std::optional<Animation> animation;

  mutable Transform world;              // cached; ask Scene::world
  mutable bool world_valid = false;
};
// What paths call it: its name, or the id of a node without one.
inline const std::string& label(const SceneNode& node) { return node.name.empty() ? node.id : node.name; }

}  // namespace tumble
