#include "script/core.h"

#include <algorithm>

#include "base/text.h"
#include "engine/ui/ui.h"
#include "script/coroutines.h"
#include "script/embedded.h"
#include "script/pairs.h"
#include "script/bind.h"
#include "script/script.h"

namespace tumble {

// A friend of Script: everything here is for boot's eyes only.
struct CoreApi {
  static Script& script(lua_State* L) { return script_of(L); }
  static std::string string_at(lua_State* L, int index) {
    std::size_t size = 0;
    const char* text = lua_tolstring(L, index, &size);
    return text ? std::string(text, size) : std::string();
  }
  static int push_text(lua_State* L, const std::optional<std::string>& text) {
    if (text) lua_pushlstring(L, text->data(), text->size());
    else lua_pushnil(L);
    return 1;
  }

  // ---- files
  static int part(lua_State* L) {
    const std::string path = "boot/" + string_at(L, 1) + ".lua";
    const std::string_view text = embedded_script(path);
    if (luaL_loadbufferx(L, text.data(), text.size(), ("@" + path).c_str(), "t") != LUA_OK) return lua_error(L);
    lua_call(L, 0, 1);
    return 1;
  }
  static int read(lua_State* L) {
    return at_border(L, [L] { return push_text(L, script(L).host_.read(string_at(L, 1))); });
  }
  static int read_std(lua_State* L) {
    const std::string_view text = embedded_script("std/" + string_at(L, 1) + ".lua");
    return push_text(L, text.empty() ? std::nullopt : std::optional(std::string(text)));
  }
  static int list_scripts(lua_State* L) {
    return at_border(L, [L] {
      std::vector<std::string> names;
      for (const std::string& path : script(L).host_.list(""))
        if (path.ends_with(".lua")) names.push_back(path.substr(0, path.size() - 4));
      for (const std::string& path : embedded_scripts())
        if (path.starts_with("std/")) names.push_back(path.substr(4, path.size() - 8));
      return LuaType<std::vector<std::string>>::push(L, names);
    });
  }
  // The script to run first; "" where a game is scenes alone.
  static int entry(lua_State* L) { return push_text(L, script(L).host_.entry); }
  static int compile(lua_State* L) {
    std::size_t size = 0;
    const char* text = lua_tolstring(L, 1, &size);
    if (size >= 3 && std::string_view(text, 3) == "\xEF\xBB\xBF") text += 3, size -= 3;   // some editors' mark of UTF-8
    const std::string file = string_at(L, 2);
    if (!is_utf8({text, size})) {
      lua_pushnil(L);
      lua_pushfstring(L, "%s: the file is not UTF-8 text; save it as UTF-8", file.c_str());
      return 2;
    }
    // Text only: bytecode can crash the machine that runs it.
    const int status = luaL_loadbufferx(L, text, size, ("@" + file).c_str(), "t");
    if (status != LUA_OK) {
      if (!std::string_view(lua_tostring(L, -1)).starts_with(file)) {
        lua_pushfstring(L, "%s: %s", file.c_str(), lua_tostring(L, -1));
        lua_remove(L, -2);
      }
      lua_pushnil(L);
      lua_insert(L, -2);
      return 2;
    }
    lua_pushvalue(L, 3);
    lua_setupvalue(L, -2, 1);
    return 1;
  }
  static int set_file(lua_State* L) {
    Script& s = script(L);
    lua_pushlstring(L, s.declaring_file_.data(), s.declaring_file_.size());
    s.declaring_file_ = string_at(L, 1);
    return 1;
  }
  // The text of a function of that name at the top level, to see whether start() changed.
  static int function_text(lua_State* L) {
    const std::string text = string_at(L, 1), name = "function " + string_at(L, 2) + "(";
    std::size_t begin = text.rfind(name, 0) == 0 ? 0 : text.find("\n" + name);
    if (begin == std::string::npos) return lua_pushliteral(L, ""), 1;
    const std::size_t end = text.find("\nend", begin);
    const std::size_t line = text.find('\n', begin + 1);
    const std::size_t stop = std::min(end == std::string::npos ? text.size() : end, text.find("\nfunction", line == std::string::npos ? begin : line));
    const std::string part = text.substr(begin, stop - begin);
    return lua_pushlstring(L, part.data(), part.size()), 1;
  }

