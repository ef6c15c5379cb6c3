// scene.save: the loaded scene as a file, as it is now.
#include "base/text.h"
#include "engine/scene_file.h"
#include "script/bind.h"
#include "script/script.h"

namespace tumble {

namespace {

// A node inside a behaviour's property is written by its lasting id.
void name_nodes(const Scene& scene, Value& value) {
  if (const Reference* reference = value.get<Reference>()) {
    const SceneNode* node = scene.get({reference->index, reference->generation});
    value = node ? Value(node->id) : Value();
  } else if (List* list = value.get<List>()) {
    for (Value& entry : *list) name_nodes(scene, entry);
  } else if (Map* map = value.get<Map>()) {
    for (auto& [key, entry] : *map) name_nodes(scene, entry);
  }
}

}  // namespace

// Properties of the node's behaviours that differ from what their class declares.
std::map<std::string, Value> Script::behaviours_of(NodeId node) {
  lua_State* L = running_;
  call_boot_inside("saved_behaviours", node, 1);
  Value value = value_from_lua(L, -1, "scene.save: behaviours");
  lua_pop(L, 1);
  name_nodes(live_.scene, value);
  std::map<std::string, Value> behaviours;
  if (const Map* map = value.get<Map>())
    for (const auto& [name, properties] : *map) behaviours[name] = properties.is<List>() ? Value(Map{}) : properties;
  return behaviours;
}

NodeDef Script::whole_def(NodeId node) {
  NodeDef def = live_.def(node);
  def.behaviours = behaviours_of(node);
  const std::vector<NodeId> children = live_.scene[node].children;
  for (const NodeId child : children)
    if (live_.alive(child)) def.children.push_back(whole_def(child));
  return def;
}

void Script::save_scene(const std::string& path) {
  if (!host_.write) fail("scene.save: works only in a game's folder, while it is made");
  if (live_.scene_name.empty()) fail("scene.save: no scene is loaded; what main.lua declares is in its text");
  host_.write(path + ".json", write_scene_file(whole_def(live_.scene_root)));
  log(LogLevel::note, "scene saved: " + path + ".json");
}

}  // namespace tumble
