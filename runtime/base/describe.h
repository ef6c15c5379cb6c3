// One description of a struct, many uses: options tables, scene files, documents, editor types, reload, inspector.
//
// A struct is described once, beside its declaration:
//
//   void describe(LightDef& light, Schema& s) {
//     s.name("light", "A light; it shines along its node's forward direction.");
//     s.add("brightness", light.brightness, "1 is a clear day.").at_least(0);
//   }
//
// type_of<LightDef>() turns that into data at first use. Everything else works on this data and on Values:
// assign() fills a struct from a Value with worded errors, to_value() reads it back, and documents list its fields.
// Enums are described by `const EnumNames& enum_names(MyEnum)`.
#pragma once

#include <cstddef>
#include <functional>
#include <initializer_list>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/color.h"
#include "base/error.h"
#include "base/math.h"
#include "base/value.h"

namespace tumble {

struct Type;

enum class Kind { boolean, integer, number, string, vec3, quat, color, choice, structure, optional, list, map, any };

struct Field {
  std::string name;
  std::string doc;
  const Type* type = nullptr;
  std::size_t offset = 0;
  bool angle = false;           // stored in radians; scripts and files may also write `name_degrees` (of a quat: Euler
                                // angles, turned first about y, then x, then z)
  double minimum = -1e308;      // of numbers and of each component of vectors; inclusive
  double maximum = 1e308;
  bool above_minimum = false;   // the minimum itself is refused
  bool infinite = false;        // infinity is allowed
  bool saved = true;            // written to scene files

  Field& at_least(double value) { minimum = value; return *this; }
  Field& above(double value) { minimum = value; above_minimum = true; return *this; }
  Field& between(double low, double high) { minimum = low; maximum = high; return *this; }
  Field& allow_infinite() { infinite = true; return *this; }
  Field& not_saved() { saved = false; return *this; }

  void* of(void* object) const { return static_cast<char*>(object) + offset; }
  const void* of(const void* object) const { return static_cast<const char*>(object) + offset; }
};

// What there is to know of a C++ type at run time. Types live as long as the program.
struct Type {
  Kind kind = Kind::any;
  std::string name;  // as documents show it: "number", "vec3", "Light"

  std::vector<std::string> choices;                 // choice
  std::function<int(const void*)> get_choice;
  std::function<void(void*, int)> set_choice;

  std::string summary;                              // structure
  std::vector<Field> fields;
  std::string main_field;                           // a bare string (or other simple value) stands for this field
  std::function<void(const void*)> check;           // throws Error where fields do not fit together
  std::function<void*()> make;                      // a default-constructed object, owned by the caller
  std::function<void(void*)> drop;

  const Type* element = nullptr;                    // optional, list, map
  std::function<const void*(const void*)> get;      // optional: the content or nullptr
  std::function<void*(void*)> emplace;              // optional: a fresh default content
  std::function<void(void*)> clear;                 // optional, list, map
  std::function<std::size_t(const void*)> size;     // list
  std::function<const void*(const void*, std::size_t)> at;
  std::function<void*(void*)> append;
  std::function<void(const void*, const std::function<void(const std::string&, const void*)>&)> each;  // map
  std::function<void*(void*, const std::string&)> insert;

  const Field* field(std::string_view name) const;
  const Field* field_in_degrees(std::string_view name) const;  // "x_degrees" of an angle field x
  std::vector<std::string> field_names() const;     // with the `_degrees` twins
};

template <class T>
const Type& type_of();

// As documents write a field's type: "number", "list of collider", "\"dynamic\" | \"static\"".
std::string type_text(const Type& type);

using EnumNames = std::vector<std::string>;

// Collects the fields of one struct; the only argument of a describe() beside the object.
class Schema {
 public:
  Schema(Type& type, const void* object) : type_(type), object_(static_cast<const char*>(object)) {}

  // What documents call the struct, and a sentence or two about it.
  void name(std::string name, std::string summary) {
    type_.name = std::move(name);
    type_.summary = std::move(summary);
  }

  template <class T>
  Field& add(const char* name, T& field, const char* doc) {
    Field& entry = type_.fields.emplace_back();
    entry.name = name;
    entry.doc = doc;
    entry.type = &type_of<T>();
    entry.offset = static_cast<std::size_t>(reinterpret_cast<const char*>(&field) - object_);
    return entry;
  }
  // A number or optional number of radians, which people write as `name_degrees`.
  template <class T>
  Field& angle(const char* name, T& field, const char* doc) {
    Field& entry = add(name, field, doc);
    entry.angle = true;
    return entry;
  }
  // A rotation, which people write as `name_degrees`: Euler angles, y then x then z.
  Field& rotation(const char* name, Quat& field, const char* doc) {
    Field& entry = add(name, field, doc);
    entry.angle = true;
    return entry;
  }
  // The field that a bare string stands for: body = "static".
  void main(const char* name) { type_.main_field = name; }
  // Runs after every assignment; its Error says only what is wrong, the place comes before it:
  // fail("min must not be above max (got 3 and 1); leave both out for no limit").
  template <class T>
  void check(void (*test)(const T&)) {
    type_.check = [test](const void* object) { test(*static_cast<const T*>(object)); };
  }

