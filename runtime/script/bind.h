// Rows: how C++ functions become Lua's, with names, documents and worded errors from one place.
//
//   area.fn<&raycast>("raycast", "First body that the ray hits, or nil.", "origin", "direction", "length", "filter");
//
// Types come from the C++ signature through LuaType<T>; a missing or surplus parameter name does not compile. A bound
// function takes Script& first, then (a method or property) its self, then what Lua passes.
#pragma once

#include <deque>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

#include "script/param.h"
#include "script/types.h"

namespace tumble {

// When a row may be used. At the top level of a file things are declared, and frame() only draws.
enum class Permit {
  always,     // reads what is there
  write,      // sets or makes something: not in frame()
  act,        // does something: not in frame(), not at the top level
  query,      // asks the running world: not at the top level
};

struct Row {
  enum class Kind { function, property, event };
  Kind kind = Kind::function;
  std::string area, name, doc;
  std::vector<Param> params;
  std::string returns;          // "" is nothing
  lua_CFunction call = nullptr; // function
  lua_CFunction get = nullptr, set = nullptr;
  Permit permit = Permit::always;
  bool method = false;
  bool scripted = false;        // a function that boot.lua provides

  Row& acts() { permit = Permit::act; return *this; }
  Row& writes() { permit = Permit::write; return *this; }
  Row& queries() { permit = Permit::query; return *this; }
  Row& gives(std::string text) { returns = std::move(text); return *this; }
  Row& takes(std::size_t parameter, std::string type) { params[parameter].type = std::move(type); return *this; }
  // "node:translate" or "scene.add".
  std::string full_name() const { return area.empty() ? name : area + (method && kind == Kind::function ? ":" : ".") + name; }
};

// A module ("scene") or a kind of object ("node") with its rows, and the described struct behind it, if any.
struct Area {
  std::string name, doc;
  bool object = false;
  std::deque<Row> rows;         // a deque: rows keep their addresses
  const Type* described = nullptr;

  const Row* find(std::string_view name) const;
  std::vector<std::string> names() const;  // of rows and described fields

  template <auto F, class... Names>
  Row& fn(const char* name, const char* doc, Names... names);
  template <auto F, class... Names>
  Row& method(const char* name, const char* doc, Names... names);
  template <auto Get, auto Set = nullptr>
  Row& prop(const char* name, const char* doc);
  // Something that scripts define and the engine calls.
  Row& event(const char* name, const char* doc, std::vector<Param> params);
  // A function that scripts/boot provides.
  Row& scripted(const char* name, const char* doc, std::vector<Param> params, const char* returns = "");
  // A function written against Lua itself, where types say too little.
  Row& raw(const char* name, const char* doc, lua_CFunction call, std::vector<Param> params, const char* returns);
};

// Every area, in the order of the documents. Built at first use.
const std::vector<Area*>& all_areas();
Area& area(const char* name);

// A module that another one holds: "input.pointer".
void push_inner_module(lua_State* L, const char* name);

// Throws what a row must not do now: "apply_impulse at the top level ... put it in start()".
void check_permit(Script& script, const Row& row);
// Runs `body`; tumble::Error and std::exception become Lua errors with the place in the script. The only such border.
[[noreturn]] void raise(lua_State* L);  // with the message on top of the stack
template <class Body>
int at_border(lua_State* L, Body&& body) {
  try {
    return body();
  } catch (const Error& error) {
    lua_pushstring(L, error.what());
  } catch (const std::exception& error) {
    lua_pushfstring(L, "Tumble failed inside: %s", error.what());
  }
  raise(L);
}

inline void Arguments::check_end() const {
  if (lua_gettop(L) >= index && row.kind != Row::Kind::property) surplus();
}

namespace detail {

template <auto F>
struct Bound;  // remembers the row of a bound function
template <class R, class... Args, R (*F)(Script&, Args...)>
struct Bound<F> {
  static inline const Row* row = nullptr;
  static constexpr std::size_t count = sizeof...(Args);

  static int call(lua_State* L) {
    return at_border(L, [L]() -> int {
      Script& script = script_of(L);
      if (row->permit != Permit::always && script.phase() != Phase::run) check_permit(script, *row);
      Arguments arguments{L, script, *row, 1, row->method ? -1 : 0};
      // Braces evaluate from left to right, which a call's arguments need not.
      std::tuple<std::decay_t<Args>...> read{LuaType<std::decay_t<Args>>::read(arguments)...};
      if constexpr (!(std::is_same_v<std::decay_t<Args>, Rest> || ...)) arguments.check_end();
      if constexpr (std::is_void_v<R>) {
        std::apply([&](auto&... a) { F(script, a...); }, read);
        return 0;
      } else {
        return LuaType<std::decay_t<R>>::push(L, std::apply([&](auto&... a) { return F(script, a...); }, read));
      }
    });
  }
  static std::vector<Param> params(const std::vector<const char*>& names, bool method) {
    std::vector<Param> list{Param{"", LuaType<std::decay_t<Args>>::name(), LuaType<std::decay_t<Args>>::optional}...};
    if (method) list.erase(list.begin());
    for (std::size_t i = 0; i < names.size(); ++i) list[i].name = names[i];
    return list;
  }
  static std::string returns() {
    if constexpr (std::is_void_v<R>) return "";
    else return LuaType<std::decay_t<R>>::name() + (LuaType<std::decay_t<R>>::optional ? " or nil" : "");
  }
};

}  // namespace detail

template <auto F, class... Names>
Row& Area::fn(const char* name, const char* doc, Names... names) {
  using B = detail::Bound<F>;
  static_assert(sizeof...(Names) == B::count, "one name per parameter");
  Row& row = raw(name, doc, &B::call, B::params({names...}, false), "");
  row.returns = B::returns();
  B::row = &row;
  return row;
}

template <auto F, class... Names>
Row& Area::method(const char* name, const char* doc, Names... names) {
  using B = detail::Bound<F>;
  static_assert(sizeof...(Names) + 1 == B::count, "one name per parameter, self aside");
  Row& row = raw(name, doc, &B::call, B::params({names...}, true), "");
  row.returns = B::returns();
  row.method = true;
  B::row = &row;
  return row;
}

template <auto Get, auto Set>
Row& Area::prop(const char* name, const char* doc) {
  using G = detail::Bound<Get>;
  Row& row = rows.emplace_back();
  row.kind = Row::Kind::property;
  row.area = this->name;
  row.name = name;
  row.doc = doc;
  row.returns = G::returns();
  row.method = object;
  row.get = &G::call;
  // Reading is always allowed; the writer checks through a row of its own.
  G::row = &row;
  if constexpr (!std::is_same_v<decltype(Set), std::nullptr_t>) {
    using S = detail::Bound<Set>;
    static Row writer;
    writer = row;
    writer.permit = Permit::write;
    writer.params = {Param{"value", row.returns, false}};
    S::row = &writer;
    row.set = &S::call;
  }
  return row;
}

}  // namespace tumble
