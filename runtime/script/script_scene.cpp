// Nodes and joints as scripts make them: declared into the staging engine, or added to the running game.
#include <algorithm>

#include "base/hash.h"
#include "base/text.h"
#include "engine/scene_file.h"
#include "script/bind.h"
#include "script/script.h"

namespace tumble {

namespace {

Value take(Value& table, const std::string& key) {
  Map* map = table.get<Map>();
  if (!map) return {};
  const auto found = std::find_if(map->begin(), map->end(), [&](const auto& entry) { return entry.first == key; });
  if (found == map->end()) return {};
  Value value = std::move(found->second);
  map->erase(found);
  return value;
}

NodeId node_in(const Value& value, const std::string& where) {
  const Reference* reference = value.get<Reference>();
  if (!reference || reference->kind != Reference::Kind::node) fail(where, ": node expected, got ", kind_name(value));
  return {reference->index, reference->generation};
}

List list_of(Value value) {
  if (List* list = value.get<List>()) return std::move(*list);
  if (value.is_nil() || (value.is<Map>() && value.get<Map>()->empty())) return {};
  return {std::move(value)};
}

}  // namespace

// File, kind and name, or for a thing without a name the hash of what it was declared as; then which of that key.
std::string Script::node_key(const std::string& name, const Value& def, const char* kind) {
  std::string key = declaring_file_ + " " + kind + " ";
  key += name.empty() ? "#" + std::to_string(Hash().add(text(def)).value()) : name;
  const int nth = ++key_counts_[key];
  return key + (nth > 1 ? " " + std::to_string(nth) : "");
}

NodeId Script::declare_node(const Value& given, const std::string& call) {
  Value table = with_prefabs(given, host_.read, call);
  const Value parent_value = take(table, "parent");
  const NodeId parent = parent_value.is_nil() ? NodeId{} : node_in(parent_value, call + ": parent");
  const List children = list_of(take(table, "children"));
  const Value behaviours = take(table, "behaviours");
  NodeDef def;
  assign(def, table, call);
  attach_behaviours({}, behaviours, call);

  DeclaredNode declared;
  declared.key = node_key(def.name, table, "node");
  const auto known = declared_.node_keys.find(declared.key);
  declared.handle = known != declared_.node_keys.end() ? known->second : live_.scene.reserve();
  staged_.node_keys[declared.key] = declared.handle;
  declared.parent = parent;
  declared.behaviours = behaviours.is_nil() ? Value(Map{}) : behaviours;
  engine().add(def, parent, Origin::declared, call, declared.handle);
  const NodeId handle = declared.handle;
  staged_.nodes.push_back(std::move(declared));
  for (std::size_t i = 0; i < children.size(); ++i) {
    Value child = children[i];
    const std::string where = call + ": children[" + std::to_string(i + 1) + "]";
    if (!child.is<Map>()) fail(where, ": a table expected, got ", kind_name(child));
    child["parent"] = Reference{Reference::Kind::node, handle.index, handle.generation};
    declare_node(child, where);
  }
  return handle;
}

NodeId Script::add_node(const Value& given, NodeId parent, Origin origin, const std::string& call) {
  Value table = with_prefabs(given, host_.read, call);
  const Value parent_value = take(table, "parent");
  if (!parent_value.is_nil()) parent = node_in(parent_value, call + ": parent");
  if (parent && !live_.alive(parent)) fail(call, ": parent: ", dead_node_text(parent));
  const List children = list_of(take(table, "children"));
  const Value behaviours = take(table, "behaviours");
  NodeDef def;
  assign(def, table, call);
  const NodeId node = live_.add(def, parent, origin, call);
  try {
    attach_behaviours(node, behaviours, call);   // before the children's: start() runs parents first
    for (std::size_t i = 0; i < children.size(); ++i) add_node(children[i], node, origin, call + ": children[" + std::to_string(i + 1) + "]");
  } catch (const Error&) {
    live_.destroy(node);
    throw;
  }
  lists_changed_ = true;
  return node;
}

// With a node: attaches them; without: only checks that they exist and take these properties.
void Script::attach_behaviours(NodeId node, const Value& behaviours, const std::string& call) {
  if (behaviours.is_nil()) return;
  if (behaviours.is<List>() && behaviours.get<List>()->empty()) return;
  const Map* map = behaviours.get<Map>();
  if (!map) fail(call, ": behaviours: a table by name expected, got ", kind_name(behaviours), "; write behaviours = { slime = {} }");
  for (const auto& [name, properties] : *map) {
    if (!properties.is<Map>() && !(properties.is<List>() && properties.get<List>()->empty()))
      fail(call, ": behaviours.", name, ": a table of properties expected, got ", kind_name(properties));
    lua_State* L = running_;
    push_boot(L, node ? "attach" : "check_behaviour");
    int arguments = 3;
    if (node) {
      push_node(node);
      ++arguments;
    }
    lua_pushlstring(L, name.data(), name.size());
    push_value(L, properties);
    lua_pushlstring(L, call.data(), call.size());
    lua_call(L, arguments, 0);
  }
}

JointRef Script::add_joint(const std::string& type, const Value& given, const std::string& call) {
  if (!given.is<Map>()) fail(call, ": a table of options expected, got ", kind_name(given));
  Value options = given;
  const Value name_value = take(options, "name"), a_value = take(options, "a"), b_value = take(options, "b");
  if (!name_value.is_nil() && !name_value.is<std::string>()) fail(call, ": name: string expected, got ", kind_name(name_value));
  if (a_value.is_nil()) fail(call, ": a: node expected, got nil; a is the node that the joint holds, b the one it hangs from (nil: the world)");
  const std::string name = name_value.is_nil() ? "" : *name_value.get<std::string>();
  const NodeId a = node_in(a_value, call + ": a");
  const NodeId b = b_value.is_nil() ? NodeId{} : node_in(b_value, call + ": b");
  for (const NodeId node : {a, b})
    if (node && !engine().scene.get(node)) fail(call, ": ", dead_node_text(node));
  if (phase_ != Phase::declare) return live_.add_joint(type, name, a, b, options, Origin::added, call);

  DeclaredJoint declared{node_key(name, given, "joint"), {}, type, name, a, b, {}};
  const auto known = declared_.joint_keys.find(declared.key);
  declared.handle = known != declared_.joint_keys.end() ? known->second : live_.reserve_joint();
  staged_.joint_keys[declared.key] = declared.handle;
  engine().add_joint(type, name, a, b, options, Origin::declared, call, declared.handle);
  staged_.joints.push_back(declared);
  return declared.handle;
}

void Script::destroy_node(NodeId node) {
  if (!live_.alive(node)) return;
  lua_Debug record;
  std::string where;
  for (int level = 1; where.empty() && lua_getstack(running_, level, &record); ++level)
    if (lua_getinfo(running_, "Sl", &record) && record.source[0] == '@' && record.currentline > 0)
      where = " in " + std::string(record.source + 1) + ":" + std::to_string(record.currentline);
  std::vector<NodeId> going;
  live_.scene.each(node, [&](NodeId id, SceneNode&) { going.push_back(id); });
  for (const NodeId id : going) {
    dead_[id] = "node '" + live_.scene[id].name + "' was destroyed" + where + " at tick " + std::to_string(live_.tick);
    dead_order_.push_back(id);
  }
  // Enough to word an error about any node that a script may still hold; older ones get a shorter sentence.
  constexpr std::size_t kRemembered = 4096;
  if (dead_order_.size() > kRemembered) {
    for (std::size_t i = 0; i + kRemembered < dead_order_.size(); ++i) dead_.erase(dead_order_[i]);
    dead_order_.erase(dead_order_.begin(), dead_order_.end() - kRemembered);
  }
  live_.destroy(node);
  for (const NodeId id : going) {
    const Phase outer = phase_;
    push_node(id);
    if (running_ == L_ && phase_ == Phase::idle) {
      call_boot("destroyed", 1, 0, Phase::run);
    } else {
      push_boot(running_, "destroyed");
      lua_insert(running_, -2);
      lua_call(running_, 1, 0);
    }
    phase_ = outer;
  }
}

void Script::forget_node(NodeId node) {
  push_node(node);
  call_boot("forget", 1, 0, Phase::run);
  if (node.index < scripted_.size()) scripted_[node.index] = false;
  // Drop the cached userdata, so that its memory goes with the last script that holds it.
  lua_rawgetp(L_, LUA_REGISTRYINDEX, &live_);
  lua_pushnil(L_);
  lua_rawseti(L_, -2, static_cast<lua_Integer>(node.index) + 1);
  lua_pop(L_, 1);
  lists_changed_ = true;
}

void Script::mark_scripted(NodeId node) {
  if (node.index >= scripted_.size()) scripted_.resize(node.index + 1);
  scripted_[node.index] = true;
  lists_changed_ = true;
}

std::vector<NodeId> Script::scripted_nodes() {
  std::vector<NodeId> list;
  live_.scene.each(live_.scene.root(), [&](NodeId id, SceneNode& n) {
    if (id.index < scripted_.size() && scripted_[id.index] && !n.dying && live_.scene.enabled_in_tree(id)) list.push_back(id);
  });
  return list;
}

// ---- the end of a tick

void Script::remove_dying() {
  while (live_.has_removals()) {
    live_.remove_bodies_of_dying();
    physics_events(live_.take_events(), seconds_now);   // their exits, while partners can still be read
    for (const NodeId gone : live_.finish_removals()) forget_node(gone);
  }
}

// Stays are only made for bodies whose node has a handler for them.
void Script::refresh_stays() {
  stays_changed_ = false;
  for (const NodeId node : scripted_nodes()) {
    if (!live_.body(node)) continue;
    bool hears = false;
    for (const char* name : {"on_collision_stay", "on_trigger_stay"}) {
      push_node(node);
      lua_pushstring(L_, name);
      if (!call_boot("hears", 2, 1, Phase::run)) continue;
      hears |= static_cast<bool>(lua_toboolean(L_, -1));
      lua_pop(L_, 1);
    }
    live_.want_stay(node, hears);
  }
}

void Script::flush() {
  remove_dying();
  if (scene_restart_wanted_) {
    scene_restart_wanted_ = false;
    restart_scene_now();
  }
  if (!scene_wanted_.empty()) {
    const std::string path = std::move(scene_wanted_);
    scene_wanted_.clear();
    open_scene(path);
  }
  call_boot("start_new", 0, 0, Phase::run);
  remove_dying();
  if (lists_changed_ || stays_changed_) refresh_stays();
}

void Script::request_scene(const std::string& path) {
  if (!host_.read(path + ".json")) {
    std::vector<std::string> scenes;
    for (const std::string& file : host_.list(""))
      if (file.ends_with(".json") && file != "game.json") scenes.push_back(file.substr(0, file.size() - 5));
    fail("scene.load: no scene '", path, "' in the game", did_you_mean(path, scenes));
  }
  load_scene_file(path, host_.read, "scene.load");   // its errors belong to the line that asked
  scene_wanted_ = path;
}

void Script::attach_tree(const NodeDef& def, NodeId node, const std::string& call) {
  Map behaviours;
  for (const auto& [name, properties] : def.behaviours) behaviours.emplace_back(name, properties);
  loaded_behaviours_.emplace_back(node, Value(behaviours));
  const std::vector<NodeId> children = live_.scene[node].children;
  for (std::size_t i = 0; i < def.children.size() && i < children.size(); ++i) attach_tree(def.children[i], children[i], call);
}

// Runs `work`, which may call into Lua, protected; Errors are reported like a script's.
void Script::guarded(const std::function<void()>& work) {
  lua_pushlightuserdata(L_, const_cast<std::function<void()>*>(&work));
  lua_pushcclosure(L_, [](lua_State* L) -> int {
    return at_border(L, [L] {
      (*static_cast<const std::function<void()>*>(lua_touserdata(L, lua_upvalueindex(1))))();
      return 0;
    });
  }, 1);
  const Phase outer = phase_;
  phase_ = Phase::run;
  protected_call_on(L_, 0, 0);
  phase_ = outer;
}

// What the engine finds wrong with a scene names a node; the file is ours to add.
static NodeId load_or_name_file(Engine& engine, const NodeDef& def, const std::string& path) {
  try {
    return engine.load(def, path);
  } catch (const Error& error) {
    fail(path, ".json: ", error.what());
  }
}

void Script::open_scene_quietly(const std::string& path) {
  guarded([&] {
    const NodeDef def = load_scene_file(path, host_.read, "scene.load");
    const NodeId root = load_or_name_file(live_, def, path);
    for (const NodeId gone : live_.finish_removals()) forget_node(gone);
    loaded_behaviours_.clear();
    loaded_def_ = def;
    attach_tree(def, root, "scene.load");
    for (const auto& [node, behaviours] : loaded_behaviours_) attach_behaviours(node, behaviours, path);
  });
  lists_changed_ = scene_went_ = true;
}

void Script::open_scene(const std::string& path) {
  open_scene_quietly(path);
  announce_scene(path);
}

void Script::announce_scene(const std::string& name) {
  lists_changed_ = true;
  call_boot("start_new", 0, 0, Phase::run);
  lua_pushlstring(L_, name.data(), name.size());
  call_boot("scene_started", 1, 0, Phase::run);
}

void Script::restart_scene_now() {
  live_.restart_scene();
  scene_went_ = true;
  for (const NodeId gone : live_.finish_removals()) forget_node(gone);
  live_.take_events();
  auto restart = [&](NodeId node, const Value& behaviours) {
    if (!live_.scene.get(node)) return;
    push_node(node);
    push_value(L_, behaviours);
    call_boot("restart_node", 2, 0, Phase::run);
  };
  for (const DeclaredNode& node : declared_.nodes) restart(node.handle, node.behaviours);
  for (const auto& [node, behaviours] : loaded_behaviours_) restart(node, behaviours);
  announce_scene(live_.scene_name);
}

}  // namespace tumble
