// What declared and loaded nodes and joints were at first, and scene.restart, which gives it back.

#include <algorithm>

#include "engine/engine_private.h"
#include "engine/fields.h"
#include "engine/joint_options.h"

namespace tumble {

std::vector<NodeId> Engine::Private::first_nodes_by_age() const {
  std::vector<NodeId> nodes;
  for (const auto& [node, first] : first_nodes) nodes.push_back(node);
  std::sort(nodes.begin(), nodes.end(),
            [this](NodeId a, NodeId b) { return first_nodes.at(a).serial < first_nodes.at(b).serial; });
  return nodes;
}

void Engine::remember(const NodeDef& def, NodeId node) {
  FirstNode first;
  first.def = this->def(node);
  first.def.joints.clear();  // remembered for themselves
  first.def.behaviours = def.behaviours;
  first.def.prefab = def.prefab;
  first.parent = scene[node].parent;
  first.given_id = scene[node].given_id;
  first.serial = scene[node].serial;
  first.origin = scene[node].origin;
  private_->first_nodes[node] = std::move(first);
  for (std::size_t i = 0; i < def.children.size(); ++i) remember(def.children[i], scene[node].children[i]);
}

const NodeDef* Engine::first_state(NodeId node) const {
  const auto found = private_->first_nodes.find(node);
  return found == private_->first_nodes.end() ? nullptr : &found->second.def;
}

void Engine::update_first_state(NodeId node, const std::string& path, const Value& value) {
  const auto found = private_->first_nodes.find(node);
  if (found == private_->first_nodes.end()) return;
  if (path != "parent") return assign_path(found->second.def, path, value, "reload");
  const Reference* parent = value.get<Reference>();
  found->second.parent = parent ? NodeId{parent->index, parent->generation} : scene.root();
}

void Engine::update_first_state(JointRef joint, const Value& options) {
  const auto found = private_->first_joints.find(joint);
  if (found != private_->first_joints.end()) found->second.options = options;
}

void Engine::forget_first_state(NodeId node) {
  if (private_->first_nodes.erase(node) == 0) return;
  if (SceneNode* living = scene.get(node)) living->origin = Origin::added;
  else scene.release(node);
}

void Engine::forget_first_state(JointRef joint) {
  if (private_->first_joints.erase(joint) == 0) return;
  if (JointRecord* living = joints_.get(joint)) living->origin = Origin::added;
  else joints_.remove(joint);
}

// ---- restart

void Engine::restart_scene() {
  drop_world();
  private_->animations.clear();
  private_->animation_ends.clear();
  particles.clear();
  dying_.clear();
  revive_nodes();
  remove_added();
  reset_nodes();
  reset_joints();
  if (private_->loaded_root) scene_root = private_->loaded_root;
  sounds.scene_restarted();
  reframe_own_camera();
  scene.take_touched();  // the bodies were just made where their nodes are
}

// Bodies and joints begin anew with nothing that the old ones left in a solver: no warm start, no sleep, no age.
void Engine::drop_world() {
  world_.reset();
  joints_.each([](JointRef, JointRecord& joint) { joint.id = {}; });
  scene.each(scene.root(), [this](NodeId node, SceneNode&) {
    if (BodyComponent* component = body(node)) component->id = {};
    remove_body(node);
  });
}

void Engine::revive_nodes() {
  for (const NodeId node : private_->first_nodes_by_age()) {
    const FirstNode& first = private_->first_nodes[node];
    const NodeId parent = scene.get(first.parent) ? first.parent : scene.root();
    const NodeId namesake = scene.find_id(first.def.id);
    if (namesake && namesake != node) scene.set_id(namesake, "");
    if (!scene.get(node)) scene.add(first.def.name, parent, first.def.id, node, first.serial);
    else if (scene[node].parent != parent) scene.set_parent(node, parent, false);
  }
}

void Engine::remove_added() {
  std::vector<NodeId> added;
  scene.each(scene.root(), [&](NodeId node, SceneNode&) {
    if (node != scene.root() && node != private_->own_camera && !private_->first_nodes.contains(node)) added.push_back(node);
  });
  for (const NodeId node : added)
    if (scene.get(node)) remove_now(node);
}

void Engine::reset_nodes() {
  const std::vector<NodeId> nodes = private_->first_nodes_by_age();
  for (const NodeId id : nodes) {
    const FirstNode& first = private_->first_nodes[id];
    scene.rename(id, first.def.name);
    scene.set_id(id, first.def.id);
    scene.jump(id, {first.def.position, first.def.rotation, first.def.scale});
    SceneNode& node = scene[id];
    node.given_id = first.given_id;
    node.origin = first.origin;
    node.dying = false;
    node.tags = first.def.tags;
    node.visible = first.def.visible;
    node.enabled = first.def.enabled;
    node.mesh.reset();
    if (first.def.mesh) node.mesh = settled(*first.def.mesh);
    node.material = first.def.material;
    if (first.def.color) (node.material ? *node.material : node.material.emplace()).color = *first.def.color;
    node.light = first.def.light;
    node.camera = first.def.camera;
    node.sky = first.def.sky;
    node.sound = first.def.sound;
    if (node.sound) sounds.watch(id);
    node.particles = first.def.particles;
    if (node.particles) particles.note(id);
    node.animation = first.def.animation;
    list_animation(id);
  }
  for (const NodeId node : nodes) scene.sort_children(scene[node].parent);
  for (const NodeId node : nodes)
    if (const auto& body = private_->first_nodes[node].def.body) make_body(node, *body, "scene.restart");
}

void Engine::reset_joints() {
  std::vector<JointRef> living;
  joints_.each([&](JointRef joint, JointRecord&) { living.push_back(joint); });
  for (const JointRef joint : living) destroy_joint(joint);

  std::map<std::uint64_t, JointRef> by_age;
  for (const auto& [joint, first] : private_->first_joints) by_age[first.serial] = joint;
  for (const auto& [serial, joint] : by_age) {
    JointRecord record = private_->first_joints[joint];
    if ((record.a && !scene.get(record.a)) || (record.b && !scene.get(record.b))) continue;
    record.def = read_joint(record.type, record.options, record.a ? scene.world(record.a) : Transform{}, "joint." + record.type);
    place_joint(joint, std::move(record));
  }
}

}  // namespace tumble
