#include "test_engine_support.h"

using namespace tumble;

namespace {

NodeDef level(const char* name, const char* id = "") {
  return PlainGame::read({{"name", name}, {"children", List{Map{{"name", "crate"}, {"id", id}, {"mesh", "box"}, {"body", "dynamic"}}}}});
}

}  // namespace

TEST_CASE("load: a scene takes the place of the one before, declared nodes stay, added ones go", "[engine]") {
  PlainGame game;
  const NodeId score = game.declare({{"name", "score"}});
  CHECK(game.scene_root == game.scene.root());
  const NodeId one = game.load(level("one"), "levels/one");
  const NodeId coin = game.make({{"name", "coin"}}, score);

  const NodeId two = game.load(level("two"), "levels/two");

  CHECK(game.scene_root == two);
  CHECK(game.scene_name == "levels/two");
  CHECK(game.alive(score));
  CHECK(game.scene.get(one) == nullptr);
  CHECK(game.scene.get(coin) == nullptr);
  CHECK(game.scene.find_all("crate") == std::vector<NodeId>{game.scene.find("two/crate")});
  CHECK(game.world()->stats().bodies == 1);
  CHECK(game.finish_removals().size() == 3);
}

TEST_CASE("load: the camera that was made where there was none goes when a scene brings its own", "[engine]") {
  PlainGame game;
  game.begin_tick();
  REQUIRE(game.scene.find_all("camera").size() == 1);
  NodeDef room = level("room");
  room.children.push_back(PlainGame::read({{"name", "camera"}, {"camera", Map{}}}));

  game.load(room, "room");

  CHECK(game.scene.path(game.camera()) == "room/camera");
  CHECK(game.scene.find_all("camera").size() == 1);

  game.load(level("hall"), "hall");

  CHECK(game.scene.path(game.camera()) == "camera");
}

TEST_CASE("load: the same scene again keeps its ids", "[engine]") {
  PlainGame game;
  game.load(level("one", "C1"), "one");

  game.load(level("one", "C1"), "one");

  CHECK(game.scene.path(game.scene.find_id("C1")) == "one/crate");
}

TEST_CASE("load: a scene with a mistake changes nothing", "[engine]") {
  PlainGame game;
  game.declare({{"name", "keeper"}, {"id", "K"}});
  const NodeId one = game.load(level("one", "C1"), "one");
  NodeDef bad = level("two", "C2");
  bad.children[0].mesh.reset();

  CHECK_THROWS_WITH(game.load(bad, "two"), Catch::Contains("scene.load: 'two/crate': body needs a mesh or colliders"));
  CHECK_THROWS_WITH(game.load(level("two", "K"), "two"), Catch::Contains("id 'K' is taken by node 'keeper'"));

  CHECK(game.scene_root == one);
  CHECK(game.scene_name == "one");
  CHECK(game.scene.find_id("C1"));
}

TEST_CASE("load: a file's joint may name a declared node", "[engine]") {
  PlainGame game;
  const NodeId post = game.declare({{"name", "post"}, {"mesh", "box"}, {"body", "static"}});
  NodeDef one = level("one");
  one.children[0].joints.push_back(Map{{"type", "fixed"}, {"name", "tie"}, {"b", "post"}});

  game.load(one, "one");

  CHECK(game.joint(game.find_joint(post, "tie"))->id);
}

TEST_CASE("load: loaded nodes restart, those of the scene before do not come back", "[engine]") {
  PlainGame game;
  game.load(level("one"), "one");
  const NodeId old_crate = game.scene.find("crate");
  game.destroy(old_crate);
  game.end_tick();
  game.load(level("two"), "two");
  const NodeId crate = game.scene.find("crate");
  game.destroy(game.scene_root);
  game.end_tick();

  game.restart_scene();

  CHECK(game.scene.path(crate) == "two/crate");
  CHECK(game.scene.find_all("crate").size() == 1);
  CHECK(game.scene_root == game.scene.find("two"));
}

TEST_CASE("load: a declared node that hung in the old scene keeps its place in the world", "[engine]") {
  PlainGame game;
  game.load(PlainGame::read({{"name", "one"}, {"position", Vec3{5, 0, 0}}}), "one");
  const NodeId hat = game.declare({{"name", "hat"}, {"position", Vec3{1, 0, 0}}}, game.scene_root);

  game.load(level("two"), "two");

  CHECK(game.alive(hat));
  CHECK(game.place(hat) == Vec3{6, 0, 0});
}
