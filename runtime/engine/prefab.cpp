#include "engine/prefab.h"

#include "engine/node_def.h"

#include <algorithm>
#include <map>

namespace tumble {

namespace {

void remove_key(Map& map, const std::string& key) {
  std::erase_if(map, [&](const auto& entry) { return entry.first == key; });
}

// The full form of what a structure may be written as.
Map full_form(const Type& type, const Value& value) {
  if (const Map* map = value.get<Map>()) return *map;
  const List* list = value.get<List>();
  if (value.is_nil() || (list && list->empty())) return {};
  return {{type.main_field, value}};
}

List full_list(const Value& value) {
  if (const List* list = value.get<List>()) return *list;
  const Map* map = value.get<Map>();
  return value.is_nil() || (map && map->empty()) ? List{} : List{value};
}

std::string text_of(const Value& table, const char* key) {
  const Value* value = table.find(key);
  const std::string* text = value ? value->get<std::string>() : nullptr;
  return text ? *text : "";
}

bool names_color(const Value* material) {
  if (!material || material->is_nil()) return false;
  return !material->is<Map>() || material->find("color");
}

Value merged_structure(const Type& type, const Value& base, const Value& over) {
  if (type.main_field.empty() && !full_list(over).empty() && !over.is<Map>()) return over;  // no table: told by who reads it
  Value result = full_form(type, base);
  Map& map = *result.get<Map>();
  // A node's color is its material's: the one that the copy writes holds.
  if (&type == &type_of<NodeDef>() && names_color(over.find("material"))) remove_key(map, "color");
  for (const auto& [key, value] : full_form(type, over)) {
    const Field* field = type.field(key);
    const Field* twin = type.field_in_degrees(key);
    if (twin) remove_key(map, twin->name);
    if (field && field->angle) remove_key(map, field->name + "_degrees");
    const Value* before = result.find(key);
    result[key] = field && before ? merged(*field->type, *before, value) : value;
  }
  return result;
}

Value merged_map(const Value& base, const Value& over) {
  if (full_list(over).empty()) return base;
  if (!base.is<Map>() || !over.is<Map>()) return over;
  Value result = base;
  for (const auto& [key, value] : *over.get<Map>()) {
    const Value* before = result.find(key);
    if (value.is_nil()) remove_key(*result.get<Map>(), key);
    else if (before && before->is<Map>() && value.is<Map>()) result[key] = merged_map(*before, value);
    else result[key] = value;
  }
  return result;
}

Value merged_children(const Value& base, const Value& over) {
  List children = full_list(base);
  for (const Value& child : full_list(over)) {
    const std::string name = text_of(child, "name");
    const auto same = std::find_if(children.begin(), children.end(),
                                   [&](const Value& c) { return !name.empty() && text_of(c, "name") == name; });
    if (same == children.end()) children.push_back(child);
    else *same = merged(type_of<NodeDef>(), *same, child);
  }
  return children;
}

// What joints call `b` in a prefab, and what leads there in a copy.
using Names = std::map<std::string, std::string>;

// ids to paths from the prefab's root.
void collect_ids(const Value& node, const std::string& path, const std::string& file, Names& names) {
  if (const std::string id = text_of(node, "id"); !id.empty()) names[id] = path;
  const Value* children = node.find("children");
  for (const Value& child : children ? full_list(*children) : List{}) {
    const std::string name = text_of(child, "name");
    if (name.empty() && child.find("id"))
      fail(file, ": the node with id '", text_of(child, "id"), "' has no name; nodes with ids in prefabs need one");
    collect_ids(child, path.empty() ? name : path + "/" + name, file, names);
  }
}

void rename_in(Value& node, const std::string& copy_id, const Names& names) {
  if (const std::string id = text_of(node, "id"); !id.empty()) {
    if (copy_id.empty()) remove_key(*node.get<Map>(), "id");
    else node["id"] = copy_id + "/" + id;
  }
  if (const Value* joints = node.find("joints")) {
    List list = full_list(*joints);
    for (Value& joint : list)
      if (const auto found = names.find(text_of(joint, "b")); found != names.end()) joint["b"] = found->second;
    node["joints"] = list;
  }
  if (const Value* children = node.find("children")) {
    List list = full_list(*children);
    for (Value& child : list) rename_in(child, copy_id, names);
    node["children"] = list;
  }
}

}  // namespace

Value merged(const Type& type, const Value& base, const Value& over) {
  if (type.kind == Kind::optional) return over.is_nil() ? over : merged(*type.element, base, over);
  if (type.kind == Kind::structure) return merged_structure(type, base, over);
  if (type.kind == Kind::map) return merged_map(base, over);
  if (type.kind == Kind::list && type.element == &type_of<NodeDef>()) return merged_children(base, over);
  return over;
}

Value prefab_copy(const Value& prefab, const Value& over, const std::string& file) {
  Value copy = prefab;
  const std::string old_name = text_of(prefab, "name");
  const std::string name = over.find("name") ? text_of(over, "name") : old_name;
  Names names;
  collect_ids(prefab, "", file, names);
  for (auto& [id, path] : names)
    if (path.empty()) path = name;
  if (!old_name.empty()) names.emplace(old_name, name);
  rename_in(copy, text_of(over, "id"), names);
  if (Map* map = copy.get<Map>()) remove_key(*map, "id");
  return copy;
}

}  // namespace tumble
