#include "physical.h"

using namespace tumble;

TEST_CASE("bodies: options read as scripts write them, the shape's fields among the collider's own", "[physics]") {
  BodyDef def;
  Value collider;
  collider["shape"] = "sphere";
  collider["radius"] = 0.25;
  collider["offset"] = Vec3{0, 1, 0};
  collider["rotation_degrees"] = Vec3{0, 90, 0};
  Value options;
  options["type"] = "kinematic";
  options["mass"] = 3;
  options["friction_combine"] = "max";
  options["colliders"] = List{collider};

  assign(def, options, "scene.add: body");

  CHECK(def.type == BodyType::kinematic);
  CHECK(def.friction_combine == Combine::max);
  REQUIRE(def.colliders.size() == 1);
  CHECK(def.colliders[0].shape.shape == ShapeKind::sphere);
  CHECK(def.colliders[0].shape.radius == 0.25);
  CHECK(def.colliders[0].offset == Vec3{0, 1, 0});
  CHECK((def.colliders[0].rotation * Vec3{0, 0, -1}).x == Approx(-1));
}

TEST_CASE("bodies: a bare string is the type, and mistakes name the field", "[physics]") {
  BodyDef def;
  assign(def, "static", "body");
  CHECK(def.type == BodyType::fixed);

  Value wrong;
  wrong["mass"] = -1;
  CHECK_THROWS_WITH(assign(def, wrong, "body"), Catch::Contains("mass") && Catch::Contains("above 0"));
  Value both;
  both["mass"] = 1;
  both["density"] = 1;
  CHECK_THROWS_WITH(assign(def, both, "body"), Catch::Contains("leave one of them out"));
  Value letters;
  letters["lock_rotation"] = "xw";
  CHECK_THROWS_WITH(assign(def, letters, "body"), Catch::Contains("letters x, y and z"));
}

TEST_CASE("bodies: the centre of mass is the colliders', and poses are the body's", "[physics]") {
  Scene scene(weightless());
  BodyDef def;
  def.colliders = {collider(box({1, 1, 1}), {2, 0, 0}, axis_angle({0, 0, 1}, 0.4))};
  const BodyId id = scene.add(def, {1, 1, 1}, axis_angle({0, 1, 0}, kPi / 2));

  CHECK(distance(scene.world.mass_properties(id).center, {2, 0, 0}) < 1e-12);
  CHECK(distance(scene.at(id), {1, 1, 1}) < 1e-12);
  scene.world.set_angular_velocity(id, {0, 1, 0});
  scene.run(kPi / 2, kPi / 240);

  // A quarter turn about its own centre, which lies at (1, 1, -1).
  CHECK(distance(scene.at(id), {3, 1, -1}) < 1e-3);
}

TEST_CASE("bodies: a hand-given centre of mass makes a tumbler stand up", "[physics]") {
  Scene scene;
  scene.floor();
  BodyDef def = body(ball(0.5));
  def.center_of_mass = Vec3{0, -0.3, 0};
  def.angular_damping = 2;
  const BodyId id = scene.add(def, {0, 0.5, 0}, axis_angle({0, 0, 1}, 1.5));

  scene.run(10);

  CHECK((scene.world.pose(id).rotation * Vec3{0, 1, 0}).y > 0.99);
}

TEST_CASE("bodies: def and configure go round, and a new mass counts at once", "[physics]") {
  Scene scene(weightless());
  const BodyId id = scene.add(body(ball(0.5)), {});
  scene.world.set_velocity(id, {1, 2, 3});

  BodyDef def = scene.world.def(id);
  CHECK(def.velocity == Vec3{1, 2, 3});
  def.mass = 5;
  scene.world.configure(id, def);

  CHECK(scene.world.velocity(id) == Vec3{1, 2, 3});
  CHECK(scene.world.momentum(id).z == Approx(15));
  CHECK(scene.world.kinetic_energy(id) == Approx(0.5 * 5 * 14));
}

TEST_CASE("bodies: a change of type keeps the place", "[physics]") {
  Scene scene;
  const BodyId id = scene.add(body(ball(0.5)), {0, 5, 0});
  BodyDef def = scene.world.def(id);
  def.type = BodyType::fixed;
  scene.world.configure(id, def);
  scene.run(0.5);
  CHECK(scene.at(id) == Vec3{0, 5, 0});

  def.type = BodyType::dynamic;
  scene.world.configure(id, def);
  scene.run(0.5);
  CHECK(scene.at(id).y == Approx(5 - 9.81 / 8).epsilon(1e-9));
}

TEST_CASE("bodies: every solid shape lies on the floor at its own height", "[physics]") {
  Shape pyramid, hull, plane;
  pyramid.shape = ShapeKind::pyramid;
  hull.shape = ShapeKind::hull;
  hull.points = {{-0.5, -0.5, -0.5}, {0.5, -0.5, -0.5}, {0.5, -0.5, 0.5}, {-0.5, -0.5, 0.5}, {0, 0.5, 0}};
  plane.shape = ShapeKind::plane;
  struct Case {
    Shape shape;
    double height;
  };
  for (const Case& c : std::vector<Case>{{box({1, 1, 1}), 0.5},
                                         {ball(0.5), 0.5},
                                         {upright(ShapeKind::cylinder, 0.5, 1), 0.5},
                                         {upright(ShapeKind::cone, 0.5, 1), 0.5},
                                         {pyramid, 0.5},
                                         {hull, 0.5},
                                         {ring(0.5, 0.2), 0.1},
                                         {plane, 0.1}}) {
    Scene scene;
    scene.floor();
    const BodyId id = scene.add(body(c.shape), {0, c.height + 0.05, 0});

    scene.run(2);

    INFO("shape " << static_cast<int>(c.shape.shape));
    CHECK(scene.at(id).y == Approx(c.height).margin(0.005));  // margins of 1 mm and the solver's breathing
    CHECK((scene.world.pose(id).rotation * Vec3{0, 1, 0}).y > 0.999);
    CHECK(scene.world.asleep(id));
  }
}

TEST_CASE("bodies: a fast ball does not pass a thin wall", "[physics]") {
  for (int phase = 0; phase < 20; ++phase) {
    Scene scene(weightless());
    scene.add(body(box({0.02, 4, 4}), BodyType::fixed), {5 + 0.04 * phase, 0, 0});
    const BodyId id = scene.add(body(ball(0.1)), {});
    scene.world.set_velocity(id, {200, 0, 0});

    scene.run(0.2);

    CHECK(scene.at(id).x < 5 + 0.04 * phase);
  }
}
