// A game's scripts in one Lua state: what the rest of the runtime calls, and what the bindings ask.
//
// The state belongs to one Engine, the live one. While files declare (at load and at reload) calls go to a staging
// engine instead, so that nothing of a faulty text reaches the game; commit() then applies what differs.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/log.h"
#include "engine/engine.h"
#include "engine/extract.h"
#include "engine/storage.h"
#include "engine/ui/options.h"
#include "script/memory.h"
#include "script/param.h"

struct lua_State;  // only this folder knows more of it

namespace tumble {

enum class Phase {
  idle,     // no script runs
  declare,  // top levels of files, into the staging engine
  run,      // handlers and tasks
  frame,    // frame(dt): draws only
  watch,    // bot.lua: reads everything, changes only input
};

struct ScriptFailure {
  std::string text;       // the message with its place: "main.lua:7: ..."
  std::string traceback;
  std::string file;       // where known
  int line = 0;
  std::string source;     // that line's text
  bool in_text = false;   // the text itself is faulty: the code from before runs on
};

constexpr double kLongestRumble = 10;  // s
struct Rumble {
  int pad = 0;               // 1 and up; 0 is all of them
  double strength = 0;       // 0..1
  double seconds = 0;
};

// What a script asks of the program around it.
struct GameRequests {
  bool finish = false, quit = false, restart = false;
  std::vector<Rumble> rumbles;   // of this tick
  std::string open;              // another game in this one's folder
};

enum class DebugView { none, colliders, joints, boxes, contacts, rays, velocities, names, physics };
const EnumNames& enum_names(DebugView);

// Settings that a file's top level may write, beside the scene: compared between two runs of the text.
struct ModuleSettings {
  WorldSettings physics;
  double time_scale = 1;
  bool paused = false;
  bool pointer_captured = false;
  DebugView debug_view = DebugView::none;
  UiStyle ui;
  double sound_volume = 1;
  std::map<std::string, double> sound_groups;   // every group with its volume
};
void describe(ModuleSettings& settings, Schema& s);

// What a script asked of the world, for the debug view.
struct DebugQuery {
  Vec3 from, to;                    // of a ray or cast; of an overlap both are its place
  double stop = 0;                  // how far it came, m
  std::optional<Shape> shape;       // of a cast or overlap
  std::vector<std::pair<Vec3, Vec3>> hits;  // points and normals
};

// What Lua drew in this tick or frame.
struct Drawing {
  std::vector<DrawLine> lines;      // world space in `from`, `to`: made relative when the picture is made
  std::vector<std::pair<Vec3, Vec3>> ends;  // of each line, world, m
  std::vector<DrawUi> ui;
  std::vector<DebugQuery> queries;  // only while the debug view shows them
  std::vector<std::pair<std::string, std::string>> watches;  // log.watch: name, value
};

struct ScriptHost {
  std::function<std::optional<std::string>(const std::string& path)> read;        // a file of the game
  std::function<std::vector<std::string>(const std::string& prefix)> list;        // its files
  std::function<void(const std::string& path, const std::string& text)> write;    // into the game's folder; may be empty
  std::function<void(const ScriptFailure&)> on_error;
  LogSink log;
  std::string entry = "main.lua";
  std::size_t memory_limit = std::size_t{512} << 20;
  double time_limit = 1.0;  // CPU seconds that one call into scripts may take
  bool bot = false;         // run bot.lua
};

// A function of the host program: host.name in Lua.
struct HostFunction {
  std::string name, doc;
  std::vector<Param> params;
  std::string returns;
  std::function<Value(const std::vector<Value>&)> call;
};

struct DeclaredNode {
  std::string key;        // file, name or hash, and which of that name
  NodeId handle, parent;
  Value def;              // without children and behaviours
  Value behaviours;
};
struct DeclaredJoint {
  std::string key;
  JointRef handle;
  std::string type, name;
  NodeId a, b;
  Value options;
};
// What commit() did that concerns behaviours; nodes are in tree order.
struct CommitResult {
  struct Change { NodeId node; Value before, behaviours; };
  std::vector<Change> added, changed;
  std::vector<std::string> log;
};

// What one run of all top levels declared.
struct Declarations {
  std::vector<DeclaredNode> nodes;
  std::vector<DeclaredJoint> joints;
  Value settings;
  std::map<std::string, NodeId> node_keys;    // key -> handle, the dead ones too
  std::map<std::string, JointRef> joint_keys;
};

class Ui;
struct HitData;
struct ContactEvent;
enum class Tag : std::uint32_t;  // of objects.h

class Script {
 public:
  Script(Engine& engine, ScriptHost host);
  ~Script();
  Script(const Script&) = delete;

  void add_host_function(HostFunction function);  // before load()

