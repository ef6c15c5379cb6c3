#include "engine/settings.h"

#include <catch2/catch.hpp>

using namespace tumble;

namespace {

GameSettings read(const std::string& text) { return read_settings(text, "game.json"); }

std::string error(const std::string& text) {
  try {
    read(text);
  } catch (const Error& e) {
    return e.what();
  }
  return "no error";
}

}  // namespace

TEST_CASE("settings: no text and an empty table give the defaults", "[engine]") {
  for (const char* text : {"", "{}"}) {
    const GameSettings settings = read(text);
    CHECK(settings.title == "Tumble");
    CHECK(settings.tick_rate == 60);
    CHECK(settings.window.width == 1280);
    CHECK(settings.start_scene.empty());
  }
}

TEST_CASE("settings: what game.json says is read", "[engine]") {
  const GameSettings settings = read(R"({ "title": "Heights", "start_scene": "levels/one", "window": { "width": 800 },
    "physics": { "gravity": [0, -1.6, 0], "groups": ["player"] }, "actions": { "jump": ["space", "pad_a"], "use": "e" } })");

  CHECK(settings.title == "Heights");
  CHECK(settings.start_scene == "levels/one");
  CHECK(settings.window.width == 800);
  CHECK(settings.window.height == 720);
  CHECK(settings.physics.gravity == Vec3{0, -1.6, 0});
  CHECK(settings.actions.at("jump") == std::vector<std::string>{"space", "pad_a"});
  CHECK(settings.actions.at("use") == std::vector<std::string>{"e"});
}

TEST_CASE("settings: mistakes are told with file, place and way out", "[engine]") {
  CHECK(error(R"({ "titel": "x" })") == "game.json: no field 'titel'; did you mean 'title'?");
  CHECK(error(R"({ "physics": { "gravty": 1 } })") == "game.json: physics has no field 'gravty'; did you mean 'gravity'?");
  CHECK(error(R"({ "tick_rate": 0 })") == "game.json: tick_rate must be from 10 to 1000 (got 0)");
  CHECK(error(R"({ "window": { "width": 1.5 } })") == "game.json: window.width: whole number expected, got 1.5");
  CHECK(error(R"({ "actions": { "jump": ["spcae"] } })") == "game.json: action 'jump': no key or button 'spcae'; did you mean 'space'?");
  CHECK(error(R"({ "start_scene": "levels/one.json" })") == "game.json: start_scene is written without '.json' (got 'levels/one.json')");
  CHECK(error(R"({ "start_scene": "../one" })").find("game.json: file '../one': '..' is not allowed") == 0);
  CHECK(error("{ \"title\": }").find("game.json:1:12: not JSON: ") == 0);
}
