// One running game without its scripts: scene, world, settings, and the step that joins them.
//
// The engine owns the scene and, from the first body on, the world. It knows no Lua: scripts, hosts and scene files all
// come through the same functions. Nothing is removed in the middle of a tick; destroy() marks, and the end of the tick
// removes. A staging engine (for reload) is the same class with `with_world` false: bodies are only descriptions there.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "assets/library.h"
#include "base/log.h"
#include "engine/input_map.h"
#include "engine/node_def.h"
#include "engine/particles.h"
#include "engine/random.h"
#include "engine/settings.h"
#include "engine/sounds.h"
#include "physics/world.h"
#include "scene/scene.h"

namespace tumble {

// A node's body. `id` names nothing in a staging engine. A body of a disabled node stays, switched off.
struct BodyComponent {
  BodyDef def;      // as the author wrote it; the world's def() has the velocities of now
  BodyId id;
  Vec3 scale{1, 1, 1};  // world scale that the colliders were made for
  Pose placed;          // where its node was when the world was told last; not kept up for dynamic ones
  bool wants_stay = false;            // write through Engine::want_stay
  std::uint64_t written_tick = 0;     // of a static body: when it was moved last,
  int writes_in_a_row = 0;            // in how many ticks without a gap,
  bool hinted = false;                // and was the author told
};

// A joint as scripts see it: it is there from creation to destroy(), its JointId only while both bodies exist.
struct JointRecord {
  std::string type, name;
  NodeId a, b;              // b may be none: the world
  Value options;            // as the author wrote them, without a, b, name
  JointDef def;             // as it is now; bodies filled in when both exist
  JointId id;
  bool broken = false;
  Origin origin = Origin::added;
  std::uint64_t serial = 0;
};
using JointRef = Handle<JointRecord>;

// A clip that does not loop came to its end.
struct AnimationEnd {
  NodeId node;
  std::string clip;
};

class Engine {
 public:
  explicit Engine(const GameSettings& settings, bool with_world = true);
  ~Engine();

  Scene scene;
  GameSettings settings;
  InputMap input;
  Random random;
  ParticleField particles;          // drawn only
  std::uint64_t tick = 0;           // the number of this tick, or of the last one between two; the first is 1
  LogSink log;                      // hints for the author; may be empty
  AssetLibrary* assets = nullptr;   // models, pictures and sounds; outlives the engine; null: none
  Sounds sounds{*this};

  // ---- nodes
  // With children, components and joints from the def; behaviours are the caller's. `handle`: reserved, for the top node.
  // Throws Error beginning with `call`; then nothing was added.
  NodeId add(const NodeDef& def, NodeId parent, Origin origin, const std::string& call, NodeId handle = {});
  // Everything that is known of a node (without children), as it is now.
  NodeDef def(NodeId node) const;
  // One top-level field of NodeDef ("position", "body", "mesh" ...), or a field of a component by path ("body.mass").
  // A nil value removes a component or sets a field back to its default.
  void set_field(NodeId node, const std::string& path, const Value& value, const std::string& call);
  // Marks node and descendants: is_alive is false from now on. They go at the end of the tick.
  void destroy(NodeId node);
  bool alive(NodeId node) const;
  void set_mesh(NodeId node, const std::optional<Shape>& mesh, const std::string& call);  // refits its body
  void set_sound(NodeId node, const std::optional<Sound>& sound, const std::string& call);

  // ---- transforms as scripts write them: right for each kind of body (see mission: "Defaults and meanings")
  void set_position(NodeId node, Vec3 position);
  void set_rotation(NodeId node, Quat rotation);
  void set_scale(NodeId node, Vec3 scale);
  void set_world_position(NodeId node, Vec3 position);
  void set_world_rotation(NodeId node, Quat rotation);
  void teleport(NodeId node, Vec3 position, std::optional<Quat> rotation);   // local, like position
  void set_enabled(NodeId node, bool enabled);
  void set_parent(NodeId node, NodeId parent);          // it stays where it is in the world

  // ---- bodies
  BodyComponent* body(NodeId node);                     // nullptr where it has none
  const BodyComponent* body(NodeId node) const;
  void set_body(NodeId node, const std::optional<BodyDef>& def, const std::string& call);
  BodyDef body_def(NodeId node) const;                  // with the velocities of now
  void configure_body(NodeId node, const BodyDef& def, const std::string& call);
  void want_stay(NodeId node, bool on);                 // tell of contacts that go on; no effect without a body
  NodeId node_of(BodyId body) const;
  // The nodes of a contact, also where its bodies have just gone.
  std::pair<NodeId, NodeId> nodes_of(const ContactEvent& contact) const;
  World* world() { return world_.get(); }               // nullptr before the first body
  const World* world() const { return world_.get(); }
  void configure_physics(const WorldSettings& physics); // live

