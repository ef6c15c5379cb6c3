#include "script/types.h"

#include <cmath>

#include "base/text.h"
#include "script/bind.h"
#include "script/script.h"

namespace tumble {

const char* tag_name(Tag tag) {
  static const char* const names[] = {"vec3",   "quat",  "color",  "node", "joint",  "body",     "mesh",   "material",
                                      "light",  "camera", "sky", "sound", "particles", "animation", "table", "list of children", "hit", "filter", "property", "voice", "sound groups"};
  return tag == Tag::end ? "userdata" : names[tag_index(tag)];
}

std::string describe_argument(lua_State* L, int index) {
  switch (lua_type(L, index)) {
    case LUA_TNONE:
    case LUA_TNIL: return "nil";
    case LUA_TBOOLEAN: return lua_toboolean(L, index) ? "true" : "false";
    case LUA_TNUMBER: return "the number " + (lua_isinteger(L, index) ? std::to_string(lua_tointeger(L, index)) : number_text(lua_tonumber(L, index)));
    case LUA_TSTRING: {
      std::string text = lua_tostring(L, index);
      if (text.size() > 40) text = text.substr(0, 37) + "...";
      return '"' + text + '"';
    }
    case LUA_TUSERDATA: return script_of(L).object_text(index);
    default: return std::string("a ") + luaL_typename(L, index);
  }
}

void Arguments::bad(const std::string& expected) const {
  if (number <= 0 && row.method)
    fail(row.full_name(), ": ", row.area, " expected before the colon, got ", describe_argument(L, index),
         "; was it called with a dot? Write ", row.area, ":", row.name, "(...)");
  wrong(expected + " expected, got " + describe_argument(L, index));
}

void Arguments::wrong(const std::string& text) const {
  const auto at = static_cast<std::size_t>(number) - 1;
  if (row.kind == Row::Kind::property) fail(row.area, ".", row.name, ": ", text);
  if (at < row.params.size()) fail(row.full_name(), ": argument ", number, " (", row.params[at].name, "): ", text);
  fail(row.full_name(), ": ", text);
}

void Arguments::surplus() const {
  fail(row.full_name(), ": takes ", number, number == 1 ? " argument" : " arguments", ", got ", describe_argument(L, index), " beside", number ? " them" : "");
}

void Arguments::not_finite(int at) const {
  Arguments here = *this;
  here.index = at;
  if (lua_type(L, at) != LUA_TNUMBER) here.bad("number");
  here.wrong("a finite number expected, got " + number_text(lua_tonumber(L, at)));
}
void Arguments::not_finite(Vec3 v) const { wrong("finite numbers expected, got " + text(Value(v))); }
void Arguments::dead(NodeId node) const { fail(row.full_name(), ": ", script.dead_node_text(node)); }

namespace {

// Reads one plain userdata or fails with its name.
template <class T>
T& expect_object(Arguments& a, Tag tag, const char* expected) {
  ++a.number;
  T* object = object_at<T>(a.L, a.index, tag);
  if (!object) a.bad(expected);
  ++a.index;
  return *object;
}

template <class T, class R>
R self_component(Arguments& a, Tag low, Tag high, const char* name) {
  ++a.number;
  const Tag tag = tag_at(a.L, a.index);
  if (tag < low || tag > high) a.bad(name);
  const NodeId node = static_cast<Object<ComponentData>*>(lua_touserdata(a.L, a.index))->value.node;
  if (!a.script.engine().scene.get(node)) fail(a.row.full_name(), ": ", a.script.dead_node_text(node));
  ++a.index;
  return R{node};
}

}  // namespace

bool LuaType<bool>::read(Arguments& a) {
  ++a.number;
  if (!lua_isboolean(a.L, a.index)) a.bad("boolean");
  return lua_toboolean(a.L, a.index++);
}
int LuaType<bool>::push(lua_State* L, const bool& v) { return lua_pushboolean(L, v), 1; }

int LuaType<double>::push(lua_State* L, const double& v) { return lua_pushnumber(L, v), 1; }

std::int64_t LuaType<std::int64_t>::read(Arguments& a) {
  ++a.number;
  int is_integer = 0;
  const lua_Integer value = lua_tointegerx(a.L, a.index, &is_integer);
  if (lua_type(a.L, a.index) != LUA_TNUMBER || !is_integer) a.bad("integer");
  ++a.index;
  return value;
}
int LuaType<std::int64_t>::push(lua_State* L, const std::int64_t& v) { return lua_pushinteger(L, v), 1; }

int LuaType<int>::read(Arguments& a) { return static_cast<int>(LuaType<std::int64_t>::read(a)); }
int LuaType<int>::push(lua_State* L, const int& v) { return lua_pushinteger(L, v), 1; }

std::string LuaType<std::string>::read(Arguments& a) {
  ++a.number;
  if (lua_type(a.L, a.index) != LUA_TSTRING) a.bad("string");
  std::size_t size = 0;
  const char* text = lua_tolstring(a.L, a.index++, &size);
  return {text, size};
}
int LuaType<std::string>::push(lua_State* L, const std::string& v) { return lua_pushlstring(L, v.data(), v.size()), 1; }

int LuaType<Vec3>::push(lua_State* L, const Vec3& v) { return push_vec3(L, v), 1; }

Quat LuaType<Quat>::read(Arguments& a) { return expect_object<Quat>(a, Tag::quat, "quat"); }
int LuaType<Quat>::push(lua_State* L, const Quat& v) { return push_object(L, Tag::quat, v), 1; }

Color LuaType<Color>::read(Arguments& a) {
  ++a.number;
  if (const Color* color = object_at<Color>(a.L, a.index, Tag::color)) {
    ++a.index;
    return *color;
  }
  if (lua_type(a.L, a.index) != LUA_TSTRING) a.bad("color");
  const char* text = lua_tostring(a.L, a.index);
  const auto color = parse_color(text);
  if (!color) a.wrong("unknown color '" + std::string(text) + "'" + did_you_mean(text, color_names()));
  ++a.index;
  return *color;
}
int LuaType<Color>::push(lua_State* L, const Color& v) { return push_object(L, Tag::color, v), 1; }

int LuaType<NodeRef>::push(lua_State* L, const NodeRef& v) { return script_of(L).push_node(v.id), 1; }

AnyNode LuaType<AnyNode>::read(Arguments& a) { return {expect_object<NodeId>(a, Tag::node, "node")}; }
int LuaType<AnyNode>::push(lua_State* L, const AnyNode& v) { return script_of(L).push_node(v.id), 1; }

JointArg LuaType<JointArg>::read(Arguments& a) {
  const JointRef id = expect_object<JointRef>(a, Tag::joint, "joint");
  if (!a.script.engine().joint(id)) fail(a.row.full_name(), ": this joint was destroyed; keep no joint longer than its bodies");
  return {id};
}
int LuaType<JointArg>::push(lua_State* L, const JointArg& v) { return script_of(L).push_joint(v.id), 1; }

BodyRef LuaType<BodyRef>::read(Arguments& a) {
  const BodyRef body = self_component<NodeId, BodyRef>(a, Tag::body, Tag::body, "body");
  if (!a.script.engine().body(body.node))
    fail(a.row.full_name(), ": node '", a.script.engine().scene[body.node].name, "' has no body any more");
  return body;
}
int LuaType<BodyRef>::push(lua_State* L, const BodyRef& v) { return script_of(L).push_component(v.node, Tag::body), 1; }

ComponentRef LuaType<ComponentRef>::read(Arguments& a) {
  return self_component<NodeId, ComponentRef>(a, Tag::mesh, Tag::animation, "component");
}
int LuaType<ComponentRef>::push(lua_State* L, const ComponentRef& v) { return script_of(L).push_component(v.node, Tag::mesh), 1; }

HitRef LuaType<HitRef>::read(Arguments& a) {
  ++a.number;
  if (tag_at(a.L, a.index) != Tag::hit) a.bad("hit");
  return {hit_at(a.L, a.index++)};
}
int LuaType<HitRef>::push(lua_State* L, const HitRef& v) { return push_hit(L, *v.hit), 1; }

VoiceRef LuaType<VoiceRef>::read(Arguments& a) { return {&expect_object<VoiceData>(a, Tag::voice, "voice")}; }
int LuaType<VoiceRef>::push(lua_State* L, const VoiceRef& v) { return push_object(L, Tag::voice, *v.voice), 1; }

Function LuaType<Function>::read(Arguments& a) {
  ++a.number;
  if (!lua_isfunction(a.L, a.index)) a.bad("function");
  return {a.index++};
}
int LuaType<Function>::push(lua_State* L, const Function& v) { return lua_pushvalue(L, v.index), 1; }

Rest LuaType<Rest>::read(Arguments& a) {
  const Rest rest{a.index, std::max(0, lua_gettop(a.L) - a.index + 1)};
  a.index += rest.count;
  return rest;
}
int LuaType<Rest>::push(lua_State*, const Rest&) { return 0; }

Results LuaType<Results>::read(Arguments&) { return {}; }
int LuaType<Results>::push(lua_State*, const Results& v) { return v.count; }

Anything LuaType<Anything>::read(Arguments& a) {
  ++a.number;
  if (lua_isnone(a.L, a.index)) lua_pushnil(a.L);
  return {a.index++};
}
int LuaType<Anything>::push(lua_State* L, const Anything& v) { return lua_pushvalue(L, v.index), 1; }

Value LuaType<Value>::read(Arguments& a) {
  ++a.number;
  if (lua_isnone(a.L, a.index)) a.bad("value");
  return value_from_lua(a.L, a.index++, a.row.full_name());
}
int LuaType<Value>::push(lua_State* L, const Value& v) { return push_value(L, v), 1; }

Shape LuaType<Shape>::read(Arguments& a) {
  const Value value = LuaType<Value>::read(a);
  Shape shape;
  assign(shape, value, a.row.full_name() + ": shape");
  return shape;
}
int LuaType<Shape>::push(lua_State* L, const Shape& v) { return push_value(L, to_value(v)), 1; }

}  // namespace tumble