  // ---- staging
  static int begin_staging(lua_State* L) { return script(L).begin_staging(), 0; }
  static int drop_staging(lua_State* L) { return script(L).drop_staging(), 0; }
  static int check_declarations(lua_State* L) {
    return at_border(L, [L] {
      if (script(L).refused_) fail("the top level of a file called what only functions may call (an error that pcall hid); put it in start()");
      return 0;
    });
  }
  static void push_changes(lua_State* L, const std::vector<CommitResult::Change>& changes) {
    lua_newtable(L);
    lua_Integer n = 0;
    for (const CommitResult::Change& change : changes) {
      lua_newtable(L);
      script(L).push_node(change.node);
      lua_setfield(L, -2, "node");
      push_value(L, change.behaviours.is_nil() ? Value(Map{}) : change.behaviours);
      lua_setfield(L, -2, "behaviours");
      push_value(L, change.before.is_nil() ? Value(Map{}) : change.before);
      lua_setfield(L, -2, "before");
      lua_rawseti(L, -2, ++n);
    }
  }
  static int commit(lua_State* L) {
    return at_border(L, [L] {
      const CommitResult result = script(L).commit(lua_toboolean(L, 1));
      lua_newtable(L);
      push_changes(L, result.added);
      lua_setfield(L, -2, "added");
      push_changes(L, result.changed);
      lua_setfield(L, -2, "changed");
      LuaType<std::vector<std::string>>::push(L, result.log);
      lua_setfield(L, -2, "log");
      return 1;
    });
  }
  static int begin_late(lua_State* L) { return lua_pushinteger(L, static_cast<int>(script(L).phase_)), 1; }
  static int end_late(lua_State* L) {
    script(L).phase_ = static_cast<Phase>(lua_tointeger(L, 1));
    return 0;
  }
  static int declared_nodes(lua_State* L) {
    Script& s = script(L);
    lua_newtable(L);
    lua_Integer n = 0;
    for (const auto& node : s.staging_ ? s.staged_.nodes : s.declared_.nodes) {
      s.push_node(node.handle);
      lua_rawseti(L, -2, ++n);
    }
    return 1;
  }
  static int node_key(lua_State* L) {
    Script& s = script(L);
    const NodeId* id = object_at<NodeId>(L, 1, Tag::node);
    for (const auto& node : s.staging_ ? s.staged_.nodes : s.declared_.nodes)
      if (id && node.handle == *id) return lua_pushlstring(L, node.key.data(), node.key.size()), 1;
    return lua_pushliteral(L, "node"), 1;
  }

  // ---- nodes
  static NodeId node_at(lua_State* L, int index) {
    const NodeId* id = object_at<NodeId>(L, index, Tag::node);
    return id ? *id : NodeId{};
  }
  static int alive(lua_State* L) { return lua_pushboolean(L, script(L).live_.alive(node_at(L, 1))), 1; }
  // Is it an object of the engine, or a part of one, that is no more?
  static int is_gone(lua_State* L) {
    const Tag tag = tag_at(L, 1);
    Reference root{Reference::Kind::node, 0, 0};
    if (const NodeId* id = object_at<NodeId>(L, 1, Tag::node)) root = {Reference::Kind::node, id->index, id->generation};
    else if (const JointRef* id = object_at<JointRef>(L, 1, Tag::joint)) root = {Reference::Kind::joint, id->index, id->generation};
    else if (const ViewData* view = object_at<ViewData>(L, 1, Tag::view)) root = view->root;
    else if (tag >= Tag::body && tag < Tag::view) {
      const NodeId node = object_at<ComponentData>(L, 1, tag)->node;
      root = {Reference::Kind::node, node.index, node.generation};
    } else {
      return lua_pushboolean(L, false), 1;
    }
    Engine& engine = script(L).live_;
    const bool there = root.kind == Reference::Kind::node ? engine.alive({root.index, root.generation}) : engine.joint({root.index, root.generation}) != nullptr;
    return lua_pushboolean(L, !there), 1;
  }
  static int node_enabled(lua_State* L) {
    Script& s = script(L);
    const NodeId id = node_at(L, 1);
    return lua_pushboolean(L, s.live_.scene.get(id) && s.live_.scene.enabled_in_tree(id)), 1;
  }
  static int mark(lua_State* L) { return script(L).mark_scripted(node_at(L, 1)), 0; }
  static int scripted_nodes(lua_State* L) {
    Script& s = script(L);
    lua_newtable(L);
    lua_Integer n = 0;
    for (const NodeId id : s.scripted_nodes()) {
      s.push_node(id);
      lua_rawseti(L, -2, ++n);
    }
    return 1;
  }
  static int find_node(lua_State* L) {
    return at_border(L, [L] {
      Script& s = script(L);
      const std::string path = string_at(L, 1);
      Engine& engine = s.engine();
      NodeId id = engine.scene.find_id(path);
      if (!id && engine.scene_root && engine.scene.get(engine.scene_root)) id = engine.scene.find(path, engine.scene_root);
      if (!id) id = engine.scene.get_by_path(path, {}, string_at(L, 2));
      s.push_node(id);
      return 1;
    });
  }
  static int take_lists_changed(lua_State* L) {
    Script& s = script(L);
    lua_pushboolean(L, s.lists_changed_);
    s.stays_changed_ |= s.lists_changed_;
    s.lists_changed_ = false;
    return 1;
  }
  static int lists_changed(lua_State* L) { return script(L).lists_changed(), 0; }