  // Tests of a game: the claims in a file of tests; running one; its outcome, once it has ended.
  std::vector<std::string> list_tests(const std::string& path);
  void start_test(int number);
  std::optional<std::pair<bool, std::string>> test_outcome;
  // Runs main.lua and all it needs, loads the start scene, runs start(). False where the text is faulty: the error
  // was reported, and a later reload() may mend it.
  bool load();
  // Runs all files again after these changed. Returns the log line; "" where nothing of ours changed.
  std::string reload(const std::vector<std::string>& changed);
  bool loaded() const { return loaded_; }
  void begin_storage(Stored stored);                   // before load(); takes over the bindings that were stored

  // ---- one tick, in this order (app/frame.cpp). Each runs protected: a failing script is stopped and reported.
  void run_bot(std::vector<InputEvent>& events);       // may add events
  void take_ui_input(std::vector<InputEvent>& events);  // removes what a widget took
  void deliver_input(const std::vector<InputNotice>& notices);
  void run_tasks(double dt);
  void update(double dt);
  // `began`: when, on the clock of time.now, the time began that the events count from.
  void physics_events(const Events& events, double began);
  void animation_events(const std::vector<AnimationEnd>& ends);
  void late_update(double dt);
  void flush();                                        // destroys, scene loads, start() of what is new
  void draw_ui();
  void frame(double dt);
  void send(const std::string& message, const std::vector<Value>& arguments);
  void collect_garbage();                              // once a tick
  void read_report();                                  // fills `report`
  bool wants_text();                                   // does anything hear on_text?

  Ui& ui() { return *ui_; }
  Drawing& tick_drawing() { return tick_drawing_; }
  Drawing& frame_drawing() { return frame_drawing_; }
  GameRequests requests;
  Map report;                                          // game.report
  Storage storage;
  bool finished = false;
  int errors = 0;
  double seconds_now = 0;                              // time.now
  double dropped_seconds = 0;                          // time.dropped_seconds; the loop tells it
  int steps_wanted = 0;                                // time.step() while paused
  double aspect = 16.0 / 9.0;                          // of the ui: width / height
  std::optional<ScriptFailure> shown_error;            // until the next good save
  const ModuleSettings& module_settings() const { return live_settings_; }
  void set_debug_view(DebugView view) { live_settings_.debug_view = view; }
  std::uint64_t hash() const;
  std::size_t memory_used() const { return memory_.used(); }
  std::optional<Value> get_path(const std::string& node_path, const std::string& path);  // for hosts: "behaviours.ball.scored"
  void set_path(const std::string& node_path, const std::string& path, const Value& value);

  // ---- for the bindings
  Engine& engine() { return staging_ ? *staging_ : live_; }
  Engine& live_engine() { return live_; }
  ModuleSettings& settings() { return staging_ ? staging_settings_ : live_settings_; }
  Phase phase() const { return phase_; }
  Random& random();                                    // the stream of this phase
  Drawing& drawing() { return phase_ == Phase::frame ? frame_drawing_ : tick_drawing_; }
  const ScriptHost& host() const { return host_; }
  void log(LogLevel level, const std::string& text);
  void refuse_declaration() { refused_ = true; }       // sticky: a pcall cannot hide it
  void push_node(NodeId node);                         // always the same userdata for the same node; nil for none
  void push_joint(JointRef joint);
  void push_component(NodeId node, Tag tag);
  std::string object_text(int index);                  // "node 'ball'", for messages and tostring
  std::string dead_node_text(NodeId node) const;
  lua_State* lua() { return L_; }
  lua_State* stack() { return running_; }              // the coroutine that runs now, or the main state
  void set_running(lua_State* L);
  std::uint32_t next_serial() { return next_serial_++; }
  bool over_time() const;                              // the watchdog stopped what runs
  const struct Names*& names(int tag_index) { return names_[tag_index]; }  // dispatch.cpp: the rows of a kind of object
  std::uint64_t seed() const { return seed_; }
  void set_seed(std::uint64_t seed);
  Results push_behaviours(NodeId node);
  int send_message(int node_at, int message_at);       // of the stack; 0 is the whole scene
  void lists_changed() { lists_changed_ = true; }      // who is updated, and in which order, must be found again
  CameraView view_of(NodeId camera) const;
  HitData hit_of(const ContactEvent& event, BodyId self) const;
  World& world_or_empty();                             // for queries, which make no world
  bool shows_queries() const;                          // does the debug view want them noted in drawing()?
  bool joint_has_option(const std::string& type, const std::string& name) const;
  // Is it a freedom with a table of its own, such as `twist` of a ragdoll?
  bool is_freedom(const JointRecord& joint, const std::string& name) const;
  // Where that freedom is, by `position`, `angle`, `angle_degrees` or `speed`; none for other keys.
  std::optional<double> freedom_state(JointRef joint, const std::string& freedom, const std::string& key);
  // Handler slots of nodes ("on_collision_enter"): push the function, or keep the one at `value`. False where the name
  // is no event's; a name near to one is an Error.
  bool push_slot(int node, const std::string& name);
  bool set_slot(int node, const std::string& name, int value);

