#include "engine/settings.h"

#include "assets/game_path.h"
#include "engine/input_map.h"
#include "engine/json.h"

namespace tumble {

namespace {

void check_settings(const GameSettings& settings) {
  if (!settings.start_scene.empty()) {
    require_game_path(settings.start_scene);
    if (settings.start_scene.ends_with(".json"))
      fail("start_scene is written without '.json' (got '", settings.start_scene, "')");
  }
  if (!settings.icon.empty()) require_game_path(settings.icon);
  InputMap().set_actions(settings.actions);  // throws for a raw name that no device has
}

}  // namespace

void describe(WindowSettings& window, Schema& s) {
  s.name("window", "The window's size.");
  s.add("width", window.width, "Pixels.").between(1, 16384);
  s.add("height", window.height, "Pixels.").between(1, 16384);
  s.add("fullscreen", window.fullscreen, "Start in full screen?");
}

void describe(SoundSettings& sound, Schema& s) {
  s.name("sound_settings", "What is to be known of sounds before any plays.");
  s.add("groups", sound.groups, "Groups of sounds with a volume of their own, beside \"effects\" and \"music\": [\"voices\"].");
}

void describe(GameSettings& settings, Schema& s) {
  s.name("game", "game.json: what a game says of itself before its scripts run.");
  s.add("title", settings.title, "Stands in the window's title.");
  s.add("version", settings.version, "The game's own version, as you like to write it.");
  s.add("author", settings.author, "Who made it.");
  s.add("icon", settings.icon, "A picture file for the window and the package.");
  s.add("start_scene", settings.start_scene, "Scene to load at the start, without ending; empty: none.");
  s.add("tick_rate", settings.tick_rate, "Ticks of game logic and physics in a second, Hz.").between(10, 1000);
  s.add("window", settings.window, "The window.");
  s.add("physics", settings.physics, "The physical world; the same keys as the module's.");
  s.add("sound", settings.sound, "Groups of sounds.");
  s.add("actions", settings.actions,
        "Names for input, each with the raw names that trigger it: \"jump\": [\"space\", \"pad_a\"].");
  s.check<GameSettings>(check_settings);
}

GameSettings read_settings(const std::string& text, const std::string& file) {
  GameSettings settings;
  if (text.empty()) return settings;
  const Value value = parse_json(text, file);
  if (!value.is<Map>()) fail(file, ": a table { ... } expected, got ", kind_name(value));
  assign(settings, value, file);
  return settings;
}

}  // namespace tumble
