// vec3, quat and color: rows, constructors and operators.
#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "script/areas.h"
#include "script/script.h"
#include "script/view.h"

namespace tumble {

namespace {

double x(Script&, Vec3 v) { return v.x; }
double y(Script&, Vec3 v) { return v.y; }
double z(Script&, Vec3 v) { return v.z; }
double vec3_length(Script&, Vec3 v) { return length(v); }
double vec3_distance(Script&, Vec3 v, Vec3 w) { return distance(v, w); }
double vec3_dot(Script&, Vec3 v, Vec3 w) { return dot(v, w); }
Vec3 vec3_cross(Script&, Vec3 v, Vec3 w) { return cross(v, w); }
Vec3 vec3_normalized(Script&, Vec3 v) { return normalized(v); }
Vec3 vec3_clamped(Script&, Vec3 v, double max) {
  const double l = length(v);
  return l > max ? v * (max / l) : v;
}
Vec3 vec3_lerp(Script&, Vec3 v, Vec3 w, double t) { return lerp(v, w, t); }
Vec3 with_x(Script&, Vec3 v, double n) { return {n, v.y, v.z}; }
Vec3 with_y(Script&, Vec3 v, double n) { return {v.x, n, v.z}; }
Vec3 with_z(Script&, Vec3 v, double n) { return {v.x, v.y, n}; }
Vec3 vec3_rotated(Script&, Vec3 v, Quat q) { return q * v; }
double vec3_angle(Script&, Vec3 v, Vec3 w) { return std::atan2(length(cross(v, w)), dot(v, w)); }
std::tuple<double, double, double> vec3_unpack(Script&, Vec3 v) { return {v.x, v.y, v.z}; }

double quat_x(Script&, Quat q) { return q.x; }
double quat_y(Script&, Quat q) { return q.y; }
double quat_z(Script&, Quat q) { return q.z; }
double quat_w(Script&, Quat q) { return q.w; }
Quat quat_inverse(Script&, Quat q) { return conjugate(q); }
Quat quat_slerp(Script&, Quat q, Quat r, double t) { return slerp(q, r, t); }
Vec3 quat_degrees(Script&, Quat q) {
  const Vec3 e = to_euler(q);
  return {degrees(e.x), degrees(e.y), degrees(e.z)};
}

Quat make_axis_angle(Script&, Vec3 axis, double angle) {
  if (axis == Vec3{}) fail("quat.axis_angle: axis must not be zero (got 0, 0, 0); give a direction such as vec3.up");
  return axis_angle(axis, angle);
}
Quat make_euler_degrees(Script&, double ex, double ey, double ez) { return from_euler({radians(ex), radians(ey), radians(ez)}); }
Quat make_look(Script&, Vec3 forward, std::optional<Vec3> up) {
  if (forward == Vec3{}) fail("quat.look: forward must not be zero (got 0, 0, 0); give a direction such as vec3.forward");
  return look_rotation(forward, up.value_or(Vec3{0, 1, 0}));
}
Color make_hsv(Script&, double h, double s, double v) { return from_hsv(h, s, v); }

double red(Script&, Color c) { return c.r; }
double green(Script&, Color c) { return c.g; }
double blue(Script&, Color c) { return c.b; }
double alpha(Script&, Color c) { return c.a; }
Color color_lerp(Script&, Color c, Color d, double t) {
  return {std::lerp(c.r, d.r, t), std::lerp(c.g, d.g, t), std::lerp(c.b, d.b, t), std::lerp(c.a, d.a, t)};
}
Color with_alpha(Script&, Color c, double a) { return {c.r, c.g, c.b, a}; }

// ---- operators

int operand_error(lua_State* L, const char* name) {
  return at_border(L, [L, name]() -> int {
    fail("vec3 ", name, ": vec3", *name == '*' || *name == '/' ? " or number" : "", " expected, got ",
         describe_argument(L, vec3_at(L, 1) ? 2 : 1));
  });
}

int vec3_add(lua_State* L) {
  const Vec3 *a = vec3_at(L, 1), *b = vec3_at(L, 2);
  if (!a || !b) return operand_error(L, "+");
  return push_vec3(L, *a + *b), 1;
}
int vec3_sub(lua_State* L) {
  const Vec3 *a = vec3_at(L, 1), *b = vec3_at(L, 2);
  if (!a || !b) return operand_error(L, "-");
  return push_vec3(L, *a - *b), 1;
}
int vec3_mul(lua_State* L) {
  const Vec3 *a = vec3_at(L, 1), *b = vec3_at(L, 2);
  if (a && b) return push_vec3(L, scaled(*a, *b)), 1;
  const int number = a ? 2 : 1;
  if (lua_type(L, number) != LUA_TNUMBER) return operand_error(L, "*");
  return push_vec3(L, (a ? *a : *b) * lua_tonumber(L, number)), 1;
}
int vec3_div(lua_State* L) {
  const Vec3 *a = vec3_at(L, 1), *b = vec3_at(L, 2);
  if (a && b) return push_vec3(L, unscaled(*a, *b)), 1;
  if (!a || lua_type(L, 2) != LUA_TNUMBER) return operand_error(L, "/");
  return push_vec3(L, *a / lua_tonumber(L, 2)), 1;
}
int vec3_unm(lua_State* L) { return push_vec3(L, -*vec3_at(L, 1)), 1; }

template <class T>
int object_equal(lua_State* L, Tag tag) {
  const T *a = object_at<T>(L, 1, tag), *b = object_at<T>(L, 2, tag);
  return lua_pushboolean(L, a && b && *a == *b), 1;
}
int vec3_equal(lua_State* L) { return object_equal<Vec3>(L, Tag::vec3); }
int quat_equal(lua_State* L) { return object_equal<Quat>(L, Tag::quat); }
int color_equal(lua_State* L) { return object_equal<Color>(L, Tag::color); }
int body_equal(lua_State* L) {
  const Tag tag = tag_at(L, 1);
  const auto *a = object_at<ComponentData>(L, 1, tag), *b = object_at<ComponentData>(L, 2, tag);
  return lua_pushboolean(L, a && b && a->node == b->node), 1;
}

int quat_mul(lua_State* L) {
  const Quat *q = object_at<Quat>(L, 1, Tag::quat), *r = object_at<Quat>(L, 2, Tag::quat);
  if (q && r) return push_object(L, Tag::quat, *q * *r), 1;
  if (const Vec3* v = vec3_at(L, 2); q && v) return push_vec3(L, *q * *v), 1;
  return at_border(L, [L, q]() -> int { fail("quat *: quat or vec3 expected, got ", describe_argument(L, q ? 2 : 1)); });
}

// The number of a constructor's argument, which must be finite.
double component(lua_State* L, int index, const char* call, const char* name, double missing) {
  if (lua_isnone(L, index)) return missing;
  if (lua_type(L, index) != LUA_TNUMBER) fail(call, ": argument ", index, " (", name, "): number expected, got ", describe_argument(L, index));
  const double value = lua_tonumber(L, index);
  if (!std::isfinite(value)) fail(call, ": argument ", index, " (", name, "): a finite number expected, got ", number_text(value));
  return value;
}

int call_vec3(lua_State* L) {
  lua_remove(L, 1);
  return at_border(L, [L] {
    if (lua_gettop(L) != 3) fail("vec3: three numbers expected, got ", lua_gettop(L), "; write vec3(x, y, z)");
    push_vec3(L, {component(L, 1, "vec3", "x", 0), component(L, 2, "vec3", "y", 0), component(L, 3, "vec3", "z", 0)});
    return 1;
  });
}

int call_quat(lua_State* L) {
  return at_border(L, []() -> int { fail("quat: it is not made of four numbers; write quat.euler_degrees(x, y, z), quat.axis_angle(axis, radians) or quat.look(forward)"); });
}

int call_color(lua_State* L) {
  lua_remove(L, 1);
  return at_border(L, [L] {
    if (lua_type(L, 1) == LUA_TSTRING) return push_object(L, Tag::color, color_or_fail(lua_tostring(L, 1), "color")), 1;
    if (lua_gettop(L) < 3) fail("color: a name, \"#rrggbb\" or three numbers from 0 to 1 expected; write color(r, g, b) or color \"orange\"");
    Color c{component(L, 1, "color", "r", 0), component(L, 2, "color", "g", 0), component(L, 3, "color", "b", 0), component(L, 4, "color", "a", 1)};
    for (const double part : {c.r, c.g, c.b, c.a})
      if (part < 0 || part > 1) fail("color: numbers from 0 to 1 expected, got ", number_text(part));
    push_object(L, Tag::color, c);
    return 1;
  });
}

void set_metamethods(lua_State* L, Tag tag, std::initializer_list<std::pair<const char*, lua_CFunction>> list) {
  push_metatable(L, tag);
  for (const auto& [name, function] : list) {
    lua_pushcfunction(L, function);
    lua_setfield(L, -2, name);
  }
  lua_pop(L, 1);
}

}  // namespace

void rows_vec3(Area& a) {
  a.prop<x>("x", "To the right, m.");
  a.prop<y>("y", "Up, m.");
  a.prop<z>("z", "Back (forward is -z), m.");
  a.method<vec3_length>("length", "Its length.");
  a.method<vec3_distance>("distance", "The distance between two points.", "v");
  a.method<vec3_dot>("dot", "The dot product.", "v");
  a.method<vec3_cross>("cross", "The cross product.", "v");
  a.method<vec3_normalized>("normalized", "The same direction with length 1; zero stays zero.");
  a.method<vec3_clamped>("clamped", "The same direction, at most this long.", "max");
  a.method<vec3_lerp>("lerp", "The point at t on the way: 0 is this, 1 is v.", "v", "t");
  a.method<with_x>("with_x", "The same with another x.", "x");
  a.method<with_y>("with_y", "The same with another y.", "y");
  a.method<with_z>("with_z", "The same with another z.", "z");
  a.method<vec3_rotated>("rotated", "Turned by a rotation; the same as q * v.", "q");
  a.method<vec3_angle>("angle", "The angle between two directions, rad.", "v");
  a.method<vec3_unpack>("unpack", "Its three numbers.");
}

void rows_quat(Area& a) {
  a.prop<quat_x>("x", "First component.");
  a.prop<quat_y>("y", "Second component.");
  a.prop<quat_z>("z", "Third component.");
  a.prop<quat_w>("w", "The scalar component.");
  a.prop<quat_degrees>("euler_degrees", "As Euler angles, turned first about y, then x, then z.");
  a.method<quat_inverse>("inverse", "The rotation back.");
  a.method<quat_slerp>("slerp", "The rotation at t on the short way: 0 is this, 1 is r.", "r", "t");
}

void rows_color(Area& a) {
  a.prop<red>("r", "Red, 0 to 1.");
  a.prop<green>("g", "Green, 0 to 1.");
  a.prop<blue>("b", "Blue, 0 to 1.");
  a.prop<alpha>("a", "Opacity, 0 to 1.");
  a.method<color_lerp>("lerp", "The colour at t on the way: 0 is this, 1 is d.", "d", "t");
  a.method<with_alpha>("with_alpha", "The same with another opacity.", "a");
}

// The three values as globals: callable, with constants and makers. `globals` is on top of the stack.
void open_value_makers(lua_State* L) {
  static Area quat_maker, color_maker;
  if (quat_maker.rows.empty()) {
    quat_maker.name = "quat";
    quat_maker.fn<make_axis_angle>("axis_angle", "A turn about an axis.", "axis", "radians");
    quat_maker.fn<make_euler_degrees>("euler_degrees", "From Euler angles, turned first about y, then x, then z.", "x", "y", "z");
    quat_maker.fn<make_look>("look", "The rotation whose forward (-z) points there.", "forward", "up");
    color_maker.name = "color";
    color_maker.fn<make_hsv>("hsv", "From hue, saturation and value, each 0 to 1.", "h", "s", "v");
  }
  auto make = [L](const char* name, auto fill, lua_CFunction call) {
    lua_newtable(L);  // proxy
    lua_newtable(L);  // metatable
    lua_newtable(L);  // content
    fill();
    lua_setfield(L, -2, "__index");
    if (call) {
      lua_pushcfunction(L, call);
      lua_setfield(L, -2, "__call");
    }
    lua_pushstring(L, name);
    lua_setfield(L, -2, "__metatable");
    lua_pushstring(L, name);
    lua_pushcclosure(L, [](lua_State* S) -> int {
      return at_border(S, [S]() -> int { fail("'", lua_tostring(S, lua_upvalueindex(1)), "' cannot be changed"); });
    }, 1);
    lua_setfield(L, -2, "__newindex");
    lua_setmetatable(L, -2);
    lua_setfield(L, -2, name);
  };
  make("vec3", [L] {
    const std::pair<const char*, Vec3> constants[] = {{"zero", {0, 0, 0}}, {"one", {1, 1, 1}},    {"up", {0, 1, 0}},      {"down", {0, -1, 0}},
                                                      {"left", {-1, 0, 0}}, {"right", {1, 0, 0}}, {"forward", {0, 0, -1}}, {"back", {0, 0, 1}}};
    for (const auto& [name, v] : constants) {
      push_vec3(L, v);
      lua_setfield(L, -2, name);
    }
  }, call_vec3);
  make("quat", [L] {
    push_object(L, Tag::quat, Quat{});
    lua_setfield(L, -2, "identity");
    for (const Row& row : quat_maker.rows) {
      lua_pushcfunction(L, row.call);
      lua_setfield(L, -2, row.name.c_str());
    }
  }, call_quat);
  make("color", [L] {
    lua_pushcfunction(L, color_maker.rows.front().call);
    lua_setfield(L, -2, "hsv");
  }, call_color);
}

void open_value_operators(lua_State* L) {
  set_metamethods(L, Tag::vec3, {{"__add", vec3_add}, {"__sub", vec3_sub}, {"__mul", vec3_mul}, {"__div", vec3_div}, {"__unm", vec3_unm}, {"__eq", vec3_equal}});
  set_metamethods(L, Tag::quat, {{"__mul", quat_mul}, {"__eq", quat_equal}});
  set_metamethods(L, Tag::color, {{"__eq", color_equal}});
  for (const Tag tag : {Tag::body, Tag::mesh, Tag::material, Tag::light, Tag::camera, Tag::sky, Tag::sound, Tag::particles, Tag::animation}) set_metamethods(L, tag, {{"__eq", body_equal}});
}

}  // namespace tumble
