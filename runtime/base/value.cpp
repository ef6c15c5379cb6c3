#include "base/value.h"

#include "base/text.h"

namespace tumble {

const Value* Value::find(std::string_view key) const {
  if (const Map* map = get<Map>())
    for (const auto& [name, value] : *map)
      if (name == key) return &value;
  return nullptr;
}

Value& Value::operator[](std::string_view key) {
  if (!is<Map>()) data = Map{};
  Map& map = *get<Map>();
  for (auto& [name, value] : map)
    if (name == key) return value;
  return map.emplace_back(std::string(key), Value{}).second;
}

bool Value::operator==(const Value& other) const {
  if (data.index() != other.data.index()) return false;
  const Map* map = get<Map>();
  if (!map) return data == other.data;
  if (map->size() != other.get<Map>()->size()) return false;
  for (const auto& [name, value] : *map) {
    const Value* twin = other.find(name);
    if (!twin || !(value == *twin)) return false;
  }
  return true;
}

std::string kind_name(const Value& value) {
  static const char* const names[] = {"nil",    "a boolean", "a number", "a number", "a string", "a vec3",
                                      "a quat", "a color",   "a node",   "a list",   "a table"};
  if (const Reference* reference = value.get<Reference>())
    if (reference->kind == Reference::Kind::joint) return "a joint";
  return names[value.data.index()];
}

namespace {

struct Writer {
  std::string operator()(std::monostate) const { return "nil"; }
  std::string operator()(bool b) const { return b ? "true" : "false"; }
  std::string operator()(std::int64_t i) const { return std::to_string(i); }
  std::string operator()(double d) const { return number_text(d); }
  std::string operator()(const std::string& s) const { return '"' + s + '"'; }
  std::string operator()(Vec3 v) const {
    return "vec3(" + number_text(v.x) + ", " + number_text(v.y) + ", " + number_text(v.z) + ")";
  }
  std::string operator()(Quat q) const {
    return "quat(" + number_text(q.x) + ", " + number_text(q.y) + ", " + number_text(q.z) + ", " + number_text(q.w) + ")";
  }
  std::string operator()(const Color& c) const { return '"' + to_hex(c) + '"'; }
  std::string operator()(const Reference& r) const { return r.kind == Reference::Kind::node ? "node" : "joint"; }
  std::string operator()(const List& list) const {
    std::vector<std::string> parts;
    for (const Value& value : list) parts.push_back(text(value));
    return "{ " + join(parts) + " }";
  }
  std::string operator()(const Map& map) const {
    std::vector<std::string> parts;
    for (const auto& [name, value] : map) parts.push_back(name + " = " + text(value));
    return "{ " + join(parts) + " }";
  }
};

}  // namespace

std::string text(const Value& value) { return std::visit(Writer{}, value.data); }

}  // namespace tumble