  // ---- time
  static int now(lua_State* L) { return lua_pushnumber(L, script(L).seconds_now), 1; }
  static int tick(lua_State* L) { return lua_pushinteger(L, static_cast<lua_Integer>(script(L).live_.tick)), 1; }
  static int tick_seconds(lua_State* L) { return lua_pushnumber(L, 1 / script(L).live_.settings.tick_rate), 1; }

  // ---- calls and errors
  static int protected_call(lua_State* L) {
    const bool ok = script(L).protected_call_on(L, lua_gettop(L) - 1, 0);
    return lua_pushboolean(L, ok), 1;
  }
  // Like protected, but the failure is handed back rather than reported.
  static int try_call(lua_State* L) {
    const int status = lua_pcall(L, lua_gettop(L) - 1, 0, 0);
    if (status != LUA_OK && script(L).over_time()) return lua_error(L);
    lua_newtable(L);
    lua_pushboolean(L, status == LUA_OK);
    lua_setfield(L, -2, "ok");
    if (status != LUA_OK) {
      lua_pushvalue(L, -2);
      lua_setfield(L, -2, "message");
    }
    return 1;
  }
  static int raise_error(lua_State* L) {
    luaL_checkstring(L, 1);
    lua_settop(L, 1);
    raise(L);
  }
  // Is the nearest game file on the stack one of scripts/std?
  static int called_from_std(lua_State* L) {
    lua_Debug record;
    for (int level = 1; lua_getstack(L, level, &record); ++level) {
      lua_getinfo(L, "S", &record);
      const std::string_view source = record.source;
      if (source.starts_with("@") && !source.starts_with("@boot/")) return lua_pushboolean(L, source.starts_with("@std/")), 1;
    }
    return lua_pushboolean(L, false), 1;
  }
  static int report(lua_State* L) {
    script(L).report_failure(string_at(L, 1), string_at(L, 2));
    return 0;
  }
  static int report_coroutine(lua_State* L) {
    lua_State* co = lua_tothread(L, 2);
    luaL_traceback(L, co, nullptr, 0);
    std::string message = lua_isstring(L, 1) ? string_at(L, 1) : luaL_tolstring(L, 1, nullptr);
    luaL_traceback(L, co, nullptr, 0);
    const std::string traceback = string_at(L, -1);
    Script& s = script(L);
    if (s.over_time()) s.reset_watchdog(co);
    s.report_failure(message, traceback);
    return 0;
  }
  static int traceback(lua_State* L) {
    luaL_traceback(L, L, lua_isstring(L, 1) ? lua_tostring(L, 1) : luaL_tolstring(L, 1, nullptr), 1);
    return 1;
  }
  static int log(lua_State* L) {
    const std::string level = string_at(L, 1);
    script(L).log(level == "warning" ? LogLevel::warning : level == "error" ? LogLevel::error : LogLevel::note, string_at(L, 2));
    return 0;
  }
  static int permit_act(lua_State* L) {
    return at_border(L, [L] {
      Row row;
      const std::string name = string_at(L, 1);
      const std::size_t dot = name.find('.');
      row.area = dot == std::string::npos ? "" : name.substr(0, dot);
      row.name = dot == std::string::npos ? name : name.substr(dot + 1);
      row.permit = Permit::act;
      check_permit(script(L), row);
      return 0;
    });
  }

  // ---- coroutines
  static int coroutine(lua_State* L) {
    lua_State* co = lua_newthread(L);
    lua_pushvalue(L, 1);
    lua_xmove(L, co, 1);
    return 1;
  }
  static int yield(lua_State* L) { return lua_yield(L, lua_gettop(L)); }
  static int status(lua_State* L) {
    lua_State* co = lua_tothread(L, 1);
    lua_pushstring(L, lua_status(co) == LUA_YIELD ? "suspended" : lua_status(co) == LUA_OK && lua_gettop(co) > 0 ? "suspended" : "dead");
    return 1;
  }

  static int listen(lua_State* L) { return script(L).live_.input.listen(), 0; }

