#include "joint_bench.h"

using namespace tumble;

TEST_CASE("joints: a hinge turns about its anchor and axis and counts whole turns", "[physics]") {
  Door door({});
  door.scene.world.set_angular_velocity(door.door, {0, 0, 4});
  door.scene.world.set_velocity(door.door, {0, 2, 0});

  door.scene.run(3);

  // No force but the hinge's own: it turns on. Repairs of the joint cost less than 1 %.
  CHECK(door.state().position == Approx(12).epsilon(0.01));
  CHECK(door.state().speed == Approx(4).epsilon(0.01));
  CHECK(length(door.scene.at(door.door)) == Approx(0.5).epsilon(1e-3));
  // The pull inwards is m v^2 / r.
  CHECK(length(door.state().force) == Approx(2 * 4 / 0.5).epsilon(0.02));
}

TEST_CASE("joints: a pendulum swings with its period", "[physics]") {
  Door door({}, WorldSettings{});
  door.scene.world.teleport(door.door, {{0, -0.5, 0}, axis_angle({0, 0, 1}, -kPi / 2)});
  door.scene.world.set_angular_velocity(door.door, {0, 0, 0.2});
  door.scene.world.set_velocity(door.door, {0.1, 0, 0});

  // Count zero crossings of the speed over 20 s.
  int turns = 0;
  double last = 1, first_time = 0, last_time = 0;
  for (int i = 1; i <= 1200; ++i) {
    door.scene.world.step(kTick);
    const double speed = door.state().speed;
    if ((speed > 0) != (last > 0)) {
      const double time = (i - speed / (speed - last)) * kTick;
      if (turns++ == 0) first_time = time;
      last_time = time;
    }
    last = speed;
  }

  const double period = 2 * (last_time - first_time) / (turns - 1);
  CHECK(period == Approx(2 * kPi * std::sqrt(kRodInertia / (2 * 9.81 * 0.5))).epsilon(0.01));
}

TEST_CASE("joints: limits hold within a degree, from both sides", "[physics]") {
  TurnDef angle;
  angle.min = radians(-30);
  angle.max = radians(70);
  Door door(angle);
  for (const double direction : {1.0, -1.0}) {
    for (int i = 0; i < 120; ++i) {
      door.scene.world.apply_torque(door.door, {0, 0, 5 * direction});
      door.scene.world.step(kTick);
      CHECK(door.state().position < radians(71));
      CHECK(door.state().position > radians(-31));
    }
    CHECK(degrees(door.state().position) == Approx(direction > 0 ? 70 : -30).margin(0.5));
  }
}

TEST_CASE("joints: equal limits lock", "[physics]") {
  TurnDef angle;
  angle.min = angle.max = 0;
  Door door(angle, WorldSettings{});

  door.scene.run(2);

  CHECK(std::abs(door.state().position) < radians(0.5));
  CHECK(door.state().torque.z == Approx(2 * 9.81 * 0.5).epsilon(0.02));  // holds its weight's moment
  CHECK(door.state().force.y == Approx(2 * 9.81).epsilon(0.02));
}

TEST_CASE("joints: a slider lets nothing turn and nothing slip sideways", "[physics]") {
  Scene scene;
  const BodyId id = scene.add(rod(), {});
  scene.world.add(slider(id, {1, 0, 0}), 0);
  scene.world.set_velocity(id, {1, 0, 0});
  scene.world.apply_angular_impulse(id, {0.1, 0.1, 0.1});

  scene.run(2);

  CHECK(scene.at(id).x == Approx(2).epsilon(0.01));
  CHECK(std::abs(scene.at(id).y) < 1e-3);
  CHECK(std::abs(scene.world.pose(id).rotation.w) == Approx(1).margin(1e-5));
}

