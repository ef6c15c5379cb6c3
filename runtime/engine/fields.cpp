#include "engine/fields.h"

#include <charconv>
#include <memory>

#include "base/text.h"

namespace tumble {

namespace {

[[noreturn]] void no_field(const Type& type, std::string_view name, const std::string& where) {
  fail(where, ": no field '", name, "'", did_you_mean(name, type.field_names()));
}

// The field itself or, for `x_degrees`, the one in radians.
const Field& field_or_fail(const Type& type, std::string_view name, const std::string& where) {
  const Field* field = type.field(name);
  if (!field) field = type.field_in_degrees(name);
  if (!field) no_field(type, name, where);
  return *field;
}

void reset(const Type& type, void* object, std::string_view name, const std::string& where) {
  const Field& field = field_or_fail(type, name, where);
  if (field.type->kind == Kind::optional) return field.type->clear(field.of(object));
  const std::unique_ptr<void, std::function<void(void*)>> usual(type.make(), type.drop);
  assign_field(type, object, field.name, to_value(*field.type, field.of(static_cast<const void*>(usual.get()))), where);
}

void assign_in_list(const Type& type, void* list, std::string_view path, const Value& value, const std::string& where) {
  const auto [head, rest] = split_path(path);
  std::size_t number = 0;
  std::from_chars(head.data(), head.data() + head.size(), number);
  if (number < 1 || number > type.size(list))
    fail(where, ": no entry '", head, "'; the list has ", type.size(list), ", counted from 1");
  void* entry = const_cast<void*>(type.at(list, number - 1));
  const std::string place = where + "[" + std::string(head) + "]";
  if (rest.empty()) assign(*type.element, entry, value, place);
  else assign_path(*type.element, entry, rest, value, place);
}

}  // namespace

std::pair<std::string_view, std::string_view> split_path(std::string_view path) {
  const auto dot = path.find('.');
  if (dot == path.npos) return {path, {}};
  return {path.substr(0, dot), path.substr(dot + 1)};
}

void assign_path(const Type& type, void* object, std::string_view path, const Value& value, const std::string& where) {
  if (type.kind == Kind::list) return assign_in_list(type, object, path, value, where);
  const auto [head, rest] = split_path(path);
  if (type.kind != Kind::structure) fail(where, ": ", type_text(type), " has no field '", head, "'");

  if (rest.empty()) {
    if (value.is_nil()) reset(type, object, head, where);
    else if (!assign_field(type, object, head, value, where)) no_field(type, head, where);
    return;
  }
  const Field& field = field_or_fail(type, head, where);
  const Type* inner = field.type;
  void* content = field.of(object);
  if (inner->kind == Kind::optional) {
    content = const_cast<void*>(inner->get(content));
    if (!content) fail(where, ": there is no ", head, " (nil), so '", path, "' cannot be set; set ", head, " first");
    inner = inner->element;
  }
  assign_path(*inner, content, rest, value, where + ": " + std::string(head));
  if (type.check) assign(type, object, Value(Map{}), where);  // do the fields still fit together?
}

void assign_path(NodeDef& def, std::string_view path, const Value& value, const std::string& where) {
  assign_path(type_of<NodeDef>(), &def, path, value, where);
  // The colour that was written last holds, under whichever of its two names.
  if (path == "material.color" || path == "material") def.color.reset();
}

}  // namespace tumble
