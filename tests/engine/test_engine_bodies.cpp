#include "engine/colliders.h"

#include "test_engine_support.h"

using namespace tumble;

namespace {

// How far a ray from the side goes before it meets the body: the body's half width.
double half_width(PlainGame& game, Vec3 direction) {
  const auto hit = game.world()->raycast(direction * 50, -direction, 100);
  REQUIRE(hit);
  return 50 - hit->distance;
}

}  // namespace

TEST_CASE("body: fitted to the mesh, stretched by all scales above it", "[engine]") {
  PlainGame game;
  const NodeId parent = game.make({{"scale", Vec3{2, 2, 2}}});
  game.make({{"scale", Vec3{1, 3, 1}}, {"mesh", Map{{"shape", "box"}, {"size", Vec3{1, 1, 4}}}}, {"body", "static"}}, parent);

  CHECK(half_width(game, {1, 0, 0}) == Approx(1).epsilon(1e-6));
  CHECK(half_width(game, {0, 1, 0}) == Approx(3).epsilon(1e-6));
  CHECK(half_width(game, {0, 0, 1}) == Approx(4).epsilon(1e-6));
}

TEST_CASE("body: fit = \"node\" is a box of the node's scale, whatever the mesh", "[engine]") {
  PlainGame game;
  game.make({{"scale", Vec3{4, 1, 1}}, {"mesh", Map{{"shape", "sphere"}, {"radius", 7}}}, {"body", Map{{"type", "static"}, {"fit", "node"}}}});

  CHECK(half_width(game, {1, 0, 0}) == Approx(2).epsilon(1e-6));
  CHECK(half_width(game, {0, 1, 0}) == Approx(0.5).epsilon(1e-6));
}

TEST_CASE("body: given colliders stretch with their node, offsets and centre of mass too", "[engine]") {
  BodyDef def;
  ColliderDef collider;
  collider.shape.shape = ShapeKind::box;
  collider.offset = {1, 0, 0};
  collider.rotation = axis_angle({0, 0, 1}, kPi / 2);
  def.colliders = {collider};
  def.center_of_mass = Vec3{1, 1, 1};

  const BodyDef result = fitted(def, {}, {3, 1, 1}, [](const Shape& shape) { return shape; }, "test");

  CHECK(result.colliders[0].offset == Vec3{3, 0, 0});
  CHECK(distance(result.colliders[0].shape.size, {1, 3, 1}) < 1e-12);  // its own y lies along the node's x
  CHECK(*result.center_of_mass == Vec3{3, 1, 1});
}

TEST_CASE("body: without a mesh or colliders it is refused with the way out", "[engine]") {
  PlainGame game;

  CHECK_THROWS_WITH(game.make({{"body", "dynamic"}}), "scene.add: body needs a mesh or colliders: give the node mesh = \"box\", or body = { "
                                                      "colliders = { shape = \"box\" } }");
  CHECK(game.world() == nullptr);
}

TEST_CASE("body: a shape that cannot be built is refused with and without a world, and leaves nothing", "[engine]") {
  const Map flat{{"body", Map{{"colliders", Map{{"shape", "hull"}, {"points", List{Vec3{}, Vec3{1, 0, 0}, Vec3{0, 1, 0}}}}}}}};

  for (const bool with_world : {true, false}) {
    PlainGame game({}, with_world);
    CHECK_THROWS_WITH(game.make(flat), Catch::StartsWith("scene.add: collider: a hull needs at least 4 points"));
    CHECK(game.world() == nullptr);
    CHECK(game.scene.size() == 1);
  }
}

TEST_CASE("body: unknown groups are refused with the nearest", "[engine]") {
  GameSettings settings;
  settings.physics.groups = {"player", "enemy"};
  PlainGame game(settings);

  CHECK_THROWS_WITH(game.make({{"mesh", "box"}, {"body", Map{{"group", "plyer"}}}}),
                    "scene.add: body.group: unknown group 'plyer'; did you mean 'player'?; groups are listed in game.json: physics.groups");
  game.make({{"mesh", "box"}, {"body", Map{{"group", "player"}, {"collides_with", List{"enemy", "default"}}}}});
}

