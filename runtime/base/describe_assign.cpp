// The half of describe.h that reads: Values into structs, with worded errors.

#include "base/describe.h"
#include "base/text.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tumble {

namespace {

// A place inside the value that is being read. Links on the stack: a path costs nothing until an error needs its text.
struct Place {
  const std::string& where;
  const Place* parent;
  std::string_view name;  // of a field or map entry
  std::size_t index;      // of a list entry, from 1

  Place field(std::string_view its_name) const { return {where, this, its_name, 0}; }
  Place entry(std::size_t number) const { return {where, this, {}, number}; }

  std::string path() const {
    if (!parent) return "";
    const std::string above = parent->path();
    if (index > 0) return above + "[" + std::to_string(index) + "]";
    return above + (above.empty() ? "" : ".") + std::string(name);
  }
  // "scene.add: body" or, at the top, "scene.add".
  std::string text() const {
    const std::string inside = path();
    return inside.empty() ? where : where + ": " + inside;
  }
  // For sentences without a colon of their own: "scene.add: body.mass must ...", "scene.add: must ...".
  std::string subject() const { return path().empty() ? where + ":" : text(); }
};

struct Limits {
  double minimum = -1e308, maximum = 1e308;
  bool above_minimum = false, infinite = false;
};

Limits limits_of(const Field& field) { return {field.minimum, field.maximum, field.above_minimum, field.infinite}; }

Limits in_degrees(Limits limits) {
  // 180 degrees are pi radians give or take a bit: the nearest 1e-9 of a degree is what the describer meant.
  const auto convert = [](double v) { return std::abs(v) < 1e300 ? std::round(degrees(v) * 1e9) / 1e9 : v; };
  return {convert(limits.minimum), convert(limits.maximum), limits.above_minimum, limits.infinite};
}

std::string shown(const Value& value) {
  if (const List* list = value.get<List>()) return list->empty() ? "an empty table" : "a list of " + std::to_string(list->size());
  if (value.is<Map>() || value.is<Reference>()) return kind_name(value);
  const std::string* string = value.get<std::string>();
  return string && string->size() > 60 ? "a long string" : text(value);
}

[[noreturn]] void expected(const std::string& what, const Value& value, const Place& place) {
  fail(place.text(), ": ", what, " expected, got ", shown(value));
}

bool is_empty_table(const Value& value) {
  const List* list = value.get<List>();
  const Map* map = value.get<Map>();
  return (list && list->empty()) || (map && map->empty());
}

void check_range(double number, const Limits& limits, const Place& place) {
  const auto refuse = [&](const std::string& must) {
    fail(place.subject(), " must be ", must, " (got ", number_text(number), ")");
  };
  const bool low = limits.minimum > -1e308, high = limits.maximum < 1e308;
  const bool too_low = limits.above_minimum ? number <= limits.minimum : number < limits.minimum;
  if (!(low && too_low) && !(high && number > limits.maximum)) return;
  const std::string minimum = number_text(limits.minimum), maximum = number_text(limits.maximum);
  if (low && high && limits.above_minimum) refuse("above " + minimum + " and at most " + maximum);
  if (low && high) refuse("from " + minimum + " to " + maximum);
  if (high) refuse("at most " + maximum);
  refuse((limits.above_minimum ? "above " : "at least ") + minimum);
}

double checked(double number, const Limits& limits, const Place& place) {
  if (std::isnan(number) || (std::isinf(number) && !limits.infinite))
    fail(place.subject(), " is not a finite number (", std::isnan(number) ? "nan" : number > 0 ? "inf" : "-inf", ")");
  check_range(number, limits, place);
  return number;
}

double read_number(const Value& value, const Limits& limits, const Place& place) {
  if (!value.is_number()) expected("number", value, place);
  return checked(value.number(), limits, place);
}

int read_integer(const Value& value, const Limits& limits, const Place& place) {
  const double number = read_number(value, limits, place);
  if (number != std::floor(number)) expected("whole number", value, place);
  check_range(number, {std::numeric_limits<int>::min(), std::numeric_limits<int>::max()}, place);
  return static_cast<int>(number);
}

Vec3 read_vec3(const Value& value, const Limits& limits, const Place& place) {
  if (const Vec3* v = value.get<Vec3>())
    return {checked(v->x, limits, place.field("x")), checked(v->y, limits, place.field("y")),
            checked(v->z, limits, place.field("z"))};
  const List* list = value.get<List>();
  if (!list || list->size() != 3) expected("vec3", value, place);
  return {read_number((*list)[0], limits, place.field("x")), read_number((*list)[1], limits, place.field("y")),
          read_number((*list)[2], limits, place.field("z"))};
}

Quat components(const Value& value, const Place& place) {
  if (const Quat* q = value.get<Quat>()) return *q;
  if (value.is<Vec3>())
    fail(place.text(), ": quat expected, got ", text(value), "; for Euler angles write ", place.path(), "_degrees");
  const List* list = value.get<List>();
  if (!list || list->size() != 4) expected("quat", value, place);
  return {read_number((*list)[0], {}, place.field("x")), read_number((*list)[1], {}, place.field("y")),
          read_number((*list)[2], {}, place.field("z")), read_number((*list)[3], {}, place.field("w"))};
}

Quat read_quat(const Value& value, const Place& place) {
  const Quat q = components(value, place);
  if (!is_finite(q)) fail(place.subject(), " is not finite (got ", text(Value(q)), ")");
  const double largest = std::max({std::abs(q.x), std::abs(q.y), std::abs(q.z), std::abs(q.w)});
  if (largest == 0) fail(place.subject(), " must not be zero (got 0, 0, 0, 0); for no rotation write 0, 0, 0, 1");
  // What is of unit length already keeps its bits, so that saving and loading changes nothing.
  if (std::abs(dot(q, q) - 1) < 1e-15) return q;
  return normalized(Quat{q.x / largest, q.y / largest, q.z / largest, q.w / largest});
}

Color read_color(const Value& value, const Place& place) {
  if (const std::string* string = value.get<std::string>()) return color_or_fail(*string, place.text());
  if (const Color* c = value.get<Color>())
    return {checked(c->r, {}, place.field("r")), checked(c->g, {}, place.field("g")), checked(c->b, {}, place.field("b")),
            checked(c->a, {}, place.field("a"))};
  const List* list = value.get<List>();
  if (!list || list->size() < 3 || list->size() > 4) expected("color", value, place);
  const Limits unit{0, 1};
  const auto part = [&](std::size_t i, const char* name) { return read_number((*list)[i], unit, place.field(name)); };
  return {part(0, "r"), part(1, "g"), part(2, "b"), list->size() == 4 ? part(3, "a") : 1.0};
}

int read_choice(const Type& type, const Value& value, const Place& place) {
  const std::string names = join(type.choices);
  const std::string* word = value.get<std::string>();
  if (!word) expected("one of " + names, value, place);
  for (std::size_t i = 0; i < type.choices.size(); ++i)
    if (type.choices[i] == *word) return static_cast<int>(i);
  fail(place.text(), ": unknown '", *word, "'; expected one of ", names, did_you_mean(*word, type.choices));
}

void read(const Type& type, void* object, const Value& value, const Limits& limits, const Place& place);

void read_list(const Type& type, void* object, const Value& value, const Limits& limits, const Place& place) {
  type.clear(object);
  if (is_empty_table(value)) return;
  const List* list = value.get<List>();
  if (!list) {
    if (value.is_nil()) expected(type_text(type), value, place);
    return read(*type.element, type.append(object), value, limits, place);
  }
  for (std::size_t i = 0; i < list->size(); ++i) read(*type.element, type.append(object), (*list)[i], limits, place.entry(i + 1));
}

void read_map(const Type& type, void* object, const Value& value, const Limits& limits, const Place& place) {
  const Map* map = value.get<Map>();
  if (!map && !is_empty_table(value)) expected("table", value, place);
  type.clear(object);
  if (!map) return;
  for (const auto& [key, entry] : *map) read(*type.element, type.insert(object, key), entry, limits, place.field(key));
}

// Is the value one that may stand for the main field of a structure?
bool is_short_form(const Type& main, const Value& value) {
  switch (main.kind) {
    case Kind::string:
    case Kind::choice: return value.is<std::string>();
    case Kind::number:
    case Kind::integer: return value.is_number();
    case Kind::color: return value.is<std::string>() || value.is<Color>() || value.is<List>();
    case Kind::vec3: return value.is<Vec3>() || value.is<List>();
    case Kind::optional: return is_short_form(*main.element, value);
    default: return false;
  }
}

// A number, optional number or rotation, written in degrees.
void read_degrees(const Type& type, void* object, const Value& value, const Limits& limits, const Place& place) {
  if (type.kind == Kind::optional) {
    type.clear(object);
    if (!value.is_nil()) read_degrees(*type.element, type.emplace(object), value, limits, place);
  } else if (type.kind == Kind::quat) {
    const Vec3 angles = read_vec3(value, {}, place);
    *static_cast<Quat*>(object) = from_euler({radians(angles.x), radians(angles.y), radians(angles.z)});
  } else {
    *static_cast<double*>(object) = radians(read_number(value, in_degrees(limits), place));
  }
}

bool read_field(const Type& type, void* object, std::string_view name, const Value& value, const Place& place) {
  if (const Field* field = type.field(name)) {
    read(*field->type, field->of(object), value, limits_of(*field), place.field(name));
    return true;
  }
  const Field* field = type.field_in_degrees(name);
  if (field) read_degrees(*field->type, field->of(object), value, limits_of(*field), place.field(name));
  return field != nullptr;
}

void run_check(const Type& type, const void* object, const Place& place) {
  if (!type.check) return;
  try {
    type.check(object);
  } catch (const Error& error) {
    fail(place.text(), ": ", error.what());
  }
}

[[noreturn]] void unknown_field(const Type& type, const std::string& name, const Place& place) {
  const std::vector<std::string> names = type.field_names();
  std::string hint = did_you_mean(name, names);
  if (hint.empty()) hint = "; it has " + join(names);
  fail(place.path().empty() ? place.where + ":" : place.text() + " has", " no field '", name, "'", hint);
}

void read_entries(const Type& type, void* object, const Value& value, const Place& place) {
  for (const auto& [key, entry] : *value.get<Map>()) {
    const Field* twin = type.field_in_degrees(key);
    if (twin && value.find(twin->name)) fail(place.text(), " has both '", twin->name, "' and '", key, "'; give one of them");
    if (!read_field(type, object, key, entry, place)) unknown_field(type, key, place);
  }
}

void read_structure(const Type& type, void* object, const Value& value, const Place& place) {
  const Map* map = value.get<Map>();
  if (!map && !is_empty_table(value)) {
    const Field* main = type.field(type.main_field);
    if (!main) expected("table", value, place);
    if (!is_short_form(*main->type, value)) expected("table or " + type_text(*main->type), value, place);
    read_field(type, object, main->name, value, place);
  }
  if (map) read_entries(type, object, value, place);
  run_check(type, object, place);
}

void read(const Type& type, void* object, const Value& value, const Limits& limits, const Place& place) {
  switch (type.kind) {
    case Kind::boolean:
      if (!value.is<bool>()) expected("true or false", value, place);
      *static_cast<bool*>(object) = *value.get<bool>();
      break;
    case Kind::string:
      if (!value.is<std::string>()) expected("string", value, place);
      *static_cast<std::string*>(object) = *value.get<std::string>();
      break;
    case Kind::integer: *static_cast<int*>(object) = read_integer(value, limits, place); break;
    case Kind::number: *static_cast<double*>(object) = read_number(value, limits, place); break;
    case Kind::vec3: *static_cast<Vec3*>(object) = read_vec3(value, limits, place); break;
    case Kind::quat: *static_cast<Quat*>(object) = read_quat(value, place); break;
    case Kind::color: *static_cast<Color*>(object) = read_color(value, place); break;
    case Kind::any: *static_cast<Value*>(object) = value; break;
    case Kind::choice: type.set_choice(object, read_choice(type, value, place)); break;
    case Kind::structure: read_structure(type, object, value, place); break;
    case Kind::list: read_list(type, object, value, limits, place); break;
    case Kind::map: read_map(type, object, value, limits, place); break;
    case Kind::optional:
      type.clear(object);
      if (!value.is_nil()) read(*type.element, type.emplace(object), value, limits, place);
      break;
  }
}

}  // namespace

void assign(const Type& type, void* object, const Value& value, const std::string& where) {
  read(type, object, value, {}, Place{where, nullptr, {}, 0});
}

bool assign_field(const Type& type, void* object, std::string_view name, const Value& value, const std::string& where) {
  const Place top{where, nullptr, {}, 0};
  if (!read_field(type, object, name, value, top)) return false;
  run_check(type, object, top);
  return true;
}

}  // namespace tumble
