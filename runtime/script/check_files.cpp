// Scene files, what they name, and what nothing reaches.
#include <algorithm>

#include "base/text.h"
#include "engine/node_def.h"
#include "engine/scene_file.h"
#include "script/check_parts.h"

namespace tumble {

namespace {

void check_asset(Check& check, const std::string& file, const std::string& what, const std::string& path) {
  if (path.empty() || check.has_file(path)) return;
  check.error(file, 0, what + ": no file '" + path + "' in the game" + did_you_mean(path, check.game.files));
}

void check_node(Check& check, const std::string& file, const std::string& place, const NodeDef& node) {
  if (node.mesh) check_asset(check, file, place + "mesh", node.mesh->file);
  if (node.material) check_asset(check, file, place + "material.texture", node.material->texture);
  if (node.sound) check_asset(check, file, place + "sound", node.sound->file);
  if (node.particles) check_asset(check, file, place + "particles.texture", node.particles->texture);
  if (node.animation) check_asset(check, file, place + "animation", node.animation->file);
  for (const auto& [name, properties] : node.behaviours)
    if (!check.has_script(name))
      check.error(file, 0, place + "behaviours: no file '" + name + ".lua' in the game or in scripts/std" + did_you_mean(name, check.script_names()));
  if (node.body && !node.body->group.empty()) {
    const auto& groups = check.settings.physics.groups;
    if (std::find(groups.begin(), groups.end(), node.body->group) == groups.end())
      check.error(file, 0, place + "body.group: no group '" + node.body->group + "' in the physics.groups of game.json" + did_you_mean(node.body->group, groups));
  }
  for (const NodeDef& child : node.children)
    check_node(check, file, place + (child.name.empty() ? "" : child.name + ": "), child);
}

void check_scene_file(Check& check, const std::string& path) {
  try {
    check_node(check, path, "", load_scene_file(path.substr(0, path.size() - 5), check.game.read, path));
  } catch (const Error& error) {
    const std::string text = error.what();
    check.error(path, 0, text.starts_with(path + ": ") ? text.substr(path.size() + 2) : text);
  }
}

// ---- what can be reached: from the entry, the start scene, the bot and the tests

struct Reach {
  Check& check;
  std::set<std::string> seen;

  void file(const std::string& path) {
    if (!check.has_file(path) || !seen.insert(path).second) return;
    if (path.ends_with(".json")) value(check.scenes[path]);
    for (const LuaText& text : check.texts)
      if (text.path == path) words(text);
  }
  // Any word may name a script or a scene: whoever says it is taken to use it.
  void word(const std::string& name) {
    file(name);
    file(name + ".lua");
    file(name + ".json");
  }
  void words(const LuaText& text) {
    for (std::size_t i = 0; i < text.tokens.size(); ++i) {
      const Token& token = text.tokens[i];
      if (token.is_name()) word(token.text);
      if (!token.is_text()) continue;
      word(token.text);
      if (!text.tokens[i + 1].is("..") || token.text.empty()) continue;
      for (const std::string& path : check.game.files)
        if (path.starts_with(token.text)) file(path);
    }
  }
  void value(const Value& v) {
    if (const std::string* text = v.get<std::string>()) word(*text);
    if (const List* list = v.get<List>())
      for (const Value& entry : *list) value(entry);
    if (const Map* map = v.get<Map>())
      for (const auto& [key, entry] : *map) {
        word(key);
        value(entry);
      }
  }
};

void check_reach(Check& check) {
  if (check.game.entry != "main.lua") return;  // one file of a folder: what lies beside it is not its own
  Reach reach{check, {}};
  reach.file(check.game.entry);
  reach.file("bot.lua");
  reach.word(check.settings.start_scene);
  for (const LuaText& text : check.texts)
    if (text.path.starts_with("tests/")) reach.file(text.path);
  for (const LuaText& text : check.texts)
    if (text.of_engine) reach.words(text);
  for (const LuaText& text : check.texts)
    if (!text.of_engine && !reach.seen.count(text.path)) check.warn(text.path, 0, "nothing requires this script or has it as a behaviour");
  for (const auto& [path, scene] : check.scenes)
    if (!reach.seen.count(path)) check.warn(path, 0, "unreachable: nothing loads this scene or copies this prefab");
}

}  // namespace

void check_scenes(Check& check) {
  const std::string& start = check.settings.start_scene;
  if (!start.empty() && !check.has_file(start + ".json"))
    check.error("game.json", 0, "start_scene: no file '" + start + ".json' in the game" + did_you_mean(start, check.scene_names()));
  check_asset(check, "game.json", "icon", check.settings.icon);
  const auto scenes = check.scenes;
  for (const auto& [path, scene] : scenes) check_scene_file(check, path);
  check_reach(check);
}

}  // namespace tumble
