#include "script/script.h"

#include <algorithm>

#include "base/hash.h"
#include "base/text.h"
#include "engine/ui/ui.h"
#include "script/areas.h"
#include "script/core.h"
#include "script/dispatch.h"
#include "script/sandbox.h"
#include "script/watchdog.h"

namespace tumble {

const EnumNames& enum_names(DebugView) {
  static const EnumNames names = {"none", "colliders", "joints", "boxes", "contacts", "rays", "velocities", "names", "physics"};
  return names;
}

void describe(ModuleSettings& settings, Schema& s) {
  s.name("settings", "What a file's top level may set beside nodes.");
  s.add("physics", settings.physics, "The world's settings.");
  s.add("time_scale", settings.time_scale, "time.scale.");
  s.add("paused", settings.paused, "time.paused.");
  s.add("pointer_captured", settings.pointer_captured, "input.pointer.captured.");
  s.add("debug_view", settings.debug_view, "physics.debug_view.");
  s.add("ui", settings.ui, "ui.style.");
  s.add("sound_volume", settings.sound_volume, "sound.volume.");
  s.add("sound_groups", settings.sound_groups, "sound.groups.");
}

static std::string_view line_of(std::string_view text, int line) {
  std::size_t begin = 0;
  for (int n = 1; n < line; ++n) {
    begin = text.find('\n', begin);
    if (begin == std::string_view::npos) return "";
    ++begin;
  }
  return text.substr(begin, text.find('\n', begin) - begin);
}

Script::Script(Engine& engine, ScriptHost host) : live_(engine), host_(std::move(host)), memory_(host_.memory_limit) {
  first_settings_.physics = engine.settings.physics;
  for (const std::string& group : engine.sounds.groups()) first_settings_.sound_groups[group] = 1;
  live_settings_ = first_settings_;
  watchdog_ = std::make_unique<Watchdog>(host_.time_limit);
  ui_ = std::make_unique<Ui>();
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
  lua_State* L = running_;
  lua_Debug record;
  std::string line;
  if (lua_getstack(L, 1, &record) && lua_getinfo(L, "Sl", &record) && record.source[0] == '@') {
    push_boot(L, "declared_text");
    lua_pushstring(L, record.source + 1);
    lua_call(L, 1, 1);
    if (const char* text = lua_tostring(L, -1)) line = line_of(text, record.currentline);
    lua_pop(L, 1);
  }
  const int nth = key_counts_["random " + line]++;
  declare_random_ = Random(Hash().add(seed_).add(line).add(static_cast<std::uint64_t>(nth)).value());
  return declare_random_;
}

std::string Script::source_line(const std::string& file, int line) const {
  const std::optional<std::string> text = host_.read(file);
  return text ? std::string(line_of(*text, line)) : "";
}

void Script::log(LogLevel level, const std::string& text) {
  if (host_.log) host_.log({level, text});
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
    if (line.find("boot/") != std::string::npos || line.find("[C]:") != std::string::npos || line.find("(...tail calls...)") != std::string::npos || line.rfind("stack traceback", 0) == 0) continue;
    tidy += line + '\n';
  }
  // A file is called by what loads it, under a name that says nothing; alone it only repeats where the error was.
  constexpr std::string_view kFile = "in local 'chunk'";
  std::size_t at = tidy.find(kFile);
  if (at != std::string::npos && std::count(tidy.begin(), tidy.end(), '\n') == 1) return "";
  for (; at != std::string::npos; at = tidy.find(kFile, at)) tidy.replace(at, kFile.size(), "in the file itself");
  return tidy;
}

// What Lua says of a missing component does not name the way out; we can.
std::string explain(const std::string& message) {
  for (const char* part : {"body", "mesh", "light", "camera", "sky", "sound", "particles", "animation"}) {
    const std::string field = std::string("(field '") + part + "')";
    if (message.find("attempt to index a nil value " + field) != std::string::npos)
      return message + "; the node has no " + part + ": add one with node." + part + " = " + (part == std::string("body") ? "{ mass = 1 }" : "...");
  }
  if (message.find("attempt to yield across a C-call boundary") != std::string::npos)
    return message + ": wait() works in the task itself, not in a handler that a task called by node:send or scene.send";
  return message;
}

}  // namespace

void Script::report_failure(const std::string& message, const std::string& traceback) {
  ++errors;
  ScriptFailure failure;
  failure.text = explain(message);
  constexpr std::size_t kLongest = 1000;   // a message may quote a word of a megabyte
  if (failure.text.size() > kLongest) failure.text = failure.text.substr(0, kLongest) + " ...";
  failure.traceback = tidy_traceback(traceback);
  failure.in_text = staging_ != nullptr;
  // "path.lua:12: ..." names the place.
  const std::size_t colon = message.find(".lua:");
  if (colon != std::string::npos) {
    failure.file = message.substr(0, colon + 4);
    failure.line = std::atoi(message.c_str() + colon + 5);
    if (failure.line > 0) failure.source = source_line(failure.file, failure.line).substr(0, 200);
  }
  if (!shown_error) shown_error = failure;
  if (host_.on_error) host_.on_error(failure);
}

std::uint64_t Script::hash() const {
  Hash hash;
  hash.add(live_.hash()).add(seconds_now);
  for (const auto& [key, value] : report) hash.add(key).add(text(value));
  return hash.value();
}

}  // namespace tumble