TEST_CASE("body: a new scale of the node or of an ancestor rebuilds the colliders", "[engine]") {
  PlainGame game;
  const NodeId parent = game.make({{"name", "parent"}});
  const NodeId node = game.make({{"mesh", "box"}, {"body", "static"}}, parent);
  game.run(1);

  game.tick_with([&] { game.set_scale(node, {3, 1, 1}); });
  CHECK(half_width(game, {1, 0, 0}) == Approx(1.5).epsilon(1e-6));
  game.tick_with([&] { game.set_scale(parent, {2, 2, 2}); });
  CHECK(half_width(game, {1, 0, 0}) == Approx(3).epsilon(1e-6));
  CHECK(half_width(game, {0, 1, 0}) == Approx(1).epsilon(1e-6));
}

TEST_CASE("body: a new mesh refits it, and losing the mesh is refused", "[engine]") {
  PlainGame game;
  const NodeId node = game.make({{"mesh", "box"}, {"body", "static"}});

  game.set(node, "mesh", Map{{"shape", "sphere"}, {"radius", 2}});

  CHECK(half_width(game, {1, 0, 0}) == Approx(2).epsilon(1e-6));
  CHECK_THROWS_AS(game.set(node, "mesh", {}), Error);
  CHECK(game.scene[node].mesh->radius == 2);
}

TEST_CASE("body: off while its node or an ancestor is disabled", "[engine]") {
  PlainGame game;
  const NodeId parent = game.make({{"name", "parent"}});
  const NodeId ball = game.make({{"mesh", "sphere"}, {"body", "dynamic"}}, parent);
  const BodyId id = game.body(ball)->id;

  game.set_enabled(parent, false);
  CHECK_FALSE(game.world()->enabled(id));
  game.run(10);
  CHECK(game.place(ball) == Vec3{});

  game.set_enabled(ball, false);
  game.set_enabled(parent, true);
  CHECK_FALSE(game.world()->enabled(id));
  game.set_enabled(ball, true);
  game.run(10);
  CHECK(game.place(ball).y < -0.05);
}

TEST_CASE("body: made below a disabled node it begins switched off", "[engine]") {
  PlainGame game;
  const NodeId parent = game.make({{"enabled", false}});
  const NodeId ball = game.make({{"mesh", "sphere"}, {"body", "dynamic"}}, parent);

  CHECK_FALSE(game.world()->enabled(game.body(ball)->id));
}

TEST_CASE("body: a changed type takes effect", "[engine]") {
  PlainGame game;
  const NodeId ball = game.make({{"mesh", "sphere"}, {"body", "static"}});
  game.run(5);
  CHECK(game.place(ball) == Vec3{});

  game.set(ball, "body.type", "dynamic");
  game.run(30);
  // Half a second of free fall: 9.81 / 8 m, and a tick of g h t / 2 for the step's own error.
  CHECK(game.place(ball).y == Approx(-9.81 / 8).margin(0.05));
}

TEST_CASE("body: the node of a body is found from the world", "[engine]") {
  PlainGame game;
  const NodeId ball = game.make({{"mesh", "sphere"}, {"body", "dynamic"}});

  CHECK(game.node_of(game.body(ball)->id) == ball);
  CHECK_FALSE(game.node_of(BodyId{}));
}

TEST_CASE("body: new physics settings act on bodies that are there", "[engine]") {
  PlainGame game;
  const NodeId ball = game.make({{"mesh", "sphere"}, {"body", "dynamic"}});
  WorldSettings physics = game.settings.physics;
  physics.gravity = {0, 3, 0};

  game.configure_physics(physics);
  game.run(60);

  CHECK(game.velocity(ball).y == Approx(3).epsilon(1e-6));
}
