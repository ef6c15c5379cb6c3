// game.json: what a game says of itself before its scripts run.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/describe.h"
#include "physics/world.h"

namespace tumble {

struct WindowSettings {
  int width = 1280, height = 720;
  bool fullscreen = false;
};
void describe(WindowSettings& window, Schema& s);

struct SoundSettings {
  std::vector<std::string> groups;       // beside "effects" and "music"
};
void describe(SoundSettings& sound, Schema& s);

struct GameSettings {
  std::string title = "Tumble", version, author, icon;
  std::string start_scene;               // path without ending; "" is an empty scene
  double tick_rate = 60;                 // Hz
  WindowSettings window;
  WorldSettings physics;
  SoundSettings sound;
  std::map<std::string, std::vector<std::string>> actions;  // name -> raw names
};
void describe(GameSettings& settings, Schema& s);

// `text` is the file's; an empty text gives the defaults. Throws Error that names the file, the path in it and, for a
// syntax error, the line.
GameSettings read_settings(const std::string& text, const std::string& file);

}  // namespace tumble