TEST_CASE("joints: a ball keeps its point and a fixed joint its pose", "[physics]") {
  Scene scene;
  const BodyId a = scene.add(rod(), {0.5, 5, 0}), b = scene.add(rod(), {1.5, 5, 0});
  JointDef ball_def;
  ball_def.a = a;
  ball_def.anchor = {-0.5, 0, 0};
  ball_def.kind = BallDef{};
  scene.world.add(ball_def, 0);
  JointDef weld;
  weld.a = a;
  weld.b = b;
  weld.anchor = {0.5, 0, 0};
  weld.kind = FixedDef{};
  scene.world.add(weld, 0);

  for (int i = 0; i < 180; ++i) {
    scene.world.step(kTick);
    CHECK(distance(scene.world.pose(a) * Vec3{-0.5, 0, 0}, {0, 5, 0}) < 0.01);
    CHECK(distance(scene.world.pose(a) * Vec3{0.5, 0, 0}, scene.world.pose(b) * Vec3{-0.5, 0, 0}) < 0.01);
    CHECK(std::abs(dot(scene.world.pose(a).rotation, scene.world.pose(b).rotation)) > 0.999);
  }
}

TEST_CASE("joints: a joint breaks once, at its force, and stays as a broken one", "[physics]") {
  Scene scene;
  BodyDef def = body(box({1, 1, 1}));
  def.mass = 10;
  def.can_sleep = false;
  const BodyId id = scene.add(def, {});
  JointDef weld;
  weld.a = id;
  weld.kind = FixedDef{};
  weld.break_force = 10 * 9.81 + 50;
  const JointId joint = scene.world.add(weld, 0);
  double pull = 0;
  scene.run(0.5);
  REQUIRE(scene.world.take_events().breaks.empty());

  std::vector<JointEvent> breaks;
  for (int i = 0; i < 300; ++i) {
    if (breaks.empty()) pull = i * 0.5;
    scene.world.apply_force(id, {0, -i * 0.5, 0});
    scene.world.step(kTick);
    for (const JointEvent& event : scene.world.take_events().breaks) breaks.push_back(event);
  }

  REQUIRE(breaks.size() == 1);
  CHECK(breaks[0].joint == joint);
  CHECK(pull == Approx(50).epsilon(0.1));
  CHECK(scene.world.has(joint));
  CHECK(scene.world.state(joint).broken);
  CHECK(scene.at(id).y < -1);
}

TEST_CASE("joints: partners collide again only once no joint joins them", "[physics]") {
  Scene scene(weightless());
  const BodyId a = scene.add(body(box({1, 1, 1})), {}), b = scene.add(body(box({1, 1, 1})), {0.9, 0, 0});
  JointDef weld;
  weld.a = a;
  weld.b = b;
  weld.kind = FixedDef{};
  const JointId first = scene.world.add(weld, 0), second = scene.world.add(weld, 0);
  const auto touching = [&] {
    scene.run(0.1);
    return count(scene.world.take_events().contacts, EventKind::enter, false) > 0;
  };

  CHECK_FALSE(touching());
  scene.world.remove(first);
  CHECK_FALSE(touching());
  scene.world.remove(second);
  CHECK(touching());
}

TEST_CASE("joints: one works only while both bodies are there and enabled", "[physics]") {
  Scene scene;
  BodyDef def = body(box({0.2, 0.2, 0.2}));
  def.can_sleep = false;
  const BodyId top = scene.add(body(box({1, 1, 1}), BodyType::fixed), {0, 5, 0}), id = scene.add(def, {0, 4, 0});
  JointDef weld;
  weld.a = id;
  weld.b = top;
  weld.kind = FixedDef{};
  const JointId joint = scene.world.add(weld, 0);
  scene.run(0.5);
  CHECK(scene.at(id).y == Approx(4).margin(1e-3));

  scene.world.set_enabled(top, false);
  scene.run(0.2);
  CHECK(scene.at(id).y == Approx(4 - 9.81 * 0.04 / 2).margin(0.01));
  scene.world.set_enabled(top, true);
  scene.run(1);
  CHECK(scene.at(id).y == Approx(4).margin(0.01));  // pulled back

  scene.world.remove(top);
  CHECK_FALSE(scene.world.has(joint));
}