  // ---- joints
  JointRef add_joint(const std::string& type, const std::string& name, NodeId a, NodeId b, const Value& options,
                     Origin origin, const std::string& call, JointRef handle = {});
  JointRef reserve_joint() { return joints_.reserve(); }
  JointRecord* joint(JointRef joint) { return joints_.get(joint); }
  void set_joint_field(JointRef joint, const std::string& path, const Value& value, const std::string& call);
  void destroy_joint(JointRef joint);                   // at once
  JointRef find_joint(NodeId node, const std::string& name) const;  // from either end
  std::vector<JointRef> joints_of(NodeId node) const;   // by age
  JointRef joint_of(JointId joint) const;
  // As a scene file writes it, in its a's list; 0 of its freedoms will be the pose at that time.
  Value joint_entry(JointRef joint) const;
  void each_joint(const std::function<void(JointRef, const JointRecord&)>& f) const;

  // ---- files and animations
  // With the points of its file, as physics takes it; a box where the file is missing or broken.
  Shape with_points(const Shape& shape) const;
  // Asks for them again and fits colliders anew. Call it when the library has forgotten them.
  void files_changed(const std::vector<std::string>& files);
  // Where a node's animation is to be drawn, s into its clip: alpha 0 is the last tick, 1 this one.
  double animation_time(NodeId node, double alpha) const;
  std::vector<AnimationEnd> take_animation_ends();

  // ---- scenes
  // Replaces what was loaded before, at once (call it between ticks). Returns the root node of the loaded scene. What
  // goes is told by finish_removals(). Throws before anything is changed.
  NodeId load(const NodeDef& scene, const std::string& name);
  std::string scene_name;
  NodeId scene_root;                                    // the loaded scene's root node; scene.root() before a load
  // Puts all declared and loaded nodes and joints back to their first state in place (destroyed ones come back under
  // their old handles) and removes added ones. The world is made anew, so that a restart runs as a start does.
  void restart_scene();
  // The def of a declared or loaded node as restart_scene gives it back; nullptr for an added one.
  const NodeDef* first_state(NodeId node) const;
  // When a reload changes a declaration: a path as for set_field, or "parent" with a node.
  void update_first_state(NodeId node, const std::string& path, const Value& value);
  void update_first_state(JointRef joint, const Value& options);
  // When a declaration is gone for good: a destroyed node's handle is released, a living node counts as added.
  void forget_first_state(NodeId node);
  void forget_first_state(JointRef joint);

  // The active camera's node. Where there is none, camera() makes one that frames everything; find_camera() does not.
  NodeId camera();
  NodeId find_camera() const;

  // ---- one tick; the caller runs scripts between these
  void begin_tick();
  void step(double seconds);                            // scene -> physics, step, physics -> scene
  void step_particles(double seconds);                  // after all that moves nodes in the tick
  void burst_particles(NodeId emitter, int count);
  Events take_events();
  bool has_removals() const { return !dying_.empty() || !gone_.empty(); }
  void remove_bodies_of_dying();                        // their exits come with take_events()
  std::vector<NodeId> finish_removals();                // the handles that went, also by load and restart_scene
  std::uint64_t hash() const;

 private:
  struct Private;

  // engine.cpp
  NodeId add_nodes(const NodeDef& def, NodeId parent, Origin origin, NodeId handle);
  void add_bodies(const NodeDef& def, NodeId node, const std::string& call);
  void discard(NodeId top, const std::function<bool(NodeId)>& keep);
  void remove_now(NodeId top);
  void warn(const std::string& text) const;
  // bodies.cpp
  BodyDef physical(NodeId node, const BodyDef& def, const std::string& call) const;
  void make_body(NodeId node, const BodyDef& def, const std::string& call);
  void change_body(NodeId node, const BodyDef& def, const std::string& call);
  void remove_body(NodeId node);
  void refit_body(NodeId node);
  void refresh_enabled(NodeId node);
  void warn_of_nested_bodies(NodeId node) const;
  // files.cpp
  void ask_for_files(NodeId node);
  // animation.cpp
  void list_animation(NodeId node);
  void animate(double seconds);
  void advance_animation(NodeId node, double seconds);
  void move_animated(NodeId node, const Model& model, const ModelClip& clip, double time, bool jump);
  // sync.cpp
  void write_local(NodeId node, const Transform& local);
  void sync_body(NodeId node);
  void note_static_write(NodeId node, BodyComponent& body) const;
  // joints.cpp
  void add_joints(const NodeDef& def, NodeId node, NodeId top, Origin origin, const std::string& call);
  void place_joint(JointRef joint, JointRecord record);
  void activate(JointRef joint);
  void deactivate(JointRef joint);
  void remove_joints(NodeId node);
  // first_state.cpp
  void remember(const NodeDef& def, NodeId node);
  void drop_world();
  void revive_nodes();
  void remove_added();
  void reset_nodes();
  void reset_joints();
  // load.cpp
  void check_load(const NodeDef& scene) const;
  void clear_loaded();
  void forget_loaded();
  // camera.cpp
  void drop_spare_camera();
  void reframe_own_camera();

  Pool<JointRecord> joints_;
  std::vector<NodeId> dying_;
  std::vector<NodeId> gone_;
  std::unique_ptr<World> world_;
  bool with_world_;
  std::unique_ptr<Private> private_;
};

}  // namespace tumble
