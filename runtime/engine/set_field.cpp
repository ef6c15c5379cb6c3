// Writing one field of a node by its name, as reload, the inspector and other tools do.

#include <map>
#include <utility>

#include "base/text.h"
#include "engine/animation.h"
#include "engine/engine_private.h"
#include "engine/fields.h"

namespace tumble {

namespace {

using Write = void (*)(Engine& engine, NodeId node, const NodeDef& def, const std::string& call);

void write_color(Engine& engine, NodeId id, const NodeDef& def, const std::string&) {
  SceneNode& node = engine.scene[id];
  if (!def.color && !node.material) return;
  (node.material ? *node.material : node.material.emplace()).color = def.color.value_or(Material{}.color);
}

void write_animation(Engine& engine, NodeId id, const NodeDef& def, const std::string&) {
  SceneNode& node = engine.scene[id];
  const std::optional<Animation> before = std::exchange(node.animation, def.animation);
  if (before && node.animation) restart_clip(engine, node, *before);
}

void write_particles(Engine& engine, NodeId node, const NodeDef& def, const std::string&) {
  engine.scene[node].particles = def.particles;
  if (def.particles) engine.particles.note(node);
}

// What a field of NodeDef sets; a name that scripts write twice (`rotation_degrees`) comes as the field itself.
const std::map<std::string, Write, std::less<>>& writes() {
  static const std::map<std::string, Write, std::less<>> table = {
      {"name", [](Engine& e, NodeId n, const NodeDef& d, const std::string&) { e.scene.rename(n, d.name); }},
      {"id", [](Engine& e, NodeId n, const NodeDef& d, const std::string&) { e.scene.set_id(n, d.id); }},
      {"tags", [](Engine& e, NodeId n, const NodeDef& d, const std::string&) { e.scene[n].tags = d.tags; }},
      {"position", [](Engine& e, NodeId n, const NodeDef& d, const std::string&) { e.set_position(n, d.position); }},
      {"rotation", [](Engine& e, NodeId n, const NodeDef& d, const std::string&) { e.set_rotation(n, d.rotation); }},
      {"scale", [](Engine& e, NodeId n, const NodeDef& d, const std::string&) { e.set_scale(n, d.scale); }},
      {"visible", [](Engine& e, NodeId n, const NodeDef& d, const std::string&) { e.scene[n].visible = d.visible; }},
      {"enabled", [](Engine& e, NodeId n, const NodeDef& d, const std::string&) { e.set_enabled(n, d.enabled); }},
      {"mesh", [](Engine& e, NodeId n, const NodeDef& d, const std::string& call) { e.set_mesh(n, d.mesh, call); }},
      {"material", [](Engine& e, NodeId n, const NodeDef& d, const std::string&) { e.scene[n].material = d.material; }},
      {"color", write_color},
      {"light", [](Engine& e, NodeId n, const NodeDef& d, const std::string&) { e.scene[n].light = d.light; }},
      {"camera", [](Engine& e, NodeId n, const NodeDef& d, const std::string&) { e.scene[n].camera = d.camera; }},
      {"sky", [](Engine& e, NodeId n, const NodeDef& d, const std::string&) { e.scene[n].sky = d.sky; }},
      {"sound", [](Engine& e, NodeId n, const NodeDef& d, const std::string& call) { e.set_sound(n, d.sound, call); }},
      {"particles", write_particles},
      {"animation", write_animation},
      {"body", [](Engine& e, NodeId n, const NodeDef& d, const std::string& call) { e.set_body(n, d.body, call); }},
  };
  return table;
}

}  // namespace

void Engine::set_field(NodeId node, const std::string& path, const Value& value, const std::string& call) {
  NodeDef def = this->def(node);
  assign_path(def, path, value, call);
  const std::string_view head = split_path(path).first;
  const Field* field = type_of<NodeDef>().field(head);
  if (!field) field = type_of<NodeDef>().field_in_degrees(head);
  const auto write = writes().find(field->name);
  if (write == writes().end())
    fail(call, ": ", head, " of a node that is there already cannot be set as a field; it is read when the node is made");
  write->second(*this, node, def, call);
  ask_for_files(node);
  list_animation(node);
}

}  // namespace tumble
