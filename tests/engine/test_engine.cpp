#include "engine/engine.h"

#include "test_engine_support.h"

using namespace tumble;

TEST_CASE("engine: a node has what its def says, children included", "[engine]") {
  PlainGame game;

  const NodeId tower = game.make({{"name", "tower"}, {"position", Vec3{1, 2, 3}}, {"tags", "tall"}, {"mesh", "cylinder"}, {"color", "red"},
                                  {"children", List{Map{{"name", "flag"}, {"position", Vec3{0, 2, 0}}, {"visible", false}}}}});

  const SceneNode& node = game.scene[tower];
  CHECK(node.tags == std::vector<std::string>{"tall"});
  CHECK(node.mesh->shape == ShapeKind::cylinder);
  CHECK(node.material->color == Color{1, 0, 0, 1});
  const NodeId flag = game.scene.find("tower/flag");
  CHECK(game.place(flag) == Vec3{1, 4, 3});
  CHECK_FALSE(game.scene[flag].visible);
}

TEST_CASE("engine: there is no world before the first body", "[engine]") {
  PlainGame game;
  game.make({{"mesh", "box"}});
  game.run(3);

  CHECK(game.world() == nullptr);
  game.make({{"mesh", "box"}, {"body", "dynamic"}});
  CHECK(game.world() != nullptr);
}

TEST_CASE("engine: an engine without a world describes bodies and joints, and checks them", "[engine]") {
  PlainGame staging({}, false);
  const NodeId box = staging.make({{"mesh", "box"}, {"body", Map{{"mass", 3}}}});
  staging.tie("hinge", box, {});
  staging.run(2);

  CHECK(staging.world() == nullptr);
  CHECK(staging.body_def(box).mass == 3);
  CHECK_THROWS_AS(staging.make({{"body", "static"}}), Error);
  CHECK_THROWS_AS(staging.tie("hinge", box, {}, {{"axis", Vec3{}}}), Error);
}

TEST_CASE("engine: a mistake anywhere in a tree of nodes adds nothing", "[engine]") {
  PlainGame game;
  const NodeId frame = game.make({{"name", "frame"}, {"mesh", "box"}, {"body", "static"}});
  const std::size_t before = game.scene.size();
  const NodeId reserved = game.scene.reserve();
  const NodeDef bad = PlainGame::read({{"name", "cart"},
                                  {"mesh", "box"},
                                  {"body", "dynamic"},
                                  {"joints", List{Map{{"type", "fixed"}, {"b", "frame"}}}},
                                  {"children", List{Map{{"name", "wheel"}, {"body", "dynamic"}}}}});

  CHECK_THROWS_WITH(game.add(bad, {}, Origin::declared, "scene.add", reserved),
                    "scene.add: 'cart/wheel': body needs a mesh or colliders: give the node mesh = \"box\", or body = { colliders = { "
                    "shape = \"box\" } }");

  CHECK(game.scene.size() == before);
  CHECK(game.world()->stats().bodies == 1);
  CHECK(game.joints_of(frame).empty());
  CHECK(game.add(PlainGame::read({{"name", "cart"}}), {}, Origin::declared, "scene.add", reserved) == reserved);
}

TEST_CASE("engine: two equal ids are refused, also within one tree", "[engine]") {
  PlainGame game;

  CHECK_THROWS_WITH(game.make({{"name", "a"}, {"children", List{Map{{"id", "x"}}, Map{{"id", "x"}}}}}),
                    "scene.add: id 'x' is taken by node 'a/x'; every id may stand once in a scene: change or leave out one of them");
  CHECK_FALSE(game.scene.find("a"));
}

TEST_CASE("engine: a destroyed node is dead at once, readable until the end of the tick, then gone", "[engine]") {
  PlainGame game;
  const NodeId tower = game.make({{"name", "tower"}, {"children", List{Map{{"name", "flag"}}}}});
  const NodeId flag = game.scene.find("flag");

  game.destroy(tower);
  CHECK_FALSE(game.alive(tower));
  CHECK_FALSE(game.alive(flag));
  CHECK(game.scene[flag].name == "flag");
  CHECK(game.has_removals());

  CHECK(game.end_tick() == std::vector<NodeId>{tower, flag});
  CHECK(game.scene.get(tower) == nullptr);
  CHECK_FALSE(game.has_removals());
}

TEST_CASE("engine: a child that was destroyed before its parent goes once", "[engine]") {
  PlainGame game;
  const NodeId tower = game.make({{"name", "tower"}, {"children", List{Map{{"name", "flag"}}}}});
  const NodeId flag = game.scene.find("flag");

  game.destroy(flag);
  game.destroy(tower);

  CHECK(game.end_tick() == std::vector<NodeId>{flag, tower});
}

TEST_CASE("engine: nothing hangs below a destroyed node, and the root stays", "[engine]") {
  PlainGame game;
  const NodeId tower = game.make({{"name", "tower"}});
  game.destroy(tower);

  CHECK_THROWS_WITH(game.make({{"name", "flag"}}, tower), "scene.add: the parent was destroyed; choose a node that is alive");
  CHECK_THROWS_AS(game.destroy(game.scene.root()), Error);
}

TEST_CASE("engine: a destroyed body's contacts end in the same tick, while its node can be read", "[engine]") {
  PlainGame game;
  game.make({{"name", "floor"}, {"mesh", Map{{"shape", "box"}, {"size", Vec3{10, 1, 10}}}}, {"body", "static"}});
  const NodeId box = game.make({{"name", "box"}, {"position", Vec3{0, 1, 0}}, {"mesh", "box"}, {"body", "dynamic"}});
  game.run(10);

  game.begin_tick();
  game.destroy(box);
  game.step(PlainGame::kTick);
  game.take_events();
  game.remove_bodies_of_dying();
  const Events events = game.take_events();

  REQUIRE(events.contacts.size() == 1);
  CHECK(events.contacts[0].kind == EventKind::exit);
  CHECK(game.scene[box].name == "box");
  game.finish_removals();
}

TEST_CASE("engine: the hash sees transforms, names and ticks, and no drawing state", "[engine]") {
  PlainGame one, two;
  for (PlainGame* game : {&one, &two}) game->make({{"name", "a"}, {"mesh", "box"}});
  CHECK(one.hash() == two.hash());

  one.scene[one.scene.find("a")].visible = false;
  CHECK(one.hash() == two.hash());
  one.set_position(one.scene.find("a"), {0, 0, 1e-12});
  CHECK_FALSE(one.hash() == two.hash());
}

TEST_CASE("engine: equal runs give equal hashes at every tick", "[engine]") {
  PlainGame one, two;
  for (PlainGame* game : {&one, &two}) {
    game->make({{"mesh", Map{{"shape", "box"}, {"size", Vec3{10, 1, 10}}}}, {"body", "static"}});
    for (int i = 0; i < 8; ++i) game->make({{"position", Vec3{0.1 * i, 2.0 + i, 0}}, {"mesh", "box"}, {"body", "dynamic"}});
  }

  for (int i = 0; i < 120; ++i) {
    one.run(1);
    two.run(1);
    REQUIRE(one.hash() == two.hash());
  }
}
