#include "engine/engine.h"

#include <utility>

#include "base/hash.h"
#include "engine/engine_private.h"

namespace tumble {

Engine::Engine(const GameSettings& game, bool with_world)
    : settings(game), with_world_(with_world), private_(std::make_unique<Private>()) {
  scene_root = scene.root();
  input.set_actions(settings.actions);
}

Engine::~Engine() = default;

void Engine::warn(const std::string& text) const {
  if (log) log({LogLevel::warning, text});
}

// ---- nodes

NodeId Engine::add(const NodeDef& def, NodeId parent, Origin origin, const std::string& call, NodeId handle) {
  if (!parent) parent = scene.root();
  if (!alive(parent)) fail(call, ": the parent was destroyed; choose a node that is alive");

  NodeId top;
  const std::uint64_t first_joint = private_->next_joint_serial;
  const std::size_t siblings = scene[parent].children.size();
  try {
    worded(call, [&] {
      top = add_nodes(def, parent, origin, handle);
      add_bodies(def, top, call);  // after all transforms, since a body owns its world pose from then on
      add_joints(def, top, top, origin, call);
    });
  } catch (const Error&) {
    std::erase_if(private_->first_joints, [&](const auto& first) { return first.second.serial >= first_joint; });
    if (scene[parent].children.size() > siblings)
      discard(scene[parent].children.back(), [handle](NodeId node) { return node == handle; });
    throw;
  }
  if (origin != Origin::added) remember(def, top);
  return top;
}

NodeId Engine::add_nodes(const NodeDef& def, NodeId parent, Origin origin, NodeId handle) {
  const NodeId id = scene.add(def.name, parent, def.id, handle);
  scene.jump(id, {def.position, def.rotation, def.scale});
  SceneNode& node = scene[id];
  node.tags = def.tags;
  node.visible = def.visible;
  node.enabled = def.enabled;
  node.origin = origin;
  if (def.mesh) node.mesh = settled(*def.mesh);
  node.material = def.material;
  if (def.color) (node.material ? *node.material : node.material.emplace()).color = *def.color;
  node.light = def.light;
  node.camera = def.camera;
  node.sky = def.sky;
  if (def.sound) set_sound(id, def.sound, "sound");
  node.particles = def.particles;
  if (node.particles) particles.note(id);
  node.animation = def.animation;
  ask_for_files(id);
  list_animation(id);
  for (const NodeDef& child : def.children) add_nodes(child, id, origin, {});
  return id;
}

void Engine::add_bodies(const NodeDef& def, NodeId node, const std::string& call) {
  if (def.body) make_body(node, *def.body, call);
  for (std::size_t i = 0; i < def.children.size(); ++i) {
    const NodeId child = scene[node].children[i];
    add_bodies(def.children[i], child, call + ": '" + scene.path(child) + "'");
  }
}

NodeDef Engine::def(NodeId id) const {
  const SceneNode& node = scene[id];
  NodeDef def;
  def.name = node.name;
  def.id = node.id;
  def.tags = node.tags;
  def.position = node.local.position;
  def.rotation = node.local.rotation;
  def.scale = node.local.scale;
  def.visible = node.visible;
  def.enabled = node.enabled;
  def.mesh = node.mesh;
  def.material = node.material;
  def.light = node.light;
  def.camera = node.camera;
  def.sky = node.sky;
  def.sound = node.sound;
  def.particles = node.particles;
  def.animation = node.animation;
  if (body(id)) def.body = body_def(id);
  for (const JointRef joint : joints_of(id))
    if (joints_[joint].a == id) def.joints.push_back(joint_entry(joint));
  return def;
}

void Engine::set_sound(NodeId node, const std::optional<Sound>& sound, const std::string& call) {
  if (sound) {
    worded(call, [&] { sounds.check(*sound); });
    sounds.watch(node);
  }
  scene[node].sound = sound;
}

bool Engine::alive(NodeId node) const {
  const SceneNode* content = scene.get(node);
  return content && !content->dying;
}

void Engine::destroy(NodeId node) {
  if (!alive(node)) return;
  if (node == scene.root()) fail("node:destroy: the root of all nodes cannot be destroyed; destroy its children");
  scene.each(node, [](NodeId, SceneNode& below) { below.dying = true; });
  dying_.push_back(node);
}

void Engine::remove_bodies_of_dying() {
  for (const NodeId top : dying_) {
    if (!scene.get(top)) continue;
    scene.each(top, [this](NodeId node, SceneNode&) {
      remove_joints(node);
      remove_body(node);
    });
  }
}

std::vector<NodeId> Engine::finish_removals() {
  // A node may stand here below another that goes too, whose removal took it along.
  for (const NodeId top : std::exchange(dying_, {}))
    if (scene.get(top)) remove_now(top);
  if (!scene.get(scene_root)) scene_root = scene.root();
  return std::exchange(gone_, {});
}

// With all below it; handles that a restart brings back stay reserved.
void Engine::remove_now(NodeId top) {
  scene.each(top, [this](NodeId node, SceneNode&) { gone_.push_back(node); });
  discard(top, [this](NodeId node) { return private_->first_nodes.contains(node); });
}

void Engine::discard(NodeId top, const std::function<bool(NodeId)>& keep) {
  scene.each(top, [this](NodeId node, SceneNode&) {
    remove_joints(node);
    remove_body(node);
  });
  scene.remove(top, keep);
}

// ---- one tick

void Engine::begin_tick() {
  ++tick;
  scene.begin_tick(tick);
  if (!private_->camera_checked) camera();
  private_->camera_checked = true;
}

void Engine::step_particles(double seconds) { particles.step(scene, settings.physics.gravity, seconds, log); }

void Engine::burst_particles(NodeId emitter, int count) {
  particles.burst(scene, emitter, count, settings.physics.gravity, log);
}

Events Engine::take_events() {
  if (!world_) return {};
  Events events = world_->take_events();
  for (const JointEvent& event : events.breaks)
    if (JointRecord* record = joint(joint_of(event.joint))) record->broken = true;
  for (const BodyId lost : events.lost)
    if (const NodeId node = node_of(lost))
      warn("node '" + scene.path(node) + "': its body left all finite numbers and is switched off at its last sound pose; look for " +
           "huge forces or speeds, or for a joint that pulls with no limit");
  return events;
}

std::uint64_t Engine::hash() const {
  Hash hash;
  hash.add(tick);
  for (const std::uint64_t word : random.state()) hash.add(word);
  scene.each(scene.root(), [&](NodeId, const SceneNode& node) {
    hash.add(node.name).add(node.id).add(node.local.position).add(node.local.rotation).add(node.local.scale);
    hash.add(std::uint64_t{node.enabled});
    if (node.animation) hash.add(node.animation->clip).add(node.animation->time).add(std::uint64_t{node.animation->playing});
  });
  joints_.each([&](JointRef, const JointRecord& joint) { hash.add(joint.serial).add(std::uint64_t{joint.broken}); });
  hash.add(world_ ? world_->hash() : 0);
  return hash.value();
}

}  // namespace tumble
