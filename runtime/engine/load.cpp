// scene.load: one loaded scene takes the place of another; what main.lua declared stays.

#include "engine/engine_private.h"

namespace tumble {

NodeId Engine::load(const NodeDef& def, const std::string& name) {
  check_load(def);
  clear_loaded();
  particles.clear();
  scene_root = add(def, scene.root(), Origin::loaded, "scene.load");
  scene_name = name;
  private_->loaded_root = scene_root;
  private_->camera_checked = false;
  drop_spare_camera();
  reframe_own_camera();
  return scene_root;
}

// Tries it in an engine without a world, beside the nodes that stay, so that a scene with a mistake changes nothing.
void Engine::check_load(const NodeDef& def) const {
  Engine trial(settings, false);
  scene.each(scene.root(), [&](NodeId, const SceneNode& node) {
    if (node.parent && node.origin == Origin::declared) trial.scene.add(node.name, {}, node.given_id ? node.id : "");
  });
  trial.add(def, trial.scene.root(), Origin::added, "scene.load");
}

void Engine::clear_loaded() {
  std::vector<NodeId> staying, going;
  scene.each(scene.root(), [&](NodeId node, SceneNode& content) {
    if (node == scene.root()) return;
    if (content.origin != Origin::declared) going.push_back(node);
    else if (content.parent != scene.root() && scene[content.parent].origin != Origin::declared) staying.push_back(node);
  });
  for (const NodeId node : staying) set_parent(node, scene.root());
  for (const NodeId node : going)
    if (scene.get(node)) remove_now(node);
  forget_loaded();
  scene_root = scene.root();
  private_->loaded_root = {};
}

void Engine::forget_loaded() {
  std::vector<NodeId> nodes;
  for (const auto& [node, first] : private_->first_nodes)
    if (first.origin == Origin::loaded) nodes.push_back(node);
  for (const NodeId node : nodes) forget_first_state(node);

  std::vector<JointRef> joints;
  for (const auto& [joint, first] : private_->first_joints)
    if (first.origin == Origin::loaded) joints.push_back(joint);
  for (const JointRef joint : joints) forget_first_state(joint);
}

}  // namespace tumble
