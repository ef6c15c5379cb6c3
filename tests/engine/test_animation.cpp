// Clips on scenes: time, parts, child nodes, kinematic bodies. The file's clip `open` moves the node `lid` 2 m along x
// in 1 s, at a height of 2 m.
#include "assets/gltf_writer.h"
#include "engine/extract.h"
#include "test_engine_support.h"

using namespace tumble;

namespace {

constexpr double kFps = 60;

struct ClipGame : PlainGame {
  ClipGame() { assets = &library; }
  std::string file = cube_glb();
  AssetLibrary library{[this](const std::string& path) -> std::optional<std::string> { return path == "cube.glb" ? std::optional(file) : std::nullopt; },
                       [this](const LogLine& line) { lines.push_back(line.text); }};
  NodeId thing(const Map& animation, const Map& lid = {}) {
    Map child{{"name", "lid"}};
    child.insert(child.end(), lid.begin(), lid.end());
    return make({{"name", "thing"}, {"animation", animation}, {"children", List{child}}});
  }
  double time(NodeId node) { return scene[node].animation->time; }
  double x(const char* name) { return place(scene.find(name)).x; }
};

}  // namespace

TEST_CASE("animation: a clip moves the child of the same name, along the file's line", "[engine]") {
  ClipGame game;
  const NodeId thing = game.thing({{"file", "cube.glb"}});

  game.run(15);

  CHECK(game.time(thing) == Approx(0.25));
  CHECK(game.x("lid") == Approx(0.5));
  CHECK(game.place(game.scene.find("lid")).y == Approx(2));
  game.run(60);  // once around
  CHECK(game.x("lid") == Approx(0.5));
  CHECK(game.take_animation_ends().empty());
}

TEST_CASE("animation: one that does not loop stops at its end and says so once", "[engine]") {
  ClipGame game;
  const NodeId thing = game.thing({{"file", "cube.glb"}, {"clip", "open"}, {"loop", false}, {"speed", 2}});

  game.run(100);

  CHECK(game.time(thing) == 1);
  CHECK(game.x("lid") == 2);
  CHECK_FALSE(game.scene[thing].animation->playing);
  const auto ends = game.take_animation_ends();
  REQUIRE(ends.size() == 1);
  CHECK(ends[0].node == thing);
  CHECK(ends[0].clip == "open");

  game.set(thing, "animation.speed", -1);  // and back
  game.set(thing, "animation.playing", true);
  game.run(30);
  CHECK(game.x("lid") == Approx(1));
  game.run(60);
  CHECK(game.x("lid") == 0);
  CHECK(game.take_animation_ends().size() == 1);
}

TEST_CASE("animation: another clip begins at its start, a backward one at its end", "[engine]") {
  ClipGame game;
  const NodeId thing = game.thing({{"file", "cube.glb"}, {"loop", false}});
  game.run(30);

  game.set(thing, "animation.clip", "bounce");
  CHECK(game.time(thing) == 0);
  game.run(30);
  CHECK(game.place(game.scene.find("lid")).y == Approx(2.875));  // 2 + t^3 - 3 t^2 + 3 t at 0.5

  game.set(thing, "animation.speed", -1);
  game.set(thing, "animation.clip", "open");
  CHECK(game.time(thing) == 1);
}

TEST_CASE("animation: a script may set the time of one that stands still", "[engine]") {
  ClipGame game;
  const NodeId thing = game.thing({{"file", "cube.glb"}, {"playing", false}});
  game.set(thing, "animation.time", 0.75);
  game.run(1);
  CHECK(game.x("lid") == Approx(1.5));

  game.set_position(game.scene.find("lid"), {9, 0, 0});  // and the node is the script's again
  game.run(2);
  CHECK(game.x("lid") == 9);
}

TEST_CASE("animation: the parts of the node's own model move where they are drawn, between two ticks too", "[engine]") {
  ClipGame game;
  game.make({{"name", "eye"}, {"camera", Map{}}});
  game.make({{"mesh", Map{{"file", "cube.glb"}}}, {"animation", "open"}});
  game.run(30);

  const auto lid_x = [&](double alpha) { return extract(game, alpha, 1.5).meshes.at(2).matrix[12]; };
  CHECK(lid_x(1) == Approx(1).epsilon(1e-6));
  CHECK(lid_x(0) == Approx(2 * 29 / kFps).epsilon(1e-6));
  CHECK(lid_x(0.5) == Approx(2 * 29.5 / kFps).epsilon(1e-6));
  CHECK(extract(game, 1, 1.5).meshes.at(0).matrix[12] == 0);  // the base stays
}

TEST_CASE("animation: a keyframed platform carries what stands on it", "[engine][physics]") {
  ClipGame game;
  game.thing({{"file", "cube.glb"}, {"loop", false}, {"speed", 0.5}},
             {{"position", Vec3{0, 2, 0}}, {"mesh", Map{{"shape", "box"}, {"size", Vec3{4, 1, 4}}}}, {"body", Map{{"type", "kinematic"}, {"friction", 1}}}});
  const NodeId crate = game.make({{"position", Vec3{0, 3, 0}}, {"mesh", "box"}, {"body", Map{{"friction", 1}}}});

  game.run(60);

  // 1 m/s after a start that slips for v / (mu g) = 0.1 s: behind by at most 0.05 m and what it fell at first.
  CHECK(game.velocity(crate).x == Approx(1).margin(0.02));
  CHECK(game.place(crate).x == Approx(1).margin(0.08));
}

TEST_CASE("animation: equal runs have equal hashes, and its time is part of them", "[engine]") {
  std::uint64_t first = 0, other = 0;
  for (int run = 0; run < 2; ++run) {
    ClipGame game;
    const NodeId thing = game.thing({{"file", "cube.glb"}});
    game.run(50);
    if (run == 0) first = game.hash();
    CHECK(game.hash() == first);
    game.scene[thing].animation->time += 0.01;
    other = game.hash();
  }
  CHECK(other != first);
}

TEST_CASE("animation: a restart begins it anew", "[engine]") {
  ClipGame game;
  NodeDef def = ClipGame::read({{"name", "thing"}, {"animation", Map{{"file", "cube.glb"}}}, {"children", List{Map{{"name", "lid"}}}}});
  const NodeId thing = game.add(def, {}, Origin::declared, "scene.add");
  game.run(20);
  game.restart_scene();
  CHECK(game.time(thing) == 0);
  CHECK(game.x("lid") == 0);
  game.run(15);
  CHECK(game.x("lid") == Approx(0.5));
}

TEST_CASE("animation: an unknown clip is said once, with the nearest", "[engine]") {
  ClipGame game;
  game.thing({{"file", "cube.glb"}, {"clip", "opne"}});
  game.run(5);
  REQUIRE(game.lines.size() == 1);
  CHECK_THAT(game.lines[0], Catch::Contains("no clip 'opne' in 'cube.glb'") && Catch::Contains("did you mean 'open'") && Catch::Contains("open, bounce"));
}

TEST_CASE("animation: a dynamic body is not moved, and the way out is said", "[engine]") {
  ClipGame game;
  game.thing({{"file", "cube.glb"}}, {{"mesh", "box"}, {"body", Map{{"gravity_factor", 0}}}});
  game.run(10);
  CHECK(game.x("lid") == 0);
  REQUIRE(game.lines.size() == 1);
  CHECK_THAT(game.lines[0], Catch::Contains("kinematic"));
}
