// How C++ types are read from and pushed to Lua: LuaType<T>::read, push, name.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "base/error.h"
#include "base/value.h"
#include "physics/query.h"
#include "script/objects.h"
#include "script/param.h"
#include "script/script.h"

namespace tumble {

struct Row;

inline Script& script_of(lua_State* L) { return **static_cast<Script**>(lua_getextraspace(L)); }

// A cursor over what Lua passed to a bound function.
struct Arguments {
  lua_State* L;
  Script& script;
  const Row& row;
  int index = 1;    // on the stack
  int number = 0;   // as the reader counts, self not counted

  // Throws "node:translate: argument 1 (offset): vec3 expected, got nil".
  [[noreturn]] void bad(const std::string& expected) const;
  // Throws with a free text after the argument's name.
  [[noreturn]] void wrong(const std::string& text) const;
  bool absent() const { return lua_isnoneornil(L, index); }
  // Throws where there are more arguments than the function takes.
  void check_end() const;
  double finite(int at) const;   // the number there, which must be one and finite
  [[noreturn]] void surplus() const;
  [[noreturn]] void not_finite(int at) const;
  [[noreturn]] void not_finite(Vec3 v) const;
  [[noreturn]] void dead(NodeId node) const;
};

// "nil", "a number", "node 'ball'", "\"text\"": what an argument is, for messages.
std::string describe_argument(lua_State* L, int index);

template <class T>
struct LuaType;

// ---- arguments that are not plain values
struct NodeRef { NodeId id; };            // a living node
struct AnyNode { NodeId id; };            // a node, dead or alive
struct JointArg { JointRef id; };         // a joint that is still there
struct BodyRef { NodeId node; };          // the body of a living node that has one
struct ComponentRef { NodeId node; };     // mesh, light, sky ... of a living node
struct VoiceRef { VoiceData* voice; };    // a sound that plays or has played
struct HitRef { struct HitData* hit; };
struct Function { int index = 0; };       // a Lua function on the stack
struct Rest { int first = 0, count = 0; };// whatever follows
struct Anything { int index = 0; };       // any value on the stack, nil included

#define TUMBLE_LUA_TYPE(T, NAME)                 \
  template <>                                    \
  struct LuaType<T> {                            \
    static constexpr bool optional = false;      \
    static std::string name() { return NAME; }   \
    static T read(Arguments& a);                 \
    static int push(lua_State* L, const T& v);   \
  }
TUMBLE_LUA_TYPE(bool, "boolean");
TUMBLE_LUA_TYPE(double, "number");
TUMBLE_LUA_TYPE(int, "integer");
TUMBLE_LUA_TYPE(std::int64_t, "integer");
TUMBLE_LUA_TYPE(std::string, "string");
TUMBLE_LUA_TYPE(Vec3, "vec3");
TUMBLE_LUA_TYPE(Quat, "quat");
TUMBLE_LUA_TYPE(Color, "color");
TUMBLE_LUA_TYPE(NodeRef, "node");
TUMBLE_LUA_TYPE(AnyNode, "node");
TUMBLE_LUA_TYPE(JointArg, "joint");
TUMBLE_LUA_TYPE(BodyRef, "body");
TUMBLE_LUA_TYPE(ComponentRef, "component");
TUMBLE_LUA_TYPE(VoiceRef, "voice");
TUMBLE_LUA_TYPE(HitRef, "hit");
TUMBLE_LUA_TYPE(Function, "function");
TUMBLE_LUA_TYPE(Rest, "...");
TUMBLE_LUA_TYPE(Results, "");
TUMBLE_LUA_TYPE(Anything, "any");
TUMBLE_LUA_TYPE(Value, "any");
TUMBLE_LUA_TYPE(Shape, "shape");
TUMBLE_LUA_TYPE(QueryFilter, "filter");
#undef TUMBLE_LUA_TYPE

template <class T>
struct LuaType<std::optional<T>> {
  static constexpr bool optional = true;
  static std::string name() { return LuaType<T>::name(); }
  static std::optional<T> read(Arguments& a) {
    if (a.absent()) {
      ++a.index;
      ++a.number;
      return std::nullopt;
    }
    return LuaType<T>::read(a);
  }
  static int push(lua_State* L, const std::optional<T>& v) {
    if (v) return LuaType<T>::push(L, *v);
    lua_pushnil(L);
    return 1;
  }
};

template <class T>
struct LuaType<std::vector<T>> {
  static constexpr bool optional = false;
  static std::string name() { return "list of " + LuaType<T>::name(); }
  static int push(lua_State* L, const std::vector<T>& list) {
    lua_createtable(L, static_cast<int>(list.size()), 0);
    for (std::size_t i = 0; i < list.size(); ++i) {
      LuaType<T>::push(L, list[i]);
      lua_rawseti(L, -2, static_cast<lua_Integer>(i) + 1);
    }
    return 1;
  }
};

template <class... T>
struct LuaType<std::tuple<T...>> {
  static constexpr bool optional = false;
  static std::string name() {
    std::string text;
    ((text += (text.empty() ? "" : ", ") + LuaType<T>::name()), ...);
    return text;
  }
  static int push(lua_State* L, const std::tuple<T...>& values) {
    int count = 0;
    std::apply([&](const T&... v) { ((count += LuaType<T>::push(L, v)), ...); }, values);
    return count;
  }
};

// ---- what hot calls go through, here so that it can be inlined; bind.h has check_end
inline double Arguments::finite(int at) const {
  if (lua_type(L, at) != LUA_TNUMBER) not_finite(at);
  const double value = lua_tonumber(L, at);
  if (!std::isfinite(value)) not_finite(at);
  return value;
}
inline double LuaType<double>::read(Arguments& a) {
  ++a.number;
  return a.finite(a.index++);
}
// A vec3, or three numbers in its place.
inline Vec3 LuaType<Vec3>::read(Arguments& a) {
  ++a.number;
  if (const Vec3* v = vec3_at(a.L, a.index)) {
    if (!is_finite(*v)) a.not_finite(*v);
    ++a.index;
    return *v;
  }
  if (lua_type(a.L, a.index) != LUA_TNUMBER) a.bad("vec3");
  const Vec3 v{a.finite(a.index), a.finite(a.index + 1), a.finite(a.index + 2)};
  a.index += 3;
  return v;
}
inline NodeRef LuaType<NodeRef>::read(Arguments& a) {
  ++a.number;
  const NodeId* id = object_at<NodeId>(a.L, a.index, Tag::node);
  if (!id) a.bad("node");
  if (!a.script.engine().scene.get(*id)) a.dead(*id);
  ++a.index;
  return {*id};
}

// ---- Value and Lua
// Tables become lists (keys 1..n) or maps (string keys, sorted by name); nodes and joints References. Throws Error
// beginning with `where` for functions, cycles, mixed keys and the like.
Value value_from_lua(lua_State* L, int index, const std::string& where);
void push_value(lua_State* L, const Value& value);

}  // namespace tumble
