#include "engine/fields.h"

#include "test_engine_support.h"

using namespace tumble;

TEST_CASE("set_field: fields of a node by their names", "[engine]") {
  PlainGame game;
  const NodeId node = game.make({{"name", "a"}, {"mesh", "box"}});

  game.set(node, "position", Vec3{1, 2, 3});
  game.set(node, "rotation_degrees", Vec3{0, 90, 0});
  game.set(node, "name", "b");
  game.set(node, "tags", List{"x", "y"});
  game.set(node, "visible", false);
  game.set(node, "color", "blue");
  game.set(node, "material.roughness", 0.25);
  game.set(node, "mesh", "sphere");
  game.set(node, "mesh.radius", 2);
  game.set(node, "light", "point");
  game.set(node, "light.brightness", 5);

  const SceneNode& n = game.scene[node];
  CHECK(game.scene.find("b") == node);
  CHECK(n.local.position == Vec3{1, 2, 3});
  CHECK(distance(n.local.rotation * Vec3{0, 0, -1}, {-1, 0, 0}) < 1e-12);
  CHECK(n.tags == std::vector<std::string>{"x", "y"});
  CHECK_FALSE(n.visible);
  CHECK(n.material->color == Color{0, 0, 1, 1});
  CHECK(n.material->roughness == 0.25);
  CHECK((n.mesh->shape == ShapeKind::sphere && n.mesh->radius == 2));
  CHECK((n.light->type == LightType::point && n.light->brightness == 5));
}

TEST_CASE("set_field: nil removes a component and sets other fields back to their defaults", "[engine]") {
  PlainGame game;
  const NodeId node = game.make({{"mesh", "box"}, {"light", "sun"}, {"scale", Vec3{2, 2, 2}}, {"color", "red"}, {"body", Map{{"mass", 3}}}});

  game.set(node, "light", {});
  game.set(node, "scale", {});
  game.set(node, "color", {});
  game.set(node, "body.mass", {});
  CHECK_FALSE(game.scene[node].light);
  CHECK(game.scene[node].local.scale == Vec3{1, 1, 1});
  CHECK(game.scene[node].material->color == Material{}.color);
  CHECK_FALSE(game.body(node)->def.mass);

  game.set(node, "body", {});
  CHECK(game.body(node) == nullptr);
  CHECK(game.world()->stats().bodies == 0);
}

TEST_CASE("set_field: a body's field changes the body that is there and keeps its velocity", "[engine]") {
  PlainGame game;
  const NodeId node = game.make({{"mesh", "box"}, {"body", Map{{"velocity", Vec3{3, 0, 0}}}}});
  const BodyId before = game.body(node)->id;
  game.run(1);
  const Vec3 velocity = game.velocity(node);

  game.set(node, "body.mass", 7);

  CHECK(game.body(node)->id == before);
  CHECK(game.world()->mass_properties(before).mass == Approx(7));
  CHECK(game.velocity(node) == velocity);
}

TEST_CASE("set_field: an entry of a list by its number", "[engine]") {
  PlainGame game;
  const NodeId node = game.make({{"body", Map{{"colliders", List{"box", Map{{"shape", "sphere"}, {"offset", Vec3{2, 0, 0}}}}}}}});

  game.set(node, "body.colliders.2.radius", 1.5);

  CHECK(game.body(node)->def.colliders[1].shape.radius == 1.5);
  CHECK(game.body(node)->def.colliders[1].offset == Vec3{2, 0, 0});
  CHECK_THROWS_WITH(game.set(node, "body.colliders.3.radius", 1),
                    "node: body: colliders: no entry '3'; the list has 2, counted from 1");
}

TEST_CASE("set_field: mistakes are worded and change nothing", "[engine]") {
  PlainGame game;
  const NodeId node = game.make({{"mesh", "box"}, {"camera", Map{}}});

  CHECK_THROWS_WITH(game.set(node, "colr", "red"), "node: no field 'colr'; did you mean 'color'?");
  CHECK_THROWS_WITH(game.set(node, "body.mass", 1), "node: there is no body (nil), so 'body.mass' cannot be set; set body first");
  CHECK_THROWS_WITH(game.set(node, "mesh.radius", -1), "node: mesh: radius must be above 0 (got -1)");
  CHECK_THROWS_WITH(game.set(node, "camera.near", 5000), Catch::Contains("near must be below far"));
  CHECK(game.scene[node].camera->near == Camera{}.near);
  CHECK_THROWS_WITH(game.set(node, "prefab", "a"), Catch::Contains("it is read when the node is made"));
}

TEST_CASE("def: a node written down and made again is the same node", "[engine]") {
  PlainGame game;
  const NodeId first = game.make({{"name", "cart"}, {"position", Vec3{1, 2, 3}}, {"rotation_degrees", Vec3{10, 20, 30}}, {"scale", Vec3{1, 2, 1}},
                                  {"mesh", "box"}, {"material", Map{{"color", "red"}, {"glow", 1}}}, {"light", "spot"}, {"enabled", false},
                                  {"body", Map{{"mass", 3}, {"velocity", Vec3{0, 1, 0}}}}});

  NodeDef def = game.def(first);
  def.id.clear();
  const NodeId second = game.add(def, {}, Origin::added, "scene.add");

  NodeDef again = game.def(second);
  again.id.clear();
  CHECK(to_value(again) == to_value(def));
}
