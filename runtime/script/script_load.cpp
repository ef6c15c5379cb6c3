// Starting the scripts, and running them again when their text changed.
#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "script/areas.h"
#include "script/core.h"
#include "script/dispatch.h"
#include "script/embedded.h"
#include "script/sandbox.h"
#include "script/script.h"
#include "script/watchdog.h"

namespace tumble {

void open_value_makers(lua_State* L);

namespace {

// A function of the host: checks its arguments as rows do, and hands them over as Values.
int call_host(lua_State* L) {
  return at_border(L, [L] {
    const auto& function = *static_cast<const HostFunction*>(lua_touserdata(L, lua_upvalueindex(1)));
    std::vector<Value> arguments;
    for (std::size_t i = 0; i < function.params.size(); ++i) {
      const std::string& type = function.params[i].type;
      const int at = static_cast<int>(i) + 1;
      const int have = lua_type(L, at);
      const bool fits = type == "any" || (type == "number" && have == LUA_TNUMBER) || (type == "string" && have == LUA_TSTRING) ||
                        (type == "boolean" && have == LUA_TBOOLEAN) || (type == "vec3" && vec3_at(L, at));
      if (!fits) fail("host.", function.name, ": argument ", at, " (", function.params[i].name, "): ", type, " expected, got ", describe_argument(L, at));
      arguments.push_back(value_from_lua(L, at, "host." + function.name));
    }
    if (lua_gettop(L) > static_cast<int>(arguments.size())) fail("host.", function.name, ": takes ", arguments.size(), " arguments, got ", lua_gettop(L));
    push_value(L, function.call(arguments));
    return 1;
  });
}

int call_help(lua_State* L) {
  return at_border(L, [L] {
    const std::string name = lua_type(L, 1) == LUA_TSTRING ? lua_tostring(L, 1)
                             : lua_type(L, 1) == LUA_TUSERDATA ? tag_name(tag_at(L, 1))
                             : lua_type(L, 1) == LUA_TTABLE && luaL_getmetafield(L, 1, "__metatable") == LUA_TSTRING ? lua_tostring(L, -1) : "";
    for (const Area* area : all_areas()) {
      if (area->name != name) continue;
      script_of(L).log(LogLevel::print, area->name + ": " + area->doc);
      for (const Row& row : area->rows) script_of(L).log(LogLevel::print, "  " + row.full_name() + "  " + row.doc);
    }
    return 0;
  });
}

void push_host_module(lua_State* L, const std::vector<HostFunction>& functions) {
  lua_newtable(L);
  for (const HostFunction& function : functions) {
    lua_pushlightuserdata(L, const_cast<HostFunction*>(&function));
    lua_pushcclosure(L, call_host, 1);
    lua_setfield(L, -2, function.name.c_str());
  }
  make_read_only(L, "host");
}

}  // namespace

void Script::add_host_function(HostFunction function) { host_functions_.push_back(std::move(function)); }

void Script::run_boot() {
  lua_State* L = L_;
  for (const void* slot : {static_cast<const void*>(&live_), static_cast<const void*>(&declared_), static_cast<const void*>(&report)}) {
    lua_newtable(L);
    lua_rawsetp(L, LUA_REGISTRYINDEX, slot);
  }
  push_core(L);
  lua_newtable(L);
  const int globals = lua_gettop(L);
  open_sandbox(L, globals);
  open_areas(L, globals);
  lua_pushvalue(L, globals);
  open_value_makers(L);
  lua_settop(L, globals);
  push_host_module(L, host_functions_);
  lua_setfield(L, globals, "host");
  lua_pushcfunction(L, call_help);
  lua_setfield(L, globals, "help");
  lua_getfield(L, globals, "pairs");
  lua_setfield(L, globals - 1, "pairs");
  lua_setfield(L, globals - 1, "globals");

  const std::string_view text = embedded_script("boot/boot.lua");
  if (luaL_loadbufferx(L, text.data(), text.size(), "@boot/boot.lua", "t") != LUA_OK) fail(lua_tostring(L, -1));
  lua_insert(L, -2);
  if (lua_pcall(L, 1, 1, 0) != LUA_OK) fail("Tumble's own scripts failed: ", lua_tostring(L, -1));
  lua_getfield(L, -1, "exports");
  provide_scripted(L, -1);
  lua_pop(L, 1);
  lua_rawsetp(L, LUA_REGISTRYINDEX, this);
  // From here on collect_garbage() does it, once a tick; Lua does not collect by itself.
  lua_gc(L, LUA_GCSTOP);
}

// A stored key that no longer fits is passed over: the game or its keys have changed since.
void Script::begin_storage(Stored stored) {
  for (const auto& [action, names] : stored.bindings) {
    const bool known = live_.settings.actions.contains(action) && std::all_of(names.begin(), names.end(), is_raw_input_name);
    if (known) live_.input.bind(action, names);
  }
  storage.begin(std::move(stored));
}

// A young collection finds what went soon after it was made, and costs as much as was made. What lived longer is found by
// a full one: when a scene has gone, which takes longer anyway, and when memory has doubled or come near its limit since.
void Script::collect_garbage() {
  constexpr std::size_t kSlack = std::size_t{4} << 20;  // so that small games do not collect in full all the time
  const std::size_t most = std::min(2 * after_full_collection_ + kSlack, (after_full_collection_ + memory_.limit()) / 2);
  if (!scene_went_ && memory_.used() <= most) {
    lua_gc(L_, LUA_GCSTEP, 0);
    return;
  }
  lua_gc(L_, LUA_GCCOLLECT);
  scene_went_ = false;
  after_full_collection_ = memory_.used();
}

bool Script::load() {
  if (!booted_) {
    run_boot();
    booted_ = true;
  }
  bool loaded = call_boot("load", 0, 1, Phase::run);
  if (loaded) {
    loaded = lua_toboolean(L_, -1);
    lua_pop(L_, 1);
  }
  if (!loaded) return false;
  if (!live_.settings.start_scene.empty()) {
    open_scene_quietly(live_.settings.start_scene);
  }
  call_boot("start_main", 0, 0, Phase::run);
  call_boot("start_new", 0, 0, Phase::run);
  lua_pushlstring(L_, live_.scene_name.data(), live_.scene_name.size());
  call_boot("scene_started", 1, 0, Phase::run);
  remove_dying();
  loaded_ = true;
  if (host_.bot) {
    call_boot("load_bot", 0, 0, Phase::run);
  }
  return true;
}

std::string Script::reload(const std::vector<std::string>& changed) {
  const bool scripts = std::any_of(changed.begin(), changed.end(), [](const std::string& path) {
    return path.ends_with(".lua") && path != "bot.lua" && !path.starts_with("tests/");
  });
  const bool scenes = std::any_of(changed.begin(), changed.end(), [](const std::string& path) { return path.ends_with(".json") && path != "game.json"; });
  if (!scripts && !scenes) return "";
  if (!loaded_) return reload_first();
  const int errors_before = errors;
  const std::optional<ScriptFailure> shown = std::move(shown_error);
  shown_error.reset();
  if (!call_boot("reload", 0, 2, Phase::run)) return "";
  const bool took = lua_toboolean(L_, -2);
  std::string text = lua_tostring(L_, -1) ? lua_tostring(L_, -1) : "";
  lua_pop(L_, 2);
  if (took && scenes) text += reload_scene();
  if (!took && errors == errors_before) shown_error = shown;
  flush();
  return took ? "reloaded " + join(changed) + ": " + text : "";
}

// The text was faulty from the start: the game has not begun yet.
std::string Script::reload_first() {
  shown_error.reset();
  return load() ? "loaded" : "";
}

std::vector<std::string> Script::list_tests(const std::string& path) {
  std::vector<std::string> claims;
  lua_pushlstring(L_, path.data(), path.size());
  if (!call_boot("list_tests", 1, 1, Phase::run)) return claims;
  for (lua_Integer i = 1; lua_rawgeti(L_, -1, i) == LUA_TSTRING; ++i, lua_pop(L_, 1)) claims.emplace_back(lua_tostring(L_, -1));
  lua_pop(L_, 2);
  return claims;
}

void Script::start_test(int number) {
  testing_ = true;
  test_outcome.reset();
  lua_pushinteger(L_, number);
  call_boot("start_test", 1, 0, Phase::run);
}

void Script::reset_watchdog(lua_State* L) { watchdog_->reset(L); }

// What scripts put into game.report, for who asks: copied, so that a faulty entry stops nothing.
void Script::read_report() {
  lua_rawgetp(L_, LUA_REGISTRYINDEX, &report);
  try {
    const Value value = value_from_lua(L_, -1, "game.report");
    report = value.is<Map>() ? *value.get<Map>() : Map{};
    std::erase_if(report, [this](const auto& entry) {
      if (!entry.second.is_number() || std::isfinite(entry.second.number())) return false;
      if (!report_warned_) log(LogLevel::warning, "game.report." + entry.first + " is " + text(entry.second) + " and is left out of the report");
      return report_warned_ = true;
    });
  } catch (const Error& error) {
    if (!report_warned_) log(LogLevel::warning, error.what());
    report_warned_ = true;
  }
  lua_pop(L_, 1);
}

}  // namespace tumble
