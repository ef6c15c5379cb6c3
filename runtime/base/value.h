// A value of any kind that scripts, scene files and settings share: the neutral ground between Lua, JSON and C++ structs.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "base/color.h"
#include "base/math.h"

namespace tumble {

// A node or joint inside a Value; only who made it can say which pool it points into.
struct Reference {
  enum class Kind : std::uint32_t { node, joint } kind = Kind::node;
  std::uint32_t index = 0;
  std::uint32_t generation = 0;
  bool operator==(const Reference&) const = default;
};

class Value;
using List = std::vector<Value>;
// Keys in the order in which they were written; each key at most once.
using Map = std::vector<std::pair<std::string, Value>>;

class Value {
 public:
  using Data = std::variant<std::monostate, bool, std::int64_t, double, std::string, Vec3, Quat, Color, Reference, List, Map>;

  Value() = default;
  Value(bool b) : data(b) {}
  Value(int i) : data(std::int64_t{i}) {}
  Value(std::int64_t i) : data(i) {}
  Value(double d) : data(d) {}
  Value(const char* s) : data(std::string(s)) {}
  Value(std::string s) : data(std::move(s)) {}
  Value(Vec3 v) : data(v) {}
  Value(Quat q) : data(q) {}
  Value(Color c) : data(c) {}
  Value(Reference r) : data(r) {}
  Value(List list) : data(std::move(list)) {}
  Value(Map map) : data(std::move(map)) {}

  template <class T>
  bool is() const { return std::holds_alternative<T>(data); }
  template <class T>
  const T* get() const { return std::get_if<T>(&data); }
  template <class T>
  T* get() { return std::get_if<T>(&data); }

  bool is_nil() const { return is<std::monostate>(); }
  bool is_number() const { return is<std::int64_t>() || is<double>(); }
  // Only of a number.
  double number() const { return is<std::int64_t>() ? static_cast<double>(*get<std::int64_t>()) : *get<double>(); }
  // The entry of a map, or nullptr.
  const Value* find(std::string_view key) const;
  // The entry of a map; makes this an empty map first where it is not one, and the entry where it is missing.
  Value& operator[](std::string_view key);

  // Equal in kind and content; 1 and 1.0 differ, as in the text of a script. Maps compare as sets of entries.
  bool operator==(const Value& other) const;

  Data data;
};

// "a number", "a list", ...: for error messages.
std::string kind_name(const Value& value);
// Short and readable, for log lines and error messages: 0.3, "red", vec3(1, 2, 3).
std::string text(const Value& value);

}  // namespace tumble
