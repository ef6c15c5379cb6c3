// A scene file that was saved while the game plays.
#include "engine/scene_file.h"
#include "script/bind.h"
#include "script/script.h"

namespace tumble {

namespace {

Value without_children(const NodeDef& def) {
  NodeDef copy = def;
  copy.children.clear();
  copy.behaviours.clear();
  copy.joints.clear();
  Value value = to_value(copy);
  std::erase_if(*value.get<Map>(), [](const auto& entry) { return entry.first == "children" || entry.first == "behaviours" || entry.first == "joints" || entry.first == "id"; });
  return value;
}

}  // namespace

// Nodes are the same where their names lead to the same path; what a node says differently now is applied to it.
std::string Script::reload_scene() {
  if (live_.scene_name.empty()) return "";
  std::string text;
  guarded([&] {
    const NodeDef now = load_scene_file(live_.scene_name, host_.read, "scene.load");
    const bool same_nodes = apply_scene_changes(loaded_def_, now, live_.scene_root, text);
    if (!same_nodes) text += ", " + live_.scene_name + ": nodes were added or removed: F5 loads them";
    loaded_def_ = now;
  });
  return text;
}

void Script::declare_behaviours(const NodeDef& before, const NodeDef& now, NodeId node, std::string& text) {
  for (const auto& [name, properties] : now.behaviours) {
    const auto was = before.behaviours.find(name);
    if (was != before.behaviours.end() && was->second == properties) continue;
    push_boot(running_, "declare");
    push_node(node);
    lua_pushlstring(running_, name.data(), name.size());
    push_value(running_, properties);
    lua_call(running_, 3, 0);
    text += ", " + now.name + ".behaviours." + name;
  }
}

bool Script::apply_scene_changes(const NodeDef& before, const NodeDef& now, NodeId node, std::string& text) {
  if (live_.alive(node)) {
    const Value old = without_children(before), fresh = without_children(now);
    for (const auto& [field, value] : *fresh.get<Map>()) {
      const Value* was = old.find(field);
      if (was && *was == value) continue;
      live_.set_field(node, field, value, live_.scene_name);
      live_.update_first_state(node, field, value);
      text += ", " + now.name + "." + field;
    }
    declare_behaviours(before, now, node, text);
  }
  if (before.children.size() != now.children.size()) return false;
  const NodeId parent = node;
  bool same = true;
  for (std::size_t i = 0; i < now.children.size(); ++i) {
    if (now.children[i].name != before.children[i].name) return false;
    if (!live_.scene.get(parent)) continue;
    if (const NodeId child = live_.scene.find(now.children[i].name, parent)) same &= apply_scene_changes(before.children[i], now.children[i], child, text);
  }
  return same;
}

}  // namespace tumble
