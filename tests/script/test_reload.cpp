// What a student expects of a save while the game runs.
#include <catch2/catch.hpp>

#include "support/test_game.h"

using namespace tumble;

namespace {

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

const std::string kCounter = R"(
local speed = 2
local score = 0
local ball = scene.add { name = "ball", position = vec3(0, 3, 0), color = "orange" }
local function step() return speed end
function update(dt)
  score = score + step()
  game.report.score = score
  game.report.red = ball.color.r
end
)";

}  // namespace

TEST_CASE("reload: a text that did not change changes nothing", "[reload]") {
  TestGame game(Files{{"main.lua", kCounter}});
  game.tick(5);
  const std::uint64_t before = game.script->hash();

  const std::string line = game.save("main.lua", kCounter);

  CHECK(game.script->hash() == before);
  CHECK(line == "reloaded main.lua: code only, all values kept");
  game.tick(1);
  CHECK(game.number("score") == 12);
}

TEST_CASE("reload: a changed initial value is taken, other locals keep theirs", "[reload]") {
  TestGame game(Files{{"main.lua", kCounter}});
  game.tick(5);

  const std::string line = game.save("main.lua", replaced(kCounter, "speed = 2", "speed = 10"));
  game.tick(1);

  CHECK(game.number("score") == 20);
  CHECK(line.find("speed = 10") != std::string::npos);
}

TEST_CASE("reload: a changed function runs from the next call on", "[reload]") {
  TestGame game(Files{{"main.lua", kCounter}});
  game.tick(5);

  game.save("main.lua", replaced(kCounter, "return speed", "return speed * 100"));
  game.tick(1);

  CHECK(game.number("score") == 210);
}

TEST_CASE("reload: a declared node takes a changed colour and keeps its place", "[reload]") {
  TestGame game(Files{{"main.lua", kCounter}});
  game.tick(1);
  game.engine->set_position(game.node("ball"), {7, 8, 9});

  game.save("main.lua", replaced(kCounter, "\"orange\"", "\"black\""));
  game.tick(1);

  CHECK(game.number("red") == 0);
  CHECK(game.position("ball") == Vec3{7, 8, 9});
}

TEST_CASE("reload: a node inserted above leaves its neighbours as they are", "[reload]") {
  const std::string before = "scene.add { color = 'red', position = vec3(1, 0, 0) }\nscene.add { color = 'lime', position = vec3(2, 0, 0) }\n";
  TestGame game(Files{{"main.lua", before}});
  game.tick(1);
  const std::size_t count = game.engine->scene.size();
  const NodeId red = game.engine->scene[game.engine->scene.root()].children.front();
  const Color color = game.engine->scene[red].material->color;

  game.save("main.lua", "scene.add { color = 'blue' }\n" + before);
  game.tick(1);

  CHECK(game.engine->scene.size() == count + 1);
  CHECK(game.engine->scene[red].material->color == color);
}

TEST_CASE("reload: a declaration that is gone takes its node away", "[reload]") {
  TestGame game(Files{{"main.lua", "scene.add { name = 'a' }\nscene.add { name = 'b' }\n"}});
  game.tick(1);

  game.save("main.lua", "scene.add { name = 'a' }\n");
  game.tick(1);

  CHECK(game.node("a"));
  CHECK_FALSE(game.node("b"));
}

TEST_CASE("reload: a node destroyed in play stays gone and does not trouble later saves", "[reload]") {
  const std::string text = "local coin = scene.add { name = 'coin' }\nfunction on_press() coin:destroy() end\n";
  TestGame game(Files{{"main.lua", text}});
  game.tick(1, {press("space")});
  REQUIRE_FALSE(game.node("coin"));

  game.save("main.lua", text + "-- a comment\n");
  game.tick(1);

  CHECK_FALSE(game.node("coin"));
  CHECK(game.failures.empty());
}

TEST_CASE("reload: a syntax error leaves the old code running and is cleared by the next good save", "[reload]") {
  TestGame game(Files{{"main.lua", kCounter}});
  game.tick(5);

  game.save("main.lua", kCounter + "function (");
  game.tick(5);

  CHECK(game.number("score") == 20);
  REQUIRE(game.script->shown_error);
  CHECK(game.script->shown_error->line == 11);
  CHECK(game.script->shown_error->source == "function (");

  game.save("main.lua", kCounter);
  CHECK_FALSE(game.script->shown_error);
}

