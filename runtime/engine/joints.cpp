// Joints between nodes: there from creation on, in the world only while both bodies are.

#include <algorithm>

#include "base/text.h"
#include "engine/engine_private.h"
#include "engine/fields.h"
#include "engine/joint_options.h"

namespace tumble {

namespace {

Transform frame_of(const Scene& scene, NodeId a) { return a ? scene.world(a) : Transform{}; }

void check_partners(const Engine& engine, NodeId a, NodeId b, const std::string& call) {
  for (const NodeId node : {a, b})
    if (node && !engine.alive(node)) fail(call, ": one of its nodes was destroyed; join nodes that are alive");
  if (!a && !b) fail(call, ": a and b are both missing (nil); give at least one node, the other may be the world");
  if (a == b) fail(call, ": a and b are the same node '", engine.scene.path(a), "'; give two nodes, or leave b out for the world");
}

// Keeps options as they are read in step with a field that was written, under whichever of its names.
void note_option(Value& options, std::string_view path, const Value& value) {
  const auto [head, rest] = split_path(path);
  const std::string key(head);
  if (!rest.empty()) return note_option(options[key], rest, value);
  if (!options.is<Map>()) options = Map{};
  constexpr std::string_view tail = "_degrees";
  const std::string twin = key.ends_with(tail) ? key.substr(0, key.size() - tail.size()) : key + std::string(tail);
  std::erase_if(*options.get<Map>(), [&](const auto& entry) { return entry.first == key || entry.first == twin || entry.first == "world_" + key; });
  if (!value.is_nil()) options[key] = value;
}

}  // namespace

JointRef Engine::add_joint(const std::string& type, const std::string& name, NodeId a, NodeId b, const Value& options,
                           Origin origin, const std::string& call, JointRef handle) {
  check_partners(*this, a, b, call);
  JointRecord record;
  record.type = type;
  record.name = name;
  record.a = a;
  record.b = b;
  record.options = options;
  record.def = read_joint(type, options, frame_of(scene, a), call);
  record.origin = origin;
  record.serial = private_->next_joint_serial++;

  if (!handle) handle = joints_.reserve();
  if (origin != Origin::added) private_->first_joints[handle] = record;
  place_joint(handle, std::move(record));
  return handle;
}

void Engine::place_joint(JointRef joint, JointRecord record) {
  for (const NodeId node : {record.a, record.b})
    if (node) private_->extra(node).joints.push_back(joint);
  joints_.place(joint, std::move(record));
  activate(joint);
}

// The node that a file's joint names: by id, else by name or path from the file's root, else anywhere.
static NodeId find_partner(const Scene& scene, const Value* b, NodeId top, const std::string& call) {
  if (!b || b->is_nil()) return {};
  if (const Reference* reference = b->get<Reference>()) return {reference->index, reference->generation};
  const std::string* name = b->get<std::string>();
  if (!name) fail(call, ".b: string expected, got ", text(*b));
  if (name->empty()) return {};
  if (const NodeId node = scene.find_id(*name)) return node;
  if (label(scene[top]) == *name) return top;
  return scene.get_by_path(*name, scene.find(*name, top) ? top : scene.root(), call + ".b");
}

void Engine::add_joints(const NodeDef& def, NodeId node, NodeId top, Origin origin, const std::string& call) {
  for (std::size_t i = 0; i < def.joints.size(); ++i) {
    const std::string where = call + ": joints[" + std::to_string(i + 1) + "]";
    const Map* entry = def.joints[i].get<Map>();
    if (!entry) fail(where, ": table expected, got ", text(def.joints[i]));
    const auto word = [&](const char* key) {
      const Value* value = def.joints[i].find(key);
      if (value && !value->is<std::string>()) fail(where, ".", key, ": string expected, got ", text(*value));
      return value ? *value->get<std::string>() : "";
    };
    Map options;
    for (const auto& [key, value] : *entry)
      if (key != "type" && key != "name" && key != "b") options.emplace_back(key, value);
    if (word("type").empty()) fail(where, ": type is missing; the kinds are ", join(joint_kind_names()));
    const NodeId partner = find_partner(scene, def.joints[i].find("b"), top, where);
    add_joint(word("type"), word("name"), node, partner, options, origin, where);
  }
  for (std::size_t i = 0; i < def.children.size(); ++i) {
    const NodeId child = scene[node].children[i];
    add_joints(def.children[i], child, top, origin, call + ": '" + scene.path(child) + "'");
  }
}

Value Engine::joint_entry(JointRef joint) const {
  const JointRecord& record = joints_[joint];
  Value entry(Map{{"type", record.type}});
  if (!record.name.empty()) entry["name"] = record.name;
  if (record.b) entry["b"] = scene[record.b].id;
  const Value options = write_joint(record.def, frame_of(scene, record.a));
  for (const auto& [name, value] : *options.get<Map>()) entry[name] = value;
  return entry;
}

// ---- in the world

void Engine::activate(JointRef joint) {
  JointRecord& record = joints_[joint];
  const BodyComponent* a = body(record.a);
  const BodyComponent* b = body(record.b);
  const bool complete = (!record.a || (a && a->id)) && (!record.b || (b && b->id));
  if (record.id || !world_ || !complete) return;
  record.def.a = a ? a->id : BodyId{};
  record.def.b = b ? b->id : BodyId{};
  record.id = world_->add(record.def, pack(joint));
}

void Engine::deactivate(JointRef joint) {
  JointRecord& record = joints_[joint];
  if (record.id) world_->remove(record.id);
  record.id = {};
}

void Engine::set_joint_field(JointRef joint, const std::string& path, const Value& value, const std::string& call) {
  JointRecord& record = joints_[joint];
  JointDef def = record.def;
  const auto [head, rest] = split_path(path);
  if (path == "name") {
    if (!value.is<std::string>()) fail(call, ": name: string expected, got ", text(value));
    record.name = *value.get<std::string>();
    return;
  }
  if (type_of<JointDef>().field(head)) {
    const Vec3 scale = frame_of(scene, record.a).scale;
    def.anchor = unscaled(def.anchor, scale);
    assign_path(type_of<JointDef>(), &def, path, value, call);
    def.anchor = scaled(def.anchor, scale);
  } else {
    assign_path(joint_kind_type(def.kind), joint_kind_object(def.kind), path, value, call);
  }
  check_axes(def, "joint." + record.type);
  record.def = def;
  note_option(record.options, path, value);
  if (record.id) world_->configure(record.id, def);
}

void Engine::destroy_joint(JointRef joint) {
  const JointRecord* record = joints_.get(joint);
  if (!record) return;
  deactivate(joint);
  for (const NodeId node : {record->a, record->b})
    if (node) std::erase(private_->extra(node).joints, joint);
  if (private_->first_joints.contains(joint)) joints_.vacate(joint);
  else joints_.remove(joint);
}

void Engine::remove_joints(NodeId node) {
  for (const JointRef joint : joints_of(node)) destroy_joint(joint);
}

// ---- finding

std::vector<JointRef> Engine::joints_of(NodeId node) const {
  const auto* extra = scene.get(node) ? private_->find(node) : nullptr;
  return extra ? extra->joints : std::vector<JointRef>{};
}

JointRef Engine::find_joint(NodeId node, const std::string& name) const {
  for (const JointRef joint : joints_of(node))
    if (joints_[joint].name == name) return joint;
  return {};
}

JointRef Engine::joint_of(JointId joint) const {
  return world_ && world_->has(joint) ? unpack<JointRecord>(world_->user(joint)) : JointRef{};
}

void Engine::each_joint(const std::function<void(JointRef, const JointRecord&)>& f) const { joints_.each(f); }

}  // namespace tumble
