#include "app/game.h"

#include <algorithm>

#include "app/debug_view.h"
#include "app/error_screen.h"
#include "assets/game_path.h"
#include "base/text.h"
#include "platform/files.h"

namespace tumble {

namespace {

ScriptError public_error(const ScriptFailure& failure) {
  return {failure.text, failure.traceback, failure.file, failure.line, failure.source};
}

}  // namespace

Game::Game(const std::string& path, const GameHost& host) : host_(host) {
  package_ = Package::open(path);
  const std::optional<std::string> settings = read("game.json");
  if (settings && settings->find_first_not_of(" \t\r\n") == std::string::npos)
    fail("game.json: it is empty; write {} or leave the file out for a game with all defaults");
  engine_ = std::make_unique<Engine>(read_settings(settings.value_or(""), "game.json"));
  engine_->particles.set_drawn(host.options.window || host.options.offscreen);
  engine_->input.set_actions(engine_->settings.actions);
  // A hint of the engine is said once, however often its cause comes back.
  engine_->log = [this](const LogLine& line) {
    if (hints_.insert(line.text).second) note(line.level, line.text);
  };
  // The library says each thing once itself, and again when a file was saved and is still faulty.
  assets_ = std::make_unique<AssetLibrary>([this](const std::string& file) { return read(file); },
                                           [this](const LogLine& line) { note(line.level, line.text); }, [this] { return package_->list(); });
  engine_->assets = assets_.get();
  ScriptHost script_host;
  script_host.read = [this](const std::string& file) { return read(file); };
  script_host.list = [this](const std::string& prefix) { return package_->list(prefix); };
  if (package_->folder()) script_host.write = [this](const std::string& file, const std::string& text) { write(file, text); };
  script_host.log = [this](const LogLine& line) { note(line.level, line.text); };
  script_host.on_error = [this](const ScriptFailure& failure) {
    if (host_.on_error) host_.on_error(public_error(failure));
  };
  script_host.entry = package_->entry();
  script_host.memory_limit = host.options.memory_limit;
  script_host.time_limit = host.options.time_limit;
  script_host.bot = host.options.bot;
  script_ = std::make_unique<Script>(*engine_, std::move(script_host));
  script_->set_seed(host.options.seed);
  for (const HostFunction& function : host.functions) script_->add_host_function(function);
  if (host.options.watch && package_->folder()) watch_ = std::make_unique<Watch>(*package_->folder());
}

Game::~Game() {
  if (storage_file_) storage_file_->keep(script_->storage, true);
}

std::optional<std::string> Game::read(const std::string& path) const {
  return host_.read_file ? host_.read_file(path) : package_->read(path);
}

void Game::write(const std::string& path, const std::string& text) const {
  require_game_path(path);
  try {
    write_whole_file(*package_->folder() / path, text);
  } catch (const Error& error) {
    fail("'", path, "' cannot be written: ", error.what());
  }
}

void Game::note(LogLevel level, const std::string& text) {
  recent_log_.emplace_back(ticks_, LogLine{level, text});
  if (recent_log_.size() > 12) recent_log_.erase(recent_log_.begin());
  if (host_.on_log) host_.on_log(level, text);
}

// ---- storage

void Game::open_storage(const Stored& kept) {
  const Options& o = host_.options;
  if (replay_) return script_->begin_storage(replay_->stored);
  if (o.storage.empty() || o.bot) return script_->begin_storage(kept);
  const std::string name = storage_name(package_->name(), settings().title, settings().author);
  storage_file_.emplace(std::filesystem::path(o.storage) / name, [this](const LogLine& line) { note(line.level, line.text); });
  script_->begin_storage(storage_file_->read());
}

void Game::keep_storage() {
  if (storage_file_) storage_file_->keep(script_->storage, false);
}

void Game::start() { script_->load(); }

void Game::poll_changes() {
  if (!watch_) return;
  const std::vector<std::string> changed = watch_->poll();
  if (!changed.empty()) reload(changed);
}

void Game::reload(const std::vector<std::string>& changed) {
  if (std::find(changed.begin(), changed.end(), "game.json") != changed.end()) note(LogLevel::note, "game.json changed: F5 takes it");
  std::vector<std::string> read_again;
  for (const std::string& file : changed)
    for (const std::string& old : assets_->forget(file)) read_again.push_back(old);
  if (!read_again.empty()) engine_->files_changed(read_again);
  const std::string text = script_->reload(changed);
  if (!text.empty()) note(LogLevel::note, text);
  else if (!read_again.empty()) note(LogLevel::note, "reloaded " + join(read_again));
}

// ---- recording

void Game::replay(Recording recording) { replay_ = std::move(recording); }

Recording Game::recording() const {
  Recording recording;
  recording.game = settings().title;
  recording.seed = script_->seed();
  recording.stored = script_->storage.first();
  recording.tick_rate = settings().tick_rate;
  recording.events = recorded_;
  recording.ticks = static_cast<std::uint64_t>(ticks_);
  recording.hash = hash();
  return recording;
}

std::vector<InputEvent> Game::replayed_events() {
  std::vector<InputEvent> events;
  while (replay_at_ < replay_->events.size() && replay_->events[replay_at_].first <= static_cast<std::uint64_t>(ticks_))
    events.push_back(replay_->events[replay_at_++].second);
  return events;
}

// Motion without anything between is one event: a fast mouse would otherwise fill the recording of a long game.
void Game::join_motion(std::vector<InputEvent>& events) {
  std::vector<InputEvent> joined;
  for (InputEvent& event : events) {
    const bool goes_on = event.kind == InputKind::pointer_move && !joined.empty() && joined.back().kind == event.kind;
    if (goes_on) {
      event.dx += joined.back().dx;
      event.dy += joined.back().dy;
      joined.back() = std::move(event);
    } else {
      joined.push_back(std::move(event));
    }
  }
  events = std::move(joined);
}

void Game::take_screen_shape(std::vector<InputEvent>& events) {
  for (const InputEvent& event : events)
    if (event.kind == InputKind::value && event.name == kScreenShape) script_->aspect = event.value;
  std::erase_if(events, [](const InputEvent& event) { return event.name == kScreenShape; });
}

void Game::screen_shape(double aspect, std::vector<InputEvent>& events) const {
  if (aspect == script_->aspect) return;
  InputEvent event;
  event.kind = InputKind::value;
  event.name = kScreenShape;
  event.value = aspect;
  events.insert(events.begin(), event);
}

// ---- what is drawn beside the scene

void Game::add_script_drawing(DrawList& list) {
  for (const Drawing* drawing : {standing_ ? &*standing_ : nullptr, &script_->tick_drawing(), &script_->frame_drawing()}) {
    if (!drawing) continue;
    for (std::size_t i = 0; i < drawing->lines.size(); ++i) {
      DrawLine line = drawing->lines[i];
      const Vec3 from = drawing->ends[i].first - list.origin, to = drawing->ends[i].second - list.origin;
      line.from = {static_cast<float>(from.x), static_cast<float>(from.y), static_cast<float>(from.z)};
      line.to = {static_cast<float>(to.x), static_cast<float>(to.y), static_cast<float>(to.z)};
      list.lines.push_back(line);
    }
    list.ui.insert(list.ui.end(), drawing->ui.begin(), drawing->ui.end());
  }
}

void Game::next_debug_view() {
  const auto view = static_cast<int>(script_->module_settings().debug_view);
  script_->set_debug_view(static_cast<DebugView>((view + 1) % static_cast<int>(enum_names(DebugView{}).size())));
}

void Game::add_debug(DrawList& list, double alpha, double aspect) {
  std::vector<DebugQuery> queries = script_->tick_drawing().queries;
  for (const Drawing* drawing : {standing_ ? &*standing_ : nullptr, &script_->frame_drawing()})
    if (drawing) queries.insert(queries.end(), drawing->queries.begin(), drawing->queries.end());
  add_debug_view(list, *engine_, script_->module_settings().debug_view, queries, alpha, aspect, script_->dropped_seconds);
}

void Game::add_log_overlay(DrawList& list, double aspect) {
  std::vector<std::pair<std::string, Color>> lines;
  const auto kept = static_cast<std::int64_t>(5 * settings().tick_rate);
  for (const auto& [tick, line] : recent_log_) {
    if (tick + kept < ticks_) continue;
    const Color colors[] = {{1, 1, 1, 1}, {0.7, 0.95, 0.7, 1}, {1, 0.85, 0.4, 1}, {1, 0.5, 0.45, 1}};
    lines.emplace_back(line.text.size() > 140 ? line.text.substr(0, 137) + "..." : line.text, colors[static_cast<int>(line.level)]);
  }
  add_lines(list, lines, aspect);
  auto watches = script_->tick_drawing().watches;
  watches.insert(watches.end(), script_->frame_drawing().watches.begin(), script_->frame_drawing().watches.end());
  add_watches(list, watches, aspect);
}

}  // namespace tumble
