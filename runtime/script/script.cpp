#include "script/script.h"

#include <algorithm>

#include "base/hash.h"
#include "base/text.h"
#include "script/areas.h"
#include "script/core.h"
#include "script/dispatch.h"
#include "script/sandbox.h"
#include "script/watchdog.h"

namespace tumble {

const EnumNames& enum_names(DebugView) {
  static const EnumNames names = {"none", "colliders", "joints", "boxes", "contacts", "physics"};
  return names;
}

void describe(ModuleSettings& settings, Schema& s) {
  s.name("settings", "What a file's top level may set beside nodes.");
  s.add("physics", settings.physics, "The world's settings.");
  s.add("time_scale", settings.time_scale, "time.scale.");
  s.add("paused", settings.paused, "time.paused.");
  s.add("debug_view", settings.debug_view, "physics.debug_view.");
}

Script::Script(Engine& engine, ScriptHost host) : live_(engine), host_(std::move(host)), memory_(host_.memory_limit) {
  live_settings_.physics = game_physics_ = engine.settings.physics;
  watchdog_ = std::make_unique<Watchdog>(host_.time_limit);
  open_state();
}

Script::~Script() {
  watchdog_->enter(L_);
  lua_close(L_);
  watchdog_->leave();
}

void Script::set_seed(std::uint64_t seed) {
  seed_ = seed;
  live_.random = Random(seed);
  frame_random_ = Random(seed ^ 0x5eedf00dULL);
}

void Script::open_state() {
  L_ = lua_newstate(&LuaMemory::allocate, &memory_);
  if (!L_) fail("Lua: no memory for a state");
  running_ = L_;
  *static_cast<Script**>(lua_getextraspace(L_)) = this;
  lua_gc(L_, LUA_GCGEN, 0, 0);
  luaL_openlibs(L_);
}

void Script::set_running(lua_State* L) {
  running_ = L;
  watchdog_->set_running(L);
}

bool Script::over_time() const { return watchdog_->tripped(); }

Random& Script::random() {
  if (phase_ == Phase::frame || phase_ == Phase::watch) return frame_random_;
  return phase_ == Phase::declare ? line_random() : live_.random;
}

// A stream for each line of the text that asks at a top level, so that a call inserted elsewhere changes no other
// line's numbers: seeded by the line's text and how often that text has asked before.
Random& Script::line_random() {
  lua_Debug record;
  std::string line;
  if (lua_getstack(running_, 1, &record) && lua_getinfo(running_, "Sl", &record) && record.source[0] == '@')
    line = source_line(record.source + 1, record.currentline);
  const int nth = key_counts_["random " + line]++;
  declare_random_ = Random(Hash().add(seed_).add(line).add(static_cast<std::uint64_t>(nth)).value());
  return declare_random_;
}

std::string Script::source_line(const std::string& file, int line) const {
  std::optional<std::string> text = host_.read(file);
  if (!text) return "";
  std::size_t begin = 0;
  for (int n = 1; n < line; ++n) {
    begin = text->find('\n', begin);
    if (begin == std::string::npos) return "";
    ++begin;
  }
  return text->substr(begin, text->find('\n', begin) - begin);
}

void Script::log(LogLevel level, const std::string& text) {
  if (host_.log) host_.log({level, text});
}

// ---- objects

// The registry slot where userdata of a pool are kept, so that a node is always the same key of a table.
static void push_cached(lua_State* L, const void* slot, std::uint32_t index, std::uint32_t generation, Tag tag, int user_values) {
  lua_rawgetp(L, LUA_REGISTRYINDEX, slot);
  if (lua_rawgeti(L, -1, static_cast<lua_Integer>(index) + 1) == LUA_TUSERDATA) {
    const auto* known = static_cast<const Object<NodeId>*>(lua_touserdata(L, -1));
    if (known->value.generation == generation) return lua_remove(L, -2);
  }
  lua_pop(L, 1);
  push_object(L, tag, NodeId{index, generation}, user_values);
  lua_pushvalue(L, -1);
  lua_rawseti(L, -3, static_cast<lua_Integer>(index) + 1);
  lua_remove(L, -2);
}

void Script::push_node(NodeId node) {
  if (!node) return lua_pushnil(running_);
  push_cached(running_, &live_, node.index, node.generation, Tag::node, 6);
}

void Script::push_joint(JointRef joint) {
  if (!joint) return lua_pushnil(running_);
  push_cached(running_, &declared_, joint.index, joint.generation, Tag::joint, 0);
}

void Script::push_component(NodeId node, Tag tag) {
  lua_State* L = running_;
  const int slot = 1 + static_cast<int>(tag) - static_cast<int>(tag == Tag::children ? Tag::children : Tag::body) + (tag == Tag::children ? 5 : 0);
  push_node(node);
  if (lua_getiuservalue(L, -1, slot) != LUA_TUSERDATA) {
    lua_pop(L, 1);
    push_object(L, tag, ComponentData{node});
    lua_pushvalue(L, -1);
    lua_setiuservalue(L, -3, slot);
  }
  lua_remove(L, -2);
}

std::string Script::object_text(int index) {
  lua_State* L = running_;
  const Tag tag = tag_at(L, index);
  if (const Vec3* v = vec3_at(L, index)) return text(Value(*v));
  if (const Quat* q = object_at<Quat>(L, index, Tag::quat)) return text(Value(*q));
  if (const Color* c = object_at<Color>(L, index, Tag::color)) return "color \"" + to_hex(*c) + "\"";
  if (const NodeId* node = object_at<NodeId>(L, index, Tag::node)) {
    const SceneNode* n = engine().scene.get(*node);
    return n ? "node '" + n->name + "'" : "a destroyed node";
  }
  if (const JointRef* joint = object_at<JointRef>(L, index, Tag::joint)) {
    const JointRecord* record = engine().joint(*joint);
    return record ? record->type + " '" + record->name + "'" : "a destroyed joint";
  }
  if (tag >= Tag::body && tag <= Tag::camera) {
    const NodeId node = object_at<ComponentData>(L, index, tag)->node;
    const SceneNode* n = engine().scene.get(node);
    return std::string(tag_name(tag)) + (n ? " of node '" + n->name + "'" : " of a destroyed node");
  }
  return tag_name(tag);
}

std::string Script::dead_node_text(NodeId node) const {
  const auto found = dead_.find(node);
  return found != dead_.end() ? found->second : "this node was destroyed";
}

CameraView Script::view_of(NodeId node) const {
  const SceneNode* n = live_.scene.get(node);
  if (!n || !n->camera) return camera_view(live_);
  const Transform& world = live_.scene.world(node);
  return {{world.position, world.rotation}, n->camera->field_of_view, n->camera->near, n->camera->far};
}

Results Script::push_behaviours(NodeId node) {
  if (phase_ == Phase::declare) {
    refuse_declaration();
    fail("node.behaviours: behaviours run from start() on; give their properties in scene.add { behaviours = ... }");
  }
  call_boot_inside("behaviours", node, 1);
  return {1};
}

int Script::send_message(int node_at, int message_at) {
  lua_State* L = running_;
  static const Row row = [] {
    Row r;
    r.area = "scene";
    r.name = "send";
    r.permit = Permit::act;
    return r;
  }();
  check_permit(*this, row);
  const int count = lua_gettop(L) - message_at + 1;
  push_boot(L, "send");
  lua_insert(L, message_at);
  if (node_at) lua_pushvalue(L, node_at);
  else lua_pushnil(L);
  lua_insert(L, message_at + 1);
  lua_call(L, count + 1, 1);
  return 1;
}

bool Script::push_slot(int node, const std::string& name) {
  lua_State* L = running_;
  push_boot(L, "get_slot");
  lua_pushvalue(L, node);
  lua_pushlstring(L, name.data(), name.size());
  lua_call(L, 2, 2);
  if (lua_toboolean(L, -2)) return true;
  lua_pop(L, 2);
  return false;
}

bool Script::set_slot(int node, const std::string& name, int value) {
  lua_State* L = running_;
  push_boot(L, "set_slot");
  lua_pushvalue(L, node);
  lua_pushlstring(L, name.data(), name.size());
  lua_pushvalue(L, value);
  lua_call(L, 3, 1);
  return lua_toboolean(L, -1);
}

void Script::push_boot(lua_State* L, const char* function) {
  lua_rawgetp(L, LUA_REGISTRYINDEX, this);
  lua_getfield(L, -1, function);
  lua_remove(L, -2);
}

void Script::call_boot_inside(const char* function, NodeId node, int results) {
  push_boot(running_, function);
  push_node(node);
  lua_call(running_, 1, results);
}

// ---- calls from outside, and their failures

static int add_traceback(lua_State* L) {
  // The message with its traceback: "text\0traceback", taken apart again in protected_call.
  std::string message = lua_isstring(L, 1) ? lua_tostring(L, 1) : luaL_tolstring(L, 1, nullptr);
  luaL_traceback(L, L, nullptr, 1);
  const std::string traceback = lua_tostring(L, -1);
  const std::string both = message + '\0' + traceback;
  lua_pushlstring(L, both.data(), both.size());
  return 1;
}

std::pair<std::string, std::string> split_failure(lua_State* L, int index) {
  std::size_t size = 0;
  const char* text = lua_tolstring(L, index, &size);
  if (!text) return {"an error without a text", ""};
  const std::string both(text, size);
  const std::size_t at = both.find('\0');
  if (at == std::string::npos) return {both, ""};
  return {both.substr(0, at), both.substr(at + 1)};
}

bool Script::protected_call_on(lua_State* L, int arguments, int results) {
  const int base = lua_gettop(L) - arguments;
  lua_pushcfunction(L, add_traceback);
  lua_insert(L, base);
  watchdog_->enter(L);
  lua_State* outer = running_;
  const int status = lua_pcall(L, arguments, results, base);
  set_running(outer);
  lua_remove(L, base);
  const bool stopped = watchdog_->tripped();
  if (stopped) watchdog_->reset(L);
  watchdog_->leave();
  if (status == LUA_OK) return true;
  const auto [message, traceback] = status == LUA_ERRMEM
      ? std::pair<std::string, std::string>{"the scripts need more memory than the " + std::to_string(memory_.limit() >> 20) + " MiB that they may have", ""}
      : split_failure(L, -1);
  lua_pop(L, 1);
  report_failure(message, traceback);
  return false;
}

bool Script::call_boot(const char* function, int arguments, int results, Phase phase) {
  push_boot(L_, function);
  lua_insert(L_, -arguments - 1);
  const Phase outer = phase_;
  phase_ = phase;
  const bool ok = protected_call_on(L_, arguments, results);
  phase_ = outer;
  return ok;
}

namespace {

// Lines of the traceback that are not the author's.
std::string tidy_traceback(const std::string& traceback) {
  std::string tidy;
  std::size_t begin = 0;
  while (begin < traceback.size()) {
    const std::size_t end = std::min(traceback.find('\n', begin), traceback.size());
    const std::string line = traceback.substr(begin, end - begin);
    begin = end + 1;
    if (line.find("boot/") != std::string::npos || line.find("[C]:") != std::string::npos || line.rfind("stack traceback", 0) == 0) continue;
    tidy += line + '\n';
  }
  return tidy;
}

// What Lua says of a missing component does not name the way out; we can.
std::string explain(const std::string& message) {
  for (const char* part : {"body", "mesh", "light", "camera"}) {
    const std::string field = std::string("(field '") + part + "')";
    if (message.find("attempt to index a nil value " + field) != std::string::npos)
      return message + "; the node has no " + part + ": add one with node." + part + " = " + (part == std::string("body") ? "{ mass = 1 }" : "...");
  }
  return message;
}

}  // namespace

void Script::report_failure(const std::string& message, const std::string& traceback) {
  ++errors;
  ScriptFailure failure;
  failure.text = explain(message);
  failure.traceback = tidy_traceback(traceback);
  // "path.lua:12: ..." names the place.
  const std::size_t colon = message.find(".lua:");
  if (colon != std::string::npos) {
    failure.file = message.substr(0, colon + 4);
    failure.line = std::atoi(message.c_str() + colon + 5);
    if (failure.line > 0) failure.source = source_line(failure.file, failure.line);
  }
  if (!shown_error) shown_error = failure;
  if (host_.on_error) host_.on_error(failure);
}

// ---- one tick

namespace {
const char* notice_name(InputNotice::Kind kind) {
  switch (kind) {
    case InputNotice::Kind::press: return "on_press";
    case InputNotice::Kind::release: return "on_release";
    case InputNotice::Kind::pointer_move: return "on_pointer_move";
    case InputNotice::Kind::wheel: return "on_wheel";
    case InputNotice::Kind::text: return "on_text";
  }
  return "";
}
}  // namespace

void Script::deliver_input(const std::vector<InputNotice>& notices) {
  for (const InputNotice& notice : notices) {
    lua_pushboolean(L_, live_settings_.paused);
    lua_pushstring(L_, notice_name(notice.kind));
    int arguments = 3;
    if (notice.kind == InputNotice::Kind::pointer_move) {
      lua_pushnumber(L_, notice.x);
      lua_pushnumber(L_, notice.y);
      ++arguments;
    } else if (notice.kind == InputNotice::Kind::wheel) {
      lua_pushnumber(L_, notice.x);
    } else {
      lua_pushlstring(L_, notice.name.data(), notice.name.size());
    }
    call_boot("input", arguments, 0, Phase::run);
  }
}

void Script::run_tasks(double) { call_boot("tasks", 0, 0, Phase::run); }

void Script::update(double dt) {
  lua_pushnumber(L_, dt);
  call_boot("update", 1, 0, Phase::run);
}

void Script::late_update(double dt) {
  lua_pushnumber(L_, dt);
  call_boot("late_update", 1, 0, Phase::run);
}

void Script::draw_ui() {
  lua_pushboolean(L_, live_settings_.paused);
  call_boot("draw_ui", 1, 0, Phase::run);
}

void Script::frame(double dt) {
  frame_drawing_ = {};
  lua_pushnumber(L_, dt);
  call_boot("frame", 1, 0, Phase::frame);
}

void Script::send(const std::string& message, const std::vector<Value>& arguments) {
  lua_pushnil(L_);
  lua_pushlstring(L_, message.data(), message.size());
  for (const Value& value : arguments) push_value(L_, value);
  call_boot("send", 2 + static_cast<int>(arguments.size()), 0, Phase::run);
}

void Script::event(NodeId node, const char* name, const std::function<void()>& push_argument) {
  if (!live_.scene.get(node)) return;
  push_node(node);
  lua_pushstring(L_, name);
  int arguments = 2;
  if (push_argument) {
    push_argument();
    ++arguments;
  }
  call_boot("event", arguments, 0, Phase::run);
}

void Script::physics_events(const Events& events) {
  static const char* const names[2][3] = {{"on_collision_exit", "on_collision_enter", "on_collision_stay"},
                                          {"on_trigger_exit", "on_trigger_enter", "on_trigger_stay"}};
  for (const ContactEvent& contact : events.contacts) {
    const auto [a, b] = live_.nodes_of(contact);
    // A handler may have destroyed a partner meanwhile: its enters and stays are dropped, its exit is told.
    if (contact.kind != EventKind::exit && !(live_.alive(a) && live_.alive(b))) continue;
    const char* name = names[contact.trigger][static_cast<int>(contact.kind)];
    event(a, name, [&] { push_hit(L_, hit_of(contact, contact.a)); });
    if (contact.kind != EventKind::exit && !(live_.alive(a) && live_.alive(b))) continue;
    event(b, name, [&] { push_hit(L_, hit_of(contact, contact.b)); });
  }
  for (const JointEvent& broken : events.breaks) {
    const JointRef id = live_.joint_of(broken.joint);
    JointRecord* joint = live_.joint(id);
    if (!joint) continue;
    joint->broken = true;
    const NodeId a = joint->a, b = joint->b;
    event(a, "on_joint_break", [&] { push_joint(id); });
    if (b) event(b, "on_joint_break", [&] { push_joint(id); });
  }
  for (const SleepEvent& sleep : events.sleeps) event(live_.node_of(sleep.body), sleep.asleep ? "on_sleep" : "on_wake", {});
  for (const BodyId body : events.lost) {
    const SceneNode* n = live_.scene.get(live_.node_of(body));
    log(LogLevel::error, "node '" + (n ? n->name : "?") + "': its body's motion became infinite; it was put back to its last place and switched off (node.enabled = true brings it back)");
  }
}

void Script::run_bot(std::vector<InputEvent>& events) {
  ++bot_ticks_;
  bot_events_ = &events;
  call_boot("bot", 0, 0, testing_ ? Phase::run : Phase::watch);
  bot_events_ = nullptr;
}

std::uint64_t Script::hash() const {
  Hash hash;
  hash.add(live_.hash()).add(seconds_now);
  for (const auto& [key, value] : report) hash.add(key).add(text(value));
  return hash.value();
}

}  // namespace tumble