 private:
  Type& type_;
  const char* object_;
};

// Fills what `value` gives and leaves the rest as it is; lists, maps and optionals are replaced whole, nil clears an
// optional. Throws Error beginning with `where`: "scene.add: body.mass must be above 0 (got -1)"; list entries are
// counted from 1, as in Lua. An object may then be half written, so callers assign to a copy, as the template does.
//
// Short forms: a plain value stands for a structure with that main field; a list of one may lose its braces; an empty
// table may arrive as an empty List or an empty Map; lists of three or four numbers stand for vec3, color and quat.
void assign(const Type& type, void* object, const Value& value, const std::string& where);
// Everything, or only what differs from a default-constructed object and is meant to be saved. Angles are written in
// degrees, rounded to the shortest number that is right to 1e-12.
Value to_value(const Type& type, const void* object, bool only_changes = false);
// One field by its name, `_degrees` twins included; false where there is no such field. The same rules as assign().
bool assign_field(const Type& type, void* object, std::string_view name, const Value& value, const std::string& where);
std::optional<Value> field_value(const Type& type, const void* object, std::string_view name);

template <class T>
void assign(T& object, const Value& value, const std::string& where) {
  T copy = object;
  assign(type_of<T>(), &copy, value, where);
  object = std::move(copy);
}
template <class T>
Value to_value(const T& object, bool only_changes = false) {
  return to_value(type_of<T>(), &object, only_changes);
}

// ---- how a C++ type becomes a Type

namespace detail {

template <class T>
struct IsOptional : std::false_type {};
template <class T>
struct IsOptional<std::optional<T>> : std::true_type {};
template <class T>
struct IsVector : std::false_type {};
template <class T>
struct IsVector<std::vector<T>> : std::true_type {};
template <class T>
struct IsMap : std::false_type {};
template <class T>
struct IsMap<std::map<std::string, T>> : std::true_type {};

Type simple(Kind kind, const char* name);
// Held while types are made, so that runtimes in several threads may start at once.
std::recursive_mutex& type_mutex();

template <class T>
void make_enum(Type& type) {
  type.kind = Kind::choice;
  type.choices = enum_names(T{});
  type.name = "string";
  type.get_choice = [](const void* p) { return static_cast<int>(*static_cast<const T*>(p)); };
  type.set_choice = [](void* p, int i) { *static_cast<T*>(p) = static_cast<T>(i); };
}

template <class O>
void make_optional(Type& type) {
  using T = typename O::value_type;
  type.kind = Kind::optional;
  type.element = &type_of<T>();
  type.name = type.element->name;
  type.get = [](const void* p) -> const void* {
    const auto& o = *static_cast<const O*>(p);
    return o ? &*o : nullptr;
  };
  type.emplace = [](void* p) -> void* { return &static_cast<O*>(p)->emplace(); };
  type.clear = [](void* p) { static_cast<O*>(p)->reset(); };
}

template <class V>
void make_list(Type& type) {
  type.kind = Kind::list;
  type.element = &type_of<typename V::value_type>();
  type.name = "list of " + type.element->name;
  type.size = [](const void* p) { return static_cast<const V*>(p)->size(); };
  type.at = [](const void* p, std::size_t i) -> const void* { return &(*static_cast<const V*>(p))[i]; };
  type.append = [](void* p) -> void* { return &static_cast<V*>(p)->emplace_back(); };
  type.clear = [](void* p) { static_cast<V*>(p)->clear(); };
}

template <class M>
void make_map(Type& type) {
  type.kind = Kind::map;
  type.element = &type_of<typename M::mapped_type>();
  type.name = "table of " + type.element->name;
  type.each = [](const void* p, const std::function<void(const std::string&, const void*)>& f) {
    for (const auto& [key, value] : *static_cast<const M*>(p)) f(key, &value);
  };
  type.insert = [](void* p, const std::string& key) -> void* { return &(*static_cast<M*>(p))[key]; };
  type.clear = [](void* p) { static_cast<M*>(p)->clear(); };
}

template <class T>
void make_struct(Type& type) {
  type.kind = Kind::structure;
  type.make = []() -> void* { return new T(); };
  type.drop = [](void* p) { delete static_cast<T*>(p); };
  T object{};
  Schema schema(type, &object);
  describe(object, schema);
}

template <class T>
void make_type(Type& type) {
  if constexpr (std::is_same_v<T, bool>) type = simple(Kind::boolean, "boolean");
  else if constexpr (std::is_same_v<T, int>) type = simple(Kind::integer, "integer");
  else if constexpr (std::is_same_v<T, double>) type = simple(Kind::number, "number");
  else if constexpr (std::is_same_v<T, std::string>) type = simple(Kind::string, "string");
  else if constexpr (std::is_same_v<T, Vec3>) type = simple(Kind::vec3, "vec3");
  else if constexpr (std::is_same_v<T, Quat>) type = simple(Kind::quat, "quat");
  else if constexpr (std::is_same_v<T, Color>) type = simple(Kind::color, "color");
  else if constexpr (std::is_same_v<T, Value>) type = simple(Kind::any, "any");
  else if constexpr (std::is_enum_v<T>) make_enum<T>(type);
  else if constexpr (IsOptional<T>::value) make_optional<T>(type);
  else if constexpr (IsVector<T>::value) make_list<T>(type);
  else if constexpr (IsMap<T>::value) make_map<T>(type);
  else make_struct<T>(type);
}

}  // namespace detail

template <class T>
const Type& type_of() {
  // Two steps, so that a struct may hold a list of itself: its Type has an address before it has fields.
  static Type type;
  static bool made = false;
  const std::lock_guard lock(detail::type_mutex());
  if (!made) {
    made = true;
    detail::make_type<T>(type);
  }
  return type;
}

}  // namespace tumble