TEST_CASE("reload: an error half way down the file changes nothing", "[reload]") {
  TestGame game(Files{{"main.lua", kCounter}});
  game.tick(5);
  const std::size_t nodes = game.engine->scene.size();

  game.save("main.lua", "scene.add { name = 'new' }\nphysics.gravity = vec3(0, -1, 0)\n" + kCounter + "error('no')\n");
  game.tick(1);

  CHECK(game.engine->scene.size() == nodes);
  CHECK(game.script->module_settings().physics.gravity.y == -9.81);
  CHECK(game.number("score") == 12);
  CHECK(game.last_error().find("no") != std::string::npos);
}

TEST_CASE("reload: an act at the top level is refused even inside pcall", "[reload]") {
  TestGame game(Files{{"main.lua", kCounter}});

  game.save("main.lua", kCounter + "pcall(game.finish)\n");

  CHECK_FALSE(game.script->finished);
  CHECK(game.script->shown_error);
}

TEST_CASE("reload: a behaviour's changed default reaches living instances, and its state is kept", "[reload]") {
  const std::string mover = "local Mover = behaviour { speed = 1 }\nfunction Mover:start() self.steps = 0 end\n"
                            "function Mover:update(dt) self.steps = self.steps + 1 game.report.steps = self.steps game.report.speed = self.speed end\nreturn Mover\n";
  TestGame game(Files{{"main.lua", "scene.add { name = 'm', behaviours = { mover = {} } }"}, {"mover.lua", mover}});
  game.tick(4);
  REQUIRE(game.failures.empty());

  const std::string line = game.save("mover.lua", replaced(mover, "speed = 1", "speed = 8"));
  game.tick(1);

  CHECK(game.number("speed") == 8);
  CHECK(game.number("steps") == 5);
  CHECK(line.find("mover.speed = 8") != std::string::npos);
}

TEST_CASE("reload: a property that the declaration gives stays when the default changes", "[reload]") {
  const std::string mover = "local Mover = behaviour { speed = 1 }\nfunction Mover:update(dt) game.report.speed = self.speed end\nreturn Mover\n";
  TestGame game(Files{{"main.lua", "scene.add { name = 'm', behaviours = { mover = { speed = 3 } } }"}, {"mover.lua", mover}});
  game.tick(1);

  game.save("mover.lua", replaced(mover, "speed = 1", "speed = 8"));
  game.tick(1);

  CHECK(game.number("speed") == 3);
}

TEST_CASE("reload: a behaviour's new method is used and a failed one gets another chance", "[reload]") {
  const std::string bad = "local B = behaviour {}\nfunction B:update(dt) error('broken') end\nreturn B\n";
  TestGame game(Files{{"main.lua", "scene.add { name = 'b', behaviours = { b = {} } }"}, {"b.lua", bad}});
  game.tick(3);
  CHECK(game.failures.size() == 1);

  game.save("b.lua", replaced(bad, "error('broken')", "game.report.ok = 1"));
  game.tick(1);

  CHECK(game.number("ok") == 1);
}

TEST_CASE("reload: a module's table keeps its identity and its live values", "[reload]") {
  const std::string module = "local M = { width = 3 }\nM.count = 0\nfunction M.add() M.count = M.count + 1 return M.count * M.width end\nreturn M\n";
  const std::string main = "local court = require 'court'\nlocal kept = court\nfunction update() game.report.n = court.add() game.report.same = kept == court and 1 or 0 end\n";
  TestGame game(Files{{"main.lua", main}, {"court.lua", module}});
  game.tick(2);
  REQUIRE(game.number("n") == 6);

  game.save("court.lua", replaced(module, "width = 3", "width = 10"));
  game.tick(1);

  CHECK(game.number("n") == 30);
  CHECK(game.number("same") == 1);
}

TEST_CASE("reload: a module that only a behaviour of a later scene requires takes part", "[reload]") {
  TestGame game(Files{{"main.lua", "function start() scene.load(\"level\") end\n"},
                      {"level.json", R"({"tumble": 1, "children": [{"name": "a", "behaviours": {"slime": {}}}]})"},
                      {"slime.lua", "local feet = require \"feet\"\nlocal Slime = behaviour {}\nfunction Slime:update() game.report.steps = feet.step() end\nreturn Slime\n"},
                      {"feet.lua", "local feet = { count = 0 }\nfunction feet.step() feet.count = feet.count + 1 return feet.count end\nreturn feet\n"}});
  game.tick(5);
  const double before = game.number("steps");

  game.save("feet.lua", "local feet = { count = 0 }\nfunction feet.step() feet.count = feet.count + 100 return feet.count end\nreturn feet\n");
  game.tick(1);

  CHECK(before > 0);
  CHECK(game.number("steps") == before + 100);
}

