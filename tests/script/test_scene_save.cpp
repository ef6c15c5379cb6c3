// scene.save writes what scene.load reads.
#include <catch2/catch.hpp>

#include "support/test_game.h"

using namespace tumble;

namespace {

const Files kGame = {
    {"main.lua", "function on_press(name)\n  if name == 's' then scene.save('levels/two') end\n  if name == 'l' then scene.load('levels/two') end\n"
                 "  if name == 'm' then local n = scene.get('crate') n.behaviours.mover.speed = 7 n.color = 'red' scene.get('post').position = vec3(1, 2, 3) end\nend\n"},
    {"mover.lua", "return behaviour { speed = 2, target = property.node(), path = vec3(0, 0, 0) }\n"},
    {"game.json", R"({ "start_scene": "levels/one" })"},
    {"levels/one.json", R"({ "tumble": 1, "name": "one", "children": [
       { "name": "post", "mesh": "box", "body": "static" },
       { "name": "crate", "position": [0, 1.5, 0], "rotation_degrees": [0, 30, 0], "mesh": { "shape": "box", "size": [1, 2, 1] },
         "body": { "mass": 5 }, "behaviours": { "mover": { "target": "post", "path": [1, 0, 0] } },
         "joints": [ { "type": "hinge", "name": "h", "b": "post", "anchor": [0, 1, 0], "axis": [1, 0, 0], "max_degrees": 80 } ] } ] })"}};

}  // namespace

TEST_CASE("scene.save: what it writes loads again to the same scene", "[scene]") {
  TestGame game(kGame);
  game.tick(1, {press("m")});
  game.tick(1, {press("s")});
  REQUIRE(game.last_error() == "");
  const std::string first = game.files.at("levels/two.json");

  game.tick(1, {press("l")});
  game.tick(1, {release("s"), press("s")});

  CHECK(game.last_error() == "");
  const NodeId crate = game.node("crate");
  CHECK(game.position("post") == Vec3{1, 2, 3});
  CHECK(game.engine->scene[crate].material->color.r == 1);
  CHECK(game.engine->body(crate)->def.mass == 5);
  CHECK(game.engine->find_joint(crate, "h"));
  CHECK(game.script->get_path("crate", "behaviours.mover.speed")->number() == 7);
  CHECK(game.script->get_path("crate", "behaviours.mover.target.name") == Value("post"));
  CHECK(*game.script->get_path("crate", "behaviours.mover.path")->get<Vec3>() == Vec3{1, 0, 0});
  CHECK(first.find("\"speed\": 7") != std::string::npos);
}