TEST_CASE("joints: a limit or a target can be changed live, and wakes the body", "[physics]") {
  TurnDef angle;
  angle.motor.emplace();
  angle.motor->target = 1;
  angle.motor->strength = 50;
  Door door(angle);
  BodyDef def = door.scene.world.def(door.door);
  def.can_sleep = true;
  door.scene.world.configure(door.door, def);
  door.scene.run(3);
  REQUIRE(door.scene.world.asleep(door.door));

  JointDef joint = door.scene.world.def(door.joint);
  std::get<HingeDef>(joint.kind).angle.motor->target = -1;
  door.scene.world.configure(door.joint, joint);
  door.scene.run(2);

  CHECK(door.state().position == Approx(-1).margin(0.01));
}

TEST_CASE("joints: mistakes are worded with the way out", "[physics]") {
  Scene scene;
  const BodyId id = scene.add(body(box({1, 1, 1})), {});
  TurnDef angle;
  angle.min = 2;
  angle.max = 1;

  CHECK_THROWS_WITH(scene.world.add(hinge(id, {}, {0, 0, 0}), 0),
                    "joint.hinge: axis must not be zero (got 0, 0, 0); give a direction such as vec3.up");
  CHECK_THROWS_WITH(scene.world.add(hinge(id, {}, {0, 1, 0}, angle), 0), Catch::Contains("leave both out for no limit"));
  CHECK_THROWS_WITH(scene.world.add(hinge({}, {}, {0, 1, 0}), 0), Catch::Contains("neither a nor b"));
  CHECK_THROWS_WITH(joint_kind("hing"), Catch::Contains("did you mean 'hinge'"));
}

TEST_CASE("joints: options read as scripts write them", "[physics]") {
  JointKind kind = joint_kind("hinge");
  Value options;
  options["min_degrees"] = 0;
  options["max_degrees"] = 110;
  options["motor"]["target_degrees"] = 90;
  options["motor"]["torque"] = 60;
  options["spring"]["frequency"] = 2;

  assign(joint_kind_type(kind), joint_kind_object(kind), options, "joint.hinge");

  const TurnDef& angle = std::get<HingeDef>(kind).angle;
  CHECK(*angle.max == Approx(radians(110)));
  CHECK(*angle.motor->target == Approx(kPi / 2));
  CHECK(*angle.motor->strength == 60);
  CHECK(angle.spring->frequency == 2);
  CHECK(joint_kind_names() == std::vector<std::string>{"fixed", "hinge", "slider", "cylindrical", "ball", "universal", "ragdoll"});
}

// Ten links of 1 kg and a heavy thing at their end, let go along the horizontal: it whips the links round, and pulls them
// straight with a blow.
TEST_CASE("joints: a chain with a heavy end holds when it is let go", "[physics]") {
  for (const double heavy : {1000.0, 10000.0})
    for (const int substeps : {2, 3, 4}) {
      WorldSettings settings;
      settings.substeps = substeps;
      Scene scene(settings);
      std::vector<BodyId> links;
      for (int i = 0; i <= 10; ++i) {
        BodyDef def = body(i < 10 ? box({0.5, 0.1, 0.1}) : box({0.5, 0.5, 0.5}));
        def.mass = i < 10 ? 1 : heavy;
        def.can_sleep = false;
        links.push_back(scene.add(def, {0.25 + 0.5 * i, 0, 0}));
        JointDef ball;
        ball.kind = BallDef{};
        ball.a = links.back();
        if (i > 0) ball.b = links[static_cast<std::size_t>(i - 1)];
        ball.anchor = {-0.25, 0, 0};
        scene.world.add(ball, 0);
      }

      double gap = 0;
      for (int tick = 0; tick < 600; ++tick) {
        scene.world.step(kTick);
        for (std::size_t i = 1; i < links.size(); ++i)
          gap = std::max(gap, distance(scene.world.pose(links[i - 1]) * Vec3{0.25, 0, 0}, scene.world.pose(links[i]) * Vec3{-0.25, 0, 0}));
      }

      CHECK(gap < 1e-4);  // m
      CHECK(scene.world.velocity(links[10]).y < std::sqrt(2 * 9.81 * 5.5));
    }
}