TEST_CASE("reload: a setting goes back to its default when its line goes", "[reload]") {
  TestGame game(Files{{"main.lua", "physics.gravity = vec3(0, -1, 0)\n"}});
  CHECK(game.script->module_settings().physics.gravity.y == -1);

  game.save("main.lua", "-- none\n");

  CHECK(game.script->module_settings().physics.gravity.y == -9.81);
}

TEST_CASE("reload: a setting changed in play stays unless its line changes", "[reload]") {
  const std::string text = "physics.gravity = vec3(0, -1, 0)\nfunction on_press() physics.gravity = vec3(0, -5, 0) end\n";
  TestGame game(Files{{"main.lua", text}});
  game.tick(1, {press("space")});

  game.save("main.lua", text + "-- more\n");
  CHECK(game.script->module_settings().physics.gravity.y == -5);
  game.save("main.lua", replaced(text, "-1", "-2"));
  CHECK(game.script->module_settings().physics.gravity.y == -2);
}

TEST_CASE("reload: a task of a named function calls its new text", "[reload]") {
  const std::string text = "function later() game.report.n = 1 end\nfunction start() task.after(0.1, later) end\n";
  TestGame game(Files{{"main.lua", text}});
  game.tick(1);

  game.save("main.lua", replaced(text, "n = 1", "n = 2"));
  game.tick(10);

  CHECK(game.number("n") == 2);
}

TEST_CASE("reload: handler slots of declared nodes take their new text", "[reload]") {
  const std::string text = "local ball = scene.add { name = 'ball' }\nfunction ball.update(dt) game.report.n = 1 end\n";
  TestGame game(Files{{"main.lua", text}});
  game.tick(1);
  REQUIRE(game.number("n") == 1);

  game.save("main.lua", replaced(text, "n = 1", "n = 2"));
  game.tick(1);

  CHECK(game.number("n") == 2);
}

TEST_CASE("reload: random numbers of a top level stay when a line with another call is inserted", "[reload]") {
  const std::string text = "local a = scene.add { name = 'a', position = vec3(random.between(0, 1), 0, 0) }\n";
  TestGame game(Files{{"main.lua", text}});
  const Vec3 before = game.position("a");

  game.save("main.lua", "local x = random.between(5, 6)\n" + text);

  CHECK(game.position("a") == before);
}

TEST_CASE("reload: the time at the top level is always zero", "[reload]") {
  const std::string text = "local born = time.now\nfunction update() game.report.born = born end\n";
  TestGame game(Files{{"main.lua", text}});
  game.tick(10);

  game.save("main.lua", text + "--\n");
  game.tick(1);

  CHECK(game.number("born") == 0);
}

TEST_CASE("reload: start() is not run again, and the line says so where it changed", "[reload]") {
  const std::string text = "local n = 0\nfunction start() n = n + 1 game.report.n = n end\n";
  TestGame game(Files{{"main.lua", text}});
  game.tick(1);

  const std::string line = game.save("main.lua", replaced(text, "n = n + 1", "n = n + 5"));
  game.tick(1);

  CHECK(game.number("n") == 1);
  CHECK(line.find("start() changed: F5 runs it") != std::string::npos);
}

TEST_CASE("reload: a game that is faulty at its start begins with the first good save", "[reload]") {
  TestGame game(Files{{"main.lua", "function ("}});
  REQUIRE_FALSE(game.started);

  CHECK(game.save("main.lua", kCounter) == "loaded");
  game.tick(2);

  CHECK(game.number("score") == 4);
  CHECK_FALSE(game.script->shown_error);
}

TEST_CASE("reload: a behaviour's file that was renamed takes its nodes along", "[reload]") {
  const std::string mover = "local Mover = behaviour {}\nfunction Mover:update(dt) game.report.name = 1 end\nreturn Mover\n";
  TestGame game(Files{{"main.lua", "scene.add { name = 'm', behaviours = { mover = {} } }"}, {"mover.lua", mover}});
  game.tick(1);

  game.files.erase("mover.lua");
  game.files["slider.lua"] = replaced(mover, "= 1", "= 2");
  game.save("main.lua", "scene.add { name = 'm', behaviours = { slider = {} } }");
  game.tick(2);

  CHECK(game.failures.empty());
  CHECK(game.number("name") == 2);
}
