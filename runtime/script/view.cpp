#include "script/view.h"

#include <algorithm>
#include <cstdlib>

#include "base/text.h"
#include "script/dispatch.h"
#include "script/script.h"

namespace tumble {

namespace {

NodeId node_of_component(lua_State* L, int index = 1) { return static_cast<Object<ComponentData>*>(lua_touserdata(L, index))->value.node; }

// The component of a living node as a Value; the area's name is the component's.
Value component_value(Script& script, NodeId node, const std::string& component) {
  Engine& engine = script.engine();
  const SceneNode* n = engine.scene.get(node);
  if (!n) fail(component, ": ", script.dead_node_text(node));
  if (component == "body") {
    if (!engine.body(node)) fail("node '", n->name, "' has no body any more");
    return to_value(engine.body_def(node));
  }
  if (component == "mesh" && n->mesh) return to_value(*n->mesh);
  if (component == "material") return to_value(n->material.value_or(Material{}));
  if (component == "light" && n->light) return to_value(*n->light);
  if (component == "camera" && n->camera) return to_value(*n->camera);
  if (component == "sky" && n->sky) return to_value(*n->sky);
  if (component == "sound" && n->sound) return to_value(*n->sound);
  if (component == "particles" && n->particles) return to_value(*n->particles);
  if (component == "animation" && n->animation) return to_value(*n->animation);
  fail("node '", n->name, "' has no ", component, " any more");
}

const void* component_object(Script& script, NodeId node, const std::string& component, BodyDef& body) {
  Engine& engine = script.engine();
  const SceneNode* n = engine.scene.get(node);
  if (!n) fail(component, ": ", script.dead_node_text(node));
  static const Material plain;
  if (component == "body" && engine.body(node)) return &(body = engine.body_def(node));
  if (component == "mesh" && n->mesh) return &*n->mesh;
  if (component == "material") return n->material ? &*n->material : &plain;
  if (component == "light" && n->light) return &*n->light;
  if (component == "camera" && n->camera) return &*n->camera;
  if (component == "sky" && n->sky) return &*n->sky;
  if (component == "sound" && n->sound) return &*n->sound;
  if (component == "particles" && n->particles) return &*n->particles;
  if (component == "animation" && n->animation) return &*n->animation;
  fail("node '", n->name, "' has no ", component, " any more");
}

// Pushes a described value: tables as views, so that writing into them reaches the component.
void push_field(lua_State* L, Reference root, const std::string& path, const Value& value) {
  if (!value.is<Map>() && !value.is<List>()) return push_value(L, value);
  push_object(L, Tag::view, ViewData{root}, 1);
  lua_pushlstring(L, path.data(), path.size());
  lua_setiuservalue(L, -2, 1);
}

struct View {
  Reference root;
  std::string path;
};
View view_at(lua_State* L, int index = 1) {
  const Reference root = static_cast<Object<ViewData>*>(lua_touserdata(L, index))->value.root;
  lua_getiuservalue(L, index, 1);
  View view{root, lua_tostring(L, -1)};
  lua_pop(L, 1);
  return view;
}

// Entry `step` of a list (counted from 1) or a map.
const Value* descend(const Value& value, const std::string& step) {
  if (const List* list = value.get<List>()) {
    const std::size_t i = std::strtoul(step.c_str(), nullptr, 10);
    return i >= 1 && i <= list->size() ? &(*list)[i - 1] : nullptr;
  }
  return value.find(step);
}

std::vector<std::string> steps(const std::string& path) {
  std::vector<std::string> list;
  std::size_t begin = 0;
  for (std::size_t dot; (dot = path.find('.', begin)) != std::string::npos; begin = dot + 1) list.push_back(path.substr(begin, dot - begin));
  list.push_back(path.substr(begin));
  return list;
}

// The whole component or joint that the view hangs in, as a Value, and the path below it.
Value root_value(Script& script, const View& view, std::vector<std::string>& below) {
  below = steps(view.path);
  if (view.root.kind == Reference::Kind::joint) {
    JointRecord* joint = script.engine().joint({view.root.index, view.root.generation});
    if (!joint) fail(view.path, ": this joint was destroyed");
    Value options = joint->options;
    // A freedom is there, be it that no option of it was given.
    if (!options.find(below.front()) && script.is_freedom(*joint, below.front())) options[below.front()] = Map{};
    return options;
  }
  const std::string component = below.front();
  below.erase(below.begin());
  return component_value(script, {view.root.index, view.root.generation}, component);
}

std::string key_of(lua_State* L, int index) {
  if (lua_isinteger(L, index)) return std::to_string(lua_tointeger(L, index));
  if (lua_type(L, index) == LUA_TSTRING) return lua_tostring(L, index);
  fail("a name expected in [ ], got ", describe_argument(L, index));
}

// A joint's or component's `x_degrees` beside `x`.
const Value* find_or_twin(const Value& map, const std::string& key, Value& made) {
  if (const Value* value = descend(map, key)) return value;
  constexpr std::string_view tail = "_degrees";
  if (key.ends_with(tail)) {
    const Value* base = descend(map, key.substr(0, key.size() - tail.size()));
    if (base && base->is_number()) return &(made = degrees(base->number()));
  } else if (const Value* twin = descend(map, key + std::string(tail))) {
    if (twin->is_number()) return &(made = radians(twin->number()));
  }
  return nullptr;
}

Value view_value(Script& script, const View& view) {
  std::vector<std::string> below;
  const Value value = root_value(script, view, below);
  const Value* at = &value;
  for (const std::string& step : below)
    if (!(at = descend(*at, step))) fail(view.path, " is no longer there");
  return *at;
}

int index_view(lua_State* L) {
  const View view = view_at(L);
  const Value value = view_value(script_of(L), view);
  Value made;
  const std::string key = key_of(L, 2);
  if (view.root.kind == Reference::Kind::joint)
    if (const auto state = script_of(L).freedom_state({view.root.index, view.root.generation}, view.path, key))
      return lua_pushnumber(L, *state), 1;
  const Value* entry = find_or_twin(value, key, made);
  if (!entry) return lua_pushnil(L), 1;
  push_field(L, view.root, view.path + "." + key, *entry);
  return 1;
}

int length_of_view(lua_State* L) {
  return at_border(L, [L] {
    const Value value = view_value(script_of(L), view_at(L));
    const List* list = value.get<List>();
    return lua_pushinteger(L, list ? static_cast<lua_Integer>(list->size()) : 0), 1;
  });
}

// Writes entry `key` of the value below, making maps on the way.
void write_below(Value& value, const std::vector<std::string>& below, std::size_t depth, const Value& content) {
  if (depth == below.size()) {
    value = content;
    return;
  }
  if (List* list = value.get<List>()) {
    const std::size_t i = std::strtoul(below[depth].c_str(), nullptr, 10);
    if (i < 1 || i > list->size()) fail("entry ", below[depth], " of a list of ", list->size(), " cannot be written");
    return write_below((*list)[i - 1], below, depth + 1, content);
  }
  write_below(value[below[depth]], below, depth + 1, content);
}

void check_write(Script& script, const std::string& name) {
  if (script.phase() == Phase::frame) fail(name, ": frame only draws; change things in update or late_update");
  if (script.phase() == Phase::watch) fail(name, ": a bot may read everything but change only its input");
}

int newindex_view(lua_State* L) {
  Script& script = script_of(L);
  const View view = view_at(L);
  const std::string key = key_of(L, 2);
  check_write(script, view.path + "." + key);
  const Value content = value_from_lua(L, 3, view.path + "." + key);
  if (view.root.kind == Reference::Kind::joint) {
    if (script.freedom_state({view.root.index, view.root.generation}, view.path, key))
      fail("joint.", view.path, ".", key, " can only be read; lead it there by joint.", view.path, ".motor");
    script.engine().set_joint_field({view.root.index, view.root.generation}, view.path + "." + key, content, "joint");
    return 0;
  }
  std::vector<std::string> below;
  Value value = root_value(script, view, below);
  below.push_back(key);
  write_below(value, below, 0, content);
  script.engine().set_field({view.root.index, view.root.generation}, steps(view.path).front(), value, view.path + "." + key);
  return 0;
}

int index_joint(lua_State* L, const Area& area) {
  Script& script = script_of(L);
  const JointRef id = *object_at<JointRef>(L, 1, Tag::joint);
  const std::string key = key_of(L, 2);
  JointRecord* joint = script.engine().joint(id);
  if (!joint) fail("joint.", key, ": this joint was destroyed");
  Value made;
  if (script.is_freedom(*joint, key)) {
    push_field(L, {Reference::Kind::joint, id.index, id.generation}, key, Map{});
    return 1;
  }
  if (const Value* entry = find_or_twin(joint->options, key, made)) {
    push_field(L, {Reference::Kind::joint, id.index, id.generation}, key, *entry);
    return 1;
  }
  if (script.joint_has_option(joint->type, key)) return lua_pushnil(L), 1;
  fail_unknown(L, area, script.object_text(1), key);
}

int newindex_joint(lua_State* L) {
  Script& script = script_of(L);
  const std::string key = key_of(L, 2);
  check_write(script, "joint." + key);
  JointRecord* joint = script.engine().joint(*object_at<JointRef>(L, 1, Tag::joint));
  if (!joint) fail("joint.", key, ": this joint was destroyed");
  script.engine().set_joint_field(*object_at<JointRef>(L, 1, Tag::joint), key, value_from_lua(L, 3, "joint." + key), "joint." + joint->type);
  return 0;
}

int newindex_value(lua_State* L) {
  const Tag tag = tag_at(L, 1);
  const std::string key = key_of(L, 2);
  const std::string kind = tag_name(tag);
  if (tag == Tag::vec3 && key.size() == 1 && key >= "x" && key <= "z")
    fail("vec3 values do not change; write node.position = node.position:with_", key, "(", lua_isnumber(L, 3) ? luaL_tolstring(L, 3, nullptr) : "...", ")");
  fail(kind, " values do not change; make a new one");
}

}  // namespace

std::optional<Value> described_value(lua_State* L, int index) {
  const Tag tag = tag_at(L, index);
  if (tag == Tag::view) return view_value(script_of(L), view_at(L, index));
  if (tag >= Tag::body && tag <= Tag::animation) return component_value(script_of(L), node_of_component(L, index), tag_name(tag));
  return std::nullopt;
}

int index_described(lua_State* L, const Area& area) {
  Script& script = script_of(L);
  const Tag tag = tag_at(L, 1);
  if (tag == Tag::view) return index_view(L);
  if (tag == Tag::joint) return index_joint(L, area);
  const std::string key = key_of(L, 2);
  if (tag >= Tag::body && tag <= Tag::animation) {
    BodyDef body;
    const NodeId node = node_of_component(L);
    const void* object = component_object(script, node, area.name, body);
    if (const auto value = field_value(*area.described, object, key)) {
      push_field(L, {Reference::Kind::node, node.index, node.generation}, area.name + "." + key, *value);
      return 1;
    }
  }
  if (tag == Tag::node && script.push_slot(1, key)) return 1;
  fail_unknown(L, area, script.object_text(1), key);
}

int newindex_described(lua_State* L, const Area& area) {
  Script& script = script_of(L);
  const Tag tag = tag_at(L, 1);
  if (tag == Tag::view) return newindex_view(L);
  if (tag == Tag::joint) return newindex_joint(L);
  if (tag == Tag::vec3 || tag == Tag::quat || tag == Tag::color) return newindex_value(L);
  const std::string key = key_of(L, 2);
  if (tag >= Tag::body && tag <= Tag::animation) {
    check_write(script, area.name + "." + key);
    const std::vector<std::string> names = area.described->field_names();
    if (std::find(names.begin(), names.end(), key) == names.end()) fail_unknown(L, area, area.name, key);
    script.engine().set_field(node_of_component(L), area.name + "." + key, value_from_lua(L, 3, area.name + "." + key), area.name);
    return 0;
  }
  if (tag == Tag::node) {
    check_write(script, "node." + key);
    if (script.set_slot(1, key, 3)) return 0;
  }
  fail_unknown(L, area, script.object_text(1), key);
}

void open_views(lua_State* L) {
  push_metatable(L, Tag::view);
  lua_pushcfunction(L, length_of_view);
  lua_setfield(L, -2, "__len");
  lua_pop(L, 1);
}

}  // namespace tumble