  NodeId declare_node(const Value& table, const std::string& call);   // scene.add at a top level
  NodeId add_node(const Value& table, NodeId parent, Origin origin, const std::string& call);
  JointRef add_joint(const std::string& type, const Value& table, const std::string& call);
  void destroy_node(NodeId node);
  void request_scene(const std::string& path);         // scene.load at the end of the tick
  void save_scene(const std::string& path);
  void request_scene_restart() { scene_restart_wanted_ = true; }

 private:
  friend struct CoreApi;                               // the functions that boot.lua gets
  void open_state();
  void run_boot();
  // Calls boot's function of that name with `arguments` values on the stack. Errors are reported. True if it went well.
  bool call_boot(const char* function, int arguments, int results, Phase phase);
  // The same without protection, for calls that a script made: errors pass through.
  void call_boot_inside(const char* function, NodeId node, int results);
  void push_boot(lua_State* L, const char* function);
  bool protected_call_on(lua_State* L, int arguments, int results);
  void report_failure(const std::string& message, const std::string& traceback);
  void event(NodeId node, const char* name, const std::function<void()>& push_argument);
  void forget_node(NodeId node);
  Random& line_random();
  std::string source_line(const std::string& file, int line) const;
  std::map<std::string, Value> behaviours_of(NodeId node);
  NodeDef whole_def(NodeId node);
  // script_scene.cpp
  std::string node_key(const std::string& name, const Value& def, const char* kind);
  void attach_behaviours(NodeId node, const Value& behaviours, const std::string& call);
  void open_scene_quietly(const std::string& path);
  void announce_scene(const std::string& name);
  void attach_tree(const NodeDef& def, NodeId node, const std::string& call);
  std::string reload_scene();
  void declare_behaviours(const NodeDef& before, const NodeDef& now, NodeId node, std::string& text);
  bool apply_scene_changes(const NodeDef& before, const NodeDef& now, NodeId node, std::string& text);
  void guarded(const std::function<void()>& work);
  std::string push_path(const std::string& path, int keep);
  std::string reload_first();
  void reset_watchdog(lua_State* L);
  void mark_scripted(NodeId node);
  std::vector<NodeId> scripted_nodes();
  void begin_staging();
  void drop_staging();
  CommitResult commit(bool partial);                   // partial: what is not declared again stays
  void capture_declarations();
  void commit_nodes(bool partial, CommitResult& result);
  void commit_joints(bool partial, CommitResult& result);
  void commit_settings(CommitResult& result);
  void open_scene(const std::string& path);
  void restart_scene_now();
  void remove_dying();
  void refresh_stays();

  Engine& live_;
  ScriptHost host_;
  std::array<const struct Names*, 24> names_{};        // by tag; they live in the Lua state
  LuaMemory memory_;
  lua_State* L_ = nullptr;
  lua_State* running_ = nullptr;
  std::uint64_t seed_ = 1;
  std::uint32_t next_serial_ = 1;
  ModuleSettings first_settings_;                      // from game.json: what the text's settings start from
  bool lists_changed_ = true, stays_changed_ = true;
  std::unique_ptr<Engine> staging_;
  std::unique_ptr<World> empty_world_;
  ModuleSettings live_settings_, staging_settings_;
  Declarations declared_, staged_;
  std::string declaring_file_;
  std::map<std::string, int> key_counts_;              // in this run: how many of each name so far
  Random frame_random_{2}, declare_random_{3};
  Phase phase_ = Phase::idle;
  bool refused_ = false;
  bool loaded_ = false;
  std::string scene_wanted_;
  bool scene_restart_wanted_ = false;
  bool scene_went_ = false;                            // since the last full collection
  std::size_t after_full_collection_ = 0;              // bytes
  Drawing tick_drawing_, frame_drawing_;
  std::map<NodeId, std::string> dead_;                 // how destroyed nodes were called and where they ended
  std::vector<NodeId> dead_order_;
  std::vector<HostFunction> host_functions_;
  std::vector<InputEvent>* bot_events_ = nullptr;
  std::int64_t bot_ticks_ = 0;
  bool testing_ = false;
  Phase outer_phase_ = Phase::idle;
  bool booted_ = false, report_warned_ = false;
  double bot_x_ = 640, bot_y_ = 360;
  std::vector<bool> scripted_;                         // by node index: has behaviours or slots
  std::vector<std::pair<NodeId, Value>> loaded_behaviours_;
  NodeDef loaded_def_;                                 // the scene file as it was read last
  std::unique_ptr<class Watchdog> watchdog_;
  std::unique_ptr<Ui> ui_;
};

// A collision, trigger or query hit, kept by value.
struct HitData {
  NodeId node, own;           // the other's, mine
  int collider = 0, own_collider = 0;
  Vec3 point, normal, velocity, origin, end;
  double speed = 0, impulse = 0, distance = 0;
  double time = 0;            // of a trigger or query, on the clock of time.now
  std::vector<ContactPoint> points;
  enum class Kind { collision, trigger, query } kind = Kind::collision;
};
void push_hit(lua_State* L, const HitData& hit);
HitData* hit_at(lua_State* L, int index);

}  // namespace tumble
