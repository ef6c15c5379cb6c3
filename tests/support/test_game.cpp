#include "support/test_game.h"

#include <limits>

using namespace tumble;

TestGame::TestGame(Files texts, double time_limit, std::uint64_t seed) : files(std::move(texts)) {
  const auto settings = files.find("game.json");
  engine = std::make_unique<Engine>(read_settings(settings == files.end() ? "" : settings->second, "game.json"));
  engine->input.set_actions(engine->settings.actions);
  ScriptHost host;
  host.read = [this](const std::string& path) -> std::optional<std::string> {
    const auto found = files.find(path);
    if (found == files.end()) return std::nullopt;
    return found->second;
  };
  host.list = [this](const std::string&) {
    std::vector<std::string> list;
    for (const auto& [path, text] : files) list.push_back(path);
    return list;
  };
  assets = std::make_unique<AssetLibrary>(host.read, [this](const LogLine& line) { log.push_back(line); }, [list = host.list] { return list(""); });
  engine->assets = assets.get();
  engine->log = [this](const LogLine& line) { log.push_back(line); };
  host.write = [this](const std::string& path, const std::string& text) { files[path] = text; };
  host.on_error = [this](const ScriptFailure& failure) { failures.push_back(failure); };
  host.log = [this](const LogLine& line) { log.push_back(line); };
  host.time_limit = time_limit;
  script = std::make_unique<Script>(*engine, std::move(host));
  script->set_seed(seed);
  started = script->load();
}

void TestGame::tick(int count, std::vector<InputEvent> events) {
  const double dt = 1 / engine->settings.tick_rate;
  for (int i = 0; i < count; ++i) {
    script->take_ui_input(events);
    const auto notices = engine->input.sample(events);
    events.clear();
    script->tick_drawing() = {};
    script->deliver_input(notices);
    if (!script->module_settings().paused) {
      engine->begin_tick();
      script->seconds_now += dt;
      script->run_tasks(dt);
      script->update(dt);
      engine->step(dt);
      script->physics_events(engine->take_events(), script->seconds_now - dt);
      script->animation_events(engine->take_animation_ends());
      script->late_update(dt);
    }
    script->flush();
    script->draw_ui();
    engine->sounds.tick(dt, script->module_settings().paused);
    script->read_report();
    script->collect_garbage();
  }
}

std::string TestGame::save(const std::string& path, const std::string& text) {
  files[path] = text;
  return script->reload({path});
}

std::string TestGame::printed() const {
  std::string text;
  for (const LogLine& line : log)
    if (line.level == LogLevel::print) text += line.text + "\n";
  return text;
}

double TestGame::number(const std::string& name) const {
  for (const auto& [key, value] : script->report)
    if (key == name && value.is_number()) return value.number();
  return std::numeric_limits<double>::quiet_NaN();
}

InputEvent press(const std::string& name) {
  InputEvent event;
  event.name = name;
  return event;
}

InputEvent release(const std::string& name) {
  InputEvent event;
  event.kind = InputKind::release;
  event.name = name;
  return event;
}