  // ---- bots and tests
  static int bot_ticks(lua_State* L) { return lua_pushinteger(L, script(L).bot_ticks_), 1; }
  // The raw name behind an action, so that bots press what a person would.
  static int raw_name(lua_State* L) {
    return at_border(L, [L] {
      const InputMap& input = script(L).live_.input;
      const std::string call = string_at(L, 1), name = string_at(L, 2);
      if (!input.knows(name)) fail(call, ": unknown name '", name, "'", did_you_mean(name, input.known_names()));
      const auto action = input.actions().find(name);
      if (action == input.actions().end()) return push_text(L, name);
      if (action->second.empty()) fail(call, ": action '", name, "' has no key in game.json");
      return push_text(L, action->second.front());
    });
  }
  static int bot_event(lua_State* L) {
    static const std::pair<const char*, InputKind> kinds[] = {{"press", InputKind::press}, {"release", InputKind::release}, {"value", InputKind::value}, {"pointer_move", InputKind::pointer_move}, {"wheel", InputKind::wheel}, {"text", InputKind::text}};
    Script& s = script(L);
    if (!s.bot_events_) return 0;
    InputEvent event;
    for (const auto& [name, kind] : kinds)
      if (string_at(L, 1) == name) event.kind = kind;
    event.name = string_at(L, 2);
    if (event.kind == InputKind::value || event.kind == InputKind::wheel) event.value = lua_tonumber(L, 3);
    if (event.kind == InputKind::pointer_move) {
      event.x = lua_tonumber(L, 3);
      event.y = lua_tonumber(L, 4);
      event.dx = event.x - s.bot_x_;
      event.dy = event.y - s.bot_y_;
      s.bot_x_ = event.x;
      s.bot_y_ = event.y;
    }
    s.bot_events_->push_back(event);
    return 0;
  }
  // The middle of a widget, or nil and what there is instead.
  static int ui_place(lua_State* L) {
    const Ui& ui = script(L).ui();
    if (const UiRect* rect = ui.find_widget(string_at(L, 1))) {
      lua_pushnumber(L, rect->x + rect->width / 2);
      lua_pushnumber(L, rect->y + rect->height / 2);
      return 2;
    }
    lua_pushnil(L);
    return 1 + push_text(L, join(ui.labels()));
  }
  static int ui_is_on_screen(lua_State* L) { return lua_pushboolean(L, script(L).ui().is_on_screen(string_at(L, 1))), 1; }
  static int test_done(lua_State* L) {
    script(L).test_outcome = {static_cast<bool>(lua_toboolean(L, 1)), string_at(L, 2)};
    return 0;
  }
};

void push_core(lua_State* L) {
  static const luaL_Reg functions[] = {
      {"part", CoreApi::part}, {"read", CoreApi::read}, {"read_std", CoreApi::read_std}, {"list_scripts", CoreApi::list_scripts},
      {"entry", CoreApi::entry}, {"compile", CoreApi::compile}, {"set_file", CoreApi::set_file}, {"function_text", CoreApi::function_text},
      {"begin_staging", CoreApi::begin_staging}, {"drop_staging", CoreApi::drop_staging}, {"commit", CoreApi::commit},
      {"check_declarations", CoreApi::check_declarations}, {"begin_late", CoreApi::begin_late}, {"end_late", CoreApi::end_late},
      {"declared_nodes", CoreApi::declared_nodes}, {"node_key", CoreApi::node_key}, {"alive", CoreApi::alive}, {"is_gone", CoreApi::is_gone},
      {"node_enabled", CoreApi::node_enabled}, {"mark", CoreApi::mark}, {"scripted_nodes", CoreApi::scripted_nodes},
      {"find_node", CoreApi::find_node}, {"take_lists_changed", CoreApi::take_lists_changed}, {"lists_changed", CoreApi::lists_changed},
      {"now", CoreApi::now}, {"tick", CoreApi::tick}, {"tick_seconds", CoreApi::tick_seconds}, {"protected", CoreApi::protected_call},
      {"try", CoreApi::try_call}, {"raise", CoreApi::raise_error}, {"called_from_std", CoreApi::called_from_std}, {"report", CoreApi::report}, {"report_coroutine", CoreApi::report_coroutine},
      {"traceback", CoreApi::traceback}, {"log", CoreApi::log}, {"permit_act", CoreApi::permit_act}, {"listen", CoreApi::listen},
      {"coroutine", CoreApi::coroutine}, {"yield", CoreApi::yield}, {"status", CoreApi::status}, {"resume", boot_resume},
      {"bot_ticks", CoreApi::bot_ticks}, {"raw_name", CoreApi::raw_name}, {"bot_event", CoreApi::bot_event}, {"test_done", CoreApi::test_done},
      {"ui_place", CoreApi::ui_place}, {"ui_is_on_screen", CoreApi::ui_is_on_screen},
  };
  lua_newtable(L);
  for (const luaL_Reg& one : functions) {
    lua_pushcfunction(L, one.func);
    lua_setfield(L, -2, one.name);
  }
  push_value_functions(L);
  lua_getglobal(L, "debug");
  lua_setfield(L, -2, "debug");
}

}  // namespace tumble
