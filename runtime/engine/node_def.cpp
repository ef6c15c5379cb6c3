#include "engine/node_def.h"

namespace tumble {

namespace {

void describe_components(NodeDef& node, Schema& s) {
  s.add("mesh", node.mesh, "What is drawn, and what a body's collider is fitted to.");
  s.add("material", node.material, "How the mesh looks.");
  s.add("color", node.color, "Color of the material.");
  s.add("light", node.light, "Makes it a light.");
  s.add("camera", node.camera, "Makes it a camera.");
  s.add("sky", node.sky, "Sky and fog around everything.");
  s.add("sound", node.sound, "What is heard from it.");
  s.add("particles", node.particles, "Small sprites that rise from it.");
  s.add("animation", node.animation, "Keyframes that move it.");
  s.add("body", node.body, "Makes it a rigid body.");
  s.add("behaviours", node.behaviours, "Scripts by name, each with a table of its properties.");
  s.add("joints", node.joints,
        "In files: joints from this node, each a table with type, name, b and the options of joint.<type>.");
}

void check_node(const NodeDef& node) {
  for (const auto& [name, properties] : node.behaviours) {
    const List* list = properties.get<List>();
    if (!properties.is<Map>() && !properties.is_nil() && !(list && list->empty()))
      fail("behaviours.", name, ": table of properties expected, got ", kind_name(properties), "; write {} for none");
  }
}

}  // namespace

void describe(JointEntry& joint, Schema& s) {
  s.name("joint_entry", "A joint from the node that holds it, with the options of joint.<type> beside these keys.");
  s.add("type", joint.type, "\"hinge\", \"slider\" ...");
  s.add("name", joint.name, "What node:joint(name) calls it.");
  s.add("b", joint.b, "The other node, by id, name or path; none: the world.");
}

void describe(NodeDef& node, Schema& s) {
  s.name("node", "A thing in the scene: where it is, what it is made of, what is below it.");
  s.add("name", node.name, "What paths and get() call it; nodes may share a name.");
  s.add("id", node.id, "Lasting and unique in the scene; made where it is not given.");
  s.add("tags", node.tags, "Words to find it by.");
  s.add("prefab", node.prefab,
        "Path of a scene file, without ending, that this node is a copy of; other keys override it field by field.");
  s.add("position", node.position, "Relative to the parent, m.");
  s.rotation("rotation", node.rotation, "Relative to the parent.");
  s.add("scale", node.scale, "Relative to the parent, for its children too.").above(0);
  s.add("visible", node.visible, "Off: it and its children are not drawn.");
  s.add("enabled", node.enabled, "Off: no drawing, no body, no updates, for its children too.");
  describe_components(node, s);
  s.add("children", node.children, "Nodes below it.");
  s.check<NodeDef>(check_node);
}

}  // namespace tumble
