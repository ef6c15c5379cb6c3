// One loaded game: package, engine, scripts, recording. tick() in frame.cpp is the page to read first.
#pragma once

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "app/storage_file.h"
#include "assets/library.h"
#include "assets/package.h"
#include "assets/watch.h"
#include "engine/engine.h"
#include "engine/replay.h"
#include "script/script.h"

namespace tumble {

// What the program around a game gives it; it outlives the game.
struct GameHost {
  Options options;
  std::vector<HostFunction> functions;
  std::function<void(LogLevel, const std::string&)> on_log;
  std::function<void(const ScriptError&)> on_error;
  std::function<std::optional<std::string>(const std::string&)> read_file;
};

class Game {
 public:
  // Throws Error where the package or its game.json is faulty.
  Game(const std::string& path, const GameHost& host);
  ~Game();

  // What was stored before: on disk, with the recording, or by the same game before its restart.
  void open_storage(const Stored& kept);
  // Runs the scripts for the first time.
  void start();
  // One fixed tick with this input, in the order of api.md section 20.
  void tick(std::vector<InputEvent> events);
  // Looks for saved files and runs the text again.
  void poll_changes();
  void reload(const std::vector<std::string>& changed);
  void say(const std::string& text) { note(LogLevel::note, text); }
  // The picture of now: alpha 0 shows the last tick, 1 this one. Calls the scripts' frame(dt).
  DrawList draw(double alpha, double dt, double aspect);
  // What is to be heard now.
  SoundList heard() const;

  void replay(Recording recording);
  Recording recording() const;

  double tick_seconds() const { return 1 / engine_->settings.tick_rate; }
  Engine& engine() { return *engine_; }
  Script& script() { return *script_; }
  const GameSettings& settings() const { return engine_->settings; }
  const Package& package() const { return *package_; }
  std::int64_t ticks() const { return ticks_; }   // pauses counted
  std::uint64_t hash() const { return script_->hash(); }
  int errors() const { return script_->errors; }
  void next_debug_view();
  bool replaying() const { return replay_ && static_cast<std::uint64_t>(ticks_) < replay_->ticks; }
  // Puts an event in front where the screen's shape is not what the game knows.
  void screen_shape(double aspect, std::vector<InputEvent>& events) const;

 private:
  std::optional<std::string> read(const std::string& path) const;
  void write(const std::string& path, const std::string& text) const;
  void note(LogLevel level, const std::string& text);
  std::vector<InputEvent> replayed_events();
  void keep_storage();
  static void join_motion(std::vector<InputEvent>& events);
  void take_screen_shape(std::vector<InputEvent>& events);
  void add_script_drawing(DrawList& list);
  void add_debug(DrawList& list, double alpha, double aspect);
  void add_log_overlay(DrawList& list, double aspect);

  const GameHost& host_;
  std::unique_ptr<Package> package_;
  std::unique_ptr<Watch> watch_;
  std::unique_ptr<AssetLibrary> assets_;
  std::unique_ptr<Engine> engine_;
  std::unique_ptr<Script> script_;
  std::int64_t ticks_ = 0;
  std::vector<std::pair<std::uint64_t, InputEvent>> recorded_;
  std::optional<Recording> replay_;
  std::optional<StorageFile> storage_file_;
  std::size_t replay_at_ = 0;
  std::set<std::string> hints_;
  std::optional<Drawing> standing_;    // lines and queries of the world's last tick, while it is paused
  std::vector<std::pair<std::int64_t, LogLine>> recent_log_;   // tick and line, for the overlay
};

}  // namespace tumble
