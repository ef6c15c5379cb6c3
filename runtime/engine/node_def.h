// A node written down: the keys of scene.add, of scene files and of node properties, in one struct.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "physics/body.h"
#include "physics/joint.h"
#include "scene/node.h"

namespace tumble {

// A joint of the node that holds it (its `a`), as scene files write it; `b` is an id, name or path.
struct JointEntry {
  std::string type;                 // "hinge", ...
  std::string name;
  std::string b;                    // "": the world
  Value options;                    // everything else, as for joint.<type>
};
void describe(JointEntry& joint, Schema& s);  // without the options

struct NodeDef {
  std::string name;
  std::string id;
  std::vector<std::string> tags;
  Vec3 position;
  Quat rotation;
  Vec3 scale{1, 1, 1};
  bool visible = true, enabled = true;
  std::optional<Shape> mesh;
  std::optional<Material> material;
  std::optional<Color> color;       // of the material
  std::optional<Light> light;
  std::optional<Camera> camera;
  std::optional<Sky> sky;
  std::optional<Sound> sound;
  std::optional<Particles> particles;
  std::optional<Animation> animation;
  std::optional<BodyDef> body;
  std::map<std::string, Value> behaviours;   // name -> table of properties; nil only in files, in a copy of a prefab: none
  std::vector<Value> joints;        // of nodes from files: each a JointEntry
  std::vector<NodeDef> children;
  std::string prefab;               // path without ending; of a node from a file: here begins a copy of that prefab, and
                                    // what the joints inside call `b` is looked for from this node first
};
void describe(NodeDef& node, Schema& s);

}  // namespace tumble
