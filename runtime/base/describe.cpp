#include "base/describe.h"

#include "base/text.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>

namespace tumble {

namespace detail {

Type simple(Kind kind, const char* name) {
  Type type;
  type.kind = kind;
  type.name = name;
  return type;
}

std::recursive_mutex& type_mutex() {
  static std::recursive_mutex mutex;
  return mutex;
}

}  // namespace detail

const Field* Type::field(std::string_view name) const {
  for (const Field& field : fields)
    if (field.name == name) return &field;
  return nullptr;
}

const Field* Type::field_in_degrees(std::string_view name) const {
  constexpr std::string_view kEnding = "_degrees";
  if (!name.ends_with(kEnding)) return nullptr;
  const Field* twin = field(name.substr(0, name.size() - kEnding.size()));
  return twin && twin->angle ? twin : nullptr;
}

std::vector<std::string> Type::field_names() const {
  std::vector<std::string> names;
  for (const Field& field : fields) {
    names.push_back(field.name);
    if (field.angle) names.push_back(field.name + "_degrees");
  }
  return names;
}

std::string type_text(const Type& type) {
  switch (type.kind) {
    case Kind::choice: return '"' + join(type.choices, "\" | \"") + '"';
    case Kind::optional: return type_text(*type.element);
    case Kind::list: return "list of " + type_text(*type.element);
    case Kind::map: return "table of " + type_text(*type.element);
    default: return type.name;
  }
}

namespace {

// The shortest decimal within 1e-12 of the value: 30 degrees are stored as radians that give 30.000000000000004 back.
double tidy(double value) {
  if (!std::isfinite(value)) return value;
  char text[32];
  for (int digits = 1; digits < 17; ++digits) {
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    const double candidate = std::strtod(text, nullptr);
    if (std::abs(candidate - value) <= 1e-12 * std::abs(value)) return candidate;
  }
  return value;
}

Vec3 radians(Vec3 v) { return {tumble::radians(v.x), tumble::radians(v.y), tumble::radians(v.z)}; }
Vec3 degrees(Vec3 v) { return {tumble::degrees(v.x), tumble::degrees(v.y), tumble::degrees(v.z)}; }

// The largest difference of a component, q and -q being one rotation.
double difference(Quat a, Quat b) {
  const double sign = dot(a, b) < 0 ? -1 : 1;
  return std::max({std::abs(a.x - sign * b.x), std::abs(a.y - sign * b.y), std::abs(a.z - sign * b.z),
                   std::abs(a.w - sign * b.w)});
}

// Euler angles in degrees with as few decimals as the rotation needs.
Vec3 euler_degrees(Quat q) {
  const Vec3 exact = degrees(to_euler(q));
  for (int decimals = 0; decimals <= 12; ++decimals) {
    const double scale = std::pow(10.0, decimals);
    const auto round = [scale](double v) { return std::round(v * scale) / scale + 0.0; };  // + 0.0: no -0
    const Vec3 candidate{round(exact.x), round(exact.y), round(exact.z)};
    if (difference(from_euler(radians(candidate)), q) < 1e-14) return candidate;
  }
  return exact;
}

// Beside x = +-90 degrees the angles lose digits; such a rotation is written as it is.
bool euler_is_exact(Quat q) { return difference(from_euler(to_euler(q)), q) < 1e-12; }

using Object = std::unique_ptr<void, std::function<void(void*)>>;
Object make_default(const Type& type) { return Object(type.make(), type.drop); }

Value write(const Type& type, const void* object, const void* base, bool only_changes);

// Appends the field under the name in which people write it.
void write_field(const Field& field, const void* place, const void* base, bool only_changes, Map& map) {
  const Value value = write(*field.type, place, base, only_changes);
  if (!field.angle) {
    map.emplace_back(field.name, value);
  } else if (const Quat* q = value.get<Quat>()) {
    if (only_changes && !euler_is_exact(*q)) map.emplace_back(field.name, *q);
    else map.emplace_back(field.name + "_degrees", euler_degrees(*q));
  } else {
    map.emplace_back(field.name + "_degrees", value.is_number() ? Value(tidy(tumble::degrees(value.number()))) : value);
  }
}

Value write_structure(const Type& type, const void* object, const void* base, bool only_changes) {
  Map map;
  Object made;
  if (only_changes && !base) {
    made = make_default(type);
    base = made.get();
  }
  for (const Field& field : type.fields) {
    const void* place = field.of(object);
    if (!only_changes) {
      write_field(field, place, nullptr, false, map);
      continue;
    }
    const void* usual = field.of(base);
    if (field.saved && !(to_value(*field.type, place) == to_value(*field.type, usual)))
      write_field(field, place, field.type->kind == Kind::structure ? usual : nullptr, true, map);
  }
  return map;
}

// base: what an object of this type is unless it is written; nullptr: as its type makes it.
Value write(const Type& type, const void* object, const void* base, bool only_changes) {
  switch (type.kind) {
    case Kind::boolean: return *static_cast<const bool*>(object);
    case Kind::integer: return *static_cast<const int*>(object);
    case Kind::number: return *static_cast<const double*>(object);
    case Kind::string: return *static_cast<const std::string*>(object);
    case Kind::vec3: return *static_cast<const Vec3*>(object);
    case Kind::quat: return *static_cast<const Quat*>(object);
    case Kind::color: return *static_cast<const Color*>(object);
    case Kind::any: return *static_cast<const Value*>(object);
    case Kind::choice: return type.choices[static_cast<std::size_t>(type.get_choice(object))];
    case Kind::structure: return write_structure(type, object, base, only_changes);
    case Kind::optional: {
      const void* content = type.get(object);
      return content ? write(*type.element, content, nullptr, only_changes) : Value{};
    }
    case Kind::list: {
      List list;
      for (std::size_t i = 0; i < type.size(object); ++i)
        list.push_back(write(*type.element, type.at(object, i), nullptr, only_changes));
      return list;
    }
    case Kind::map: {
      Map map;
      type.each(object, [&](const std::string& key, const void* content) {
        map.emplace_back(key, write(*type.element, content, nullptr, only_changes));
      });
      return map;
    }
  }
  return {};
}

}  // namespace

Value to_value(const Type& type, const void* object, bool only_changes) { return write(type, object, nullptr, only_changes); }

std::optional<Value> field_value(const Type& type, const void* object, std::string_view name) {
  if (const Field* field = type.field(name)) return to_value(*field->type, field->of(object));
  const Field* field = type.field_in_degrees(name);
  if (!field) return std::nullopt;
  const Value value = to_value(*field->type, field->of(object));
  if (const Quat* q = value.get<Quat>()) return Value(euler_degrees(*q));
  return value.is_number() ? Value(tidy(degrees(value.number()))) : value;
}

}  // namespace tumble
