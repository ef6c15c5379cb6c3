// Models and clips as scripts meet them.
#include <catch2/catch.hpp>

#include "assets/gltf_writer.h"
#include "support/test_game.h"

using namespace tumble;

TEST_CASE("models: a script plays one clip after the other", "[script]") {
  TestGame game({{"cube.glb", cube_glb()}, {"main.lua", R"(
    local box = scene.add { name = "box", mesh = { file = "cube.glb" }, animation = { clip = "open", loop = false },
      children = { { name = "lid" } } }
    function box.on_animation_end(clip)
      print(clip, box.animation.playing, scene.get("lid").position)
      if clip == "open" then
        box.animation.clip = "bounce"
        box.animation.playing = true
      end
    end
  )"}});
  REQUIRE(game.started);

  game.tick(150);

  // After 2 m along x the other clip: up to a height of 3 m.
  CHECK(game.printed() == "open\tfalse\tvec3(2, 2, 0)\nbounce\tfalse\tvec3(0, 3, 0)\n");
  CHECK(game.failures.empty());
}

TEST_CASE("models: a file that is not there is said when it is declared, with the nearest name", "[script]") {
  TestGame game({{"models/tree.glb", cube_glb()}, {"main.lua", R"(
    for i = 1, 3 do scene.add { mesh = { file = "models/tre.glb" }, material = { texture = "bark.png" } } end
  )"}});
  game.tick(2);

  std::string warnings;
  for (const LogLine& line : game.log)
    if (line.level == LogLevel::warning) warnings += line.text + "\n";
  CHECK(warnings ==
        "mesh: no file 'models/tre.glb' in the game; did you mean 'models/tree.glb'?; a pink box stands in\n"
        "picture: no file 'bark.png' in the game; it is drawn in pink\n");
}

TEST_CASE("models: a mesh with nothing but a file says that it is a mesh, and a model can be looked for", "[script]") {
  TestGame game({{"cube.glb", cube_glb()}, {"main.lua", R"(
    local box = scene.add { name = "box", mesh = { file = "cube.glb" }, body = "static" }
    function update()
      game.report.kind = box.mesh.shape == "mesh" and 1 or 0
      local hit = physics.raycast(vec3(0, 10, 0), -vec3.up, 20)
      game.report.top = hit and hit.point.y
    end
  )"}});
  game.tick(3);

  CHECK(game.number("kind") == 1);
  CHECK(game.number("top") == Approx(2.5).margin(2e-3));  // the lid's top; Bullet's margin
}
