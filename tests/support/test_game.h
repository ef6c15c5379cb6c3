// A game made of texts, for tests of scripts: ticks it as app/frame.cpp does, without a package or a window.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "script/script.h"

using Files = std::map<std::string, std::string>;

class TestGame {
 public:
  // Paths and texts; "main.lua" runs first.
  explicit TestGame(Files files, double time_limit = 1, std::uint64_t seed = 1);

  void tick(int count = 1, std::vector<tumble::InputEvent> events = {});
  // Saves a file and lets the game notice. Returns the log line of the reload.
  std::string save(const std::string& path, const std::string& text);
  // Calls frame(dt) without ticking.
  void frame() { script->frame(1.0 / 60); }

  std::string printed() const;                   // all that print() wrote, a line each
  std::string last_error() const { return failures.empty() ? "" : failures.back().text; }
  double number(const std::string& name) const;  // game.report.name; NaN where there is none
  tumble::NodeId node(const std::string& path) const { return engine->scene.find(path); }
  tumble::Vec3 position(const std::string& path) const { return engine->scene.world(node(path)).position; }

  Files files;
  std::vector<tumble::LogLine> log;
  std::vector<tumble::ScriptFailure> failures;
  std::unique_ptr<tumble::AssetLibrary> assets;
  std::unique_ptr<tumble::Engine> engine;
  std::unique_ptr<tumble::Script> script;
  bool started = false;
};

tumble::InputEvent press(const std::string& name);
tumble::InputEvent release(const std::string& name);
