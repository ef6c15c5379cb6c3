#include "physical.h"

using namespace tumble;

TEST_CASE("motion: free fall follows y = h - g t^2 / 2 to the last digits", "[physics]") {
  Scene scene;
  const BodyId stone = scene.add(body(ball(0.1)), {0, 100, 0});

  scene.run(3);

  // Constant acceleration is integrated exactly; only rounding is left.
  CHECK(scene.at(stone).y == Approx(100 - 9.81 * 9 / 2).epsilon(1e-12));
  CHECK(scene.world.velocity(stone).y == Approx(-9.81 * 3).epsilon(1e-12));
}

TEST_CASE("motion: a throw follows its parabola", "[physics]") {
  Scene scene;
  const Vec3 v{6, 8, -3};
  const BodyId ball_id = scene.add(body(ball(0.12)), {1, 2, 3});
  scene.world.set_velocity(ball_id, v);

  scene.run(1.5);

  const Vec3 expected = Vec3{1, 2, 3} + v * 1.5 + Vec3{0, -9.81, 0} * (1.5 * 1.5 / 2);
  CHECK(distance(scene.at(ball_id), expected) < 1e-10);
}

TEST_CASE("motion: damping is exp(-k t) whatever the substeps and the tick", "[physics]") {
  for (const int substeps : {1, 4, 7})
    for (const double tick : {1.0 / 60, 1.0 / 30}) {
      WorldSettings settings = weightless();
      settings.substeps = substeps;
      Scene scene(settings);
      BodyDef def = body(ball(0.5));
      def.damping = 40;  // larger than a tick's reach, where 1 - k h would fail
      def.angular_damping = 0.5;
      const BodyId id = scene.add(def, {});
      scene.world.set_velocity(id, {3, 0, 0});
      scene.world.set_angular_velocity(id, {0, 2, 0});

      scene.run(0.5, tick);

      CHECK(scene.world.velocity(id).x == Approx(3 * std::exp(-20.0)).epsilon(1e-9));
      CHECK(scene.world.angular_velocity(id).y == Approx(2 * std::exp(-0.25)).epsilon(1e-9));
    }
}

TEST_CASE("motion: a damped body falls at its terminal speed g / k", "[physics]") {
  Scene scene;
  BodyDef def = body(ball(0.5));
  def.damping = 2;
  const BodyId id = scene.add(def, {0, 1000, 0});

  scene.run(10);

  CHECK(scene.world.velocity(id).y == Approx(-9.81 / 2).epsilon(1e-8));  // exp(-20) is still missing
}

TEST_CASE("motion: a force acts through the whole step, whatever the substeps", "[physics]") {
  for (const int substeps : {1, 5}) {
    WorldSettings settings = weightless();
    settings.substeps = substeps;
    Scene scene(settings);
    BodyDef def = body(box({1, 2, 3}));
    def.mass = 4;
    const BodyId id = scene.add(def, {});

    scene.world.apply_force(id, {8, 0, 0});
    scene.world.apply_torque(id, {0, 0, 3});
    scene.world.step(0.1);

    CHECK(scene.world.velocity(id).x == Approx(0.2).epsilon(1e-12));
    CHECK(scene.at(id).x == Approx(2 * 0.1 * 0.1 / 2).epsilon(1e-12));
    const double inertia = 4.0 / 12 * (1 + 4);
    CHECK(scene.world.angular_velocity(id).z == Approx(3 * 0.1 / inertia).epsilon(1e-9));
    scene.world.step(0.1);
    CHECK(scene.world.velocity(id).x == Approx(0.2).epsilon(1e-12));  // gone after its step
  }
}

TEST_CASE("motion: an impulse at a point turns by its lever", "[physics]") {
  Scene scene(weightless());
  BodyDef def = body(ball(0.5));
  def.mass = 2;
  const BodyId id = scene.add(def, {1, 1, 1});

  scene.world.apply_impulse(id, {0, 0, 6}, {1, 1.5, 1});

  CHECK(scene.world.velocity(id).z == Approx(3));
  CHECK(scene.world.angular_velocity(id).x == Approx(0.5 * 6 / (0.4 * 2 * 0.25)));
  CHECK(scene.world.velocity_at(id, {1, 1.5, 1}).z == Approx(3 + 15 * 0.5));
}

TEST_CASE("motion: gravity_factor scales gravity", "[physics]") {
  Scene scene;
  BodyDef def = body(ball(0.5));
  def.gravity_factor = -0.5;
  const BodyId id = scene.add(def, {});

  scene.run(1);

  CHECK(scene.at(id).y == Approx(9.81 / 4).epsilon(1e-12));
}

TEST_CASE("motion: locked axes do not move or turn, the others are free", "[physics]") {
  Scene scene;
  scene.floor();
  BodyDef def = body(box({1, 1, 1}));
  def.lock_position = "z";
  def.lock_rotation = "xy";
  const BodyId id = scene.add(def, {0, 3, 0.25}, axis_angle({0, 0, 1}, 0.3));
  scene.world.set_velocity(id, {2, 0, 5});
  scene.world.set_angular_velocity(id, {3, 3, 3});

  scene.run(2);

  CHECK(scene.at(id).z == Approx(0.25).margin(1e-9));
  const Vec3 up = scene.world.pose(id).rotation * Vec3{0, 0, 1};
  CHECK(up.z == Approx(1).margin(1e-9));
  CHECK(scene.at(id).x > 0.5);
}

TEST_CASE("motion: a kinematic body arrives exactly and reports its speed on the way", "[physics]") {
  Scene scene;
  const BodyId lift = scene.add(body(box({2, 0.2, 2}), BodyType::kinematic), {0, 1, 0});
  const Quat turn = axis_angle({0, 1, 0}, 0.1);

  scene.world.move(lift, {{0, 1.05, 0.02}, turn});
  scene.world.step(kTick);

  CHECK(distance(scene.at(lift), {0, 1.05, 0.02}) < 1e-12);
  CHECK(scene.world.pose(lift).rotation.y == Approx(turn.y).epsilon(1e-12));
  CHECK(scene.world.velocity(lift).y == Approx(3).epsilon(1e-9));
  CHECK(scene.world.angular_velocity(lift).y == Approx(6).epsilon(1e-9));
  scene.world.step(kTick);
  CHECK(length(scene.world.velocity(lift)) == 0);
}

TEST_CASE("motion: a carrier takes its rider along, sideways and upwards", "[physics]") {
  Scene scene;
  const BodyId lift = scene.add(body(box({4, 0.2, 4}), BodyType::kinematic), {0, 0, 0});
  BodyDef def = body(box({0.5, 0.5, 0.5}));
  def.friction = 1;
  const BodyId rider = scene.add(def, {0, 0.35, 0});
  scene.run(0.5);
  const Vec3 before = scene.at(rider) - scene.at(lift);

  for (int i = 1; i <= 120; ++i) {
    // A soft start: 1 m/s is reached in half a second.
    const double t = i * kTick, way = t < 0.5 ? t * t : t - 0.25;
    scene.world.move(lift, {{way, way / 2, 0}, {}});
    scene.world.step(kTick);
  }

  // It keeps its place on the lift within 2 mm after 1.75 m of way.
  CHECK(distance(scene.at(rider) - scene.at(lift), before) < 2e-3);
}

TEST_CASE("motion: what falls apart into NaN is put back and switched off, its neighbour stays sound", "[physics]") {
  Scene scene;
  scene.floor();
  const BodyId sick = scene.add(body(box({1, 1, 1})), {0, 0.5, 0});
  const BodyId neighbour = scene.add(body(box({1, 1, 1})), {0, 1.5, 0});
  scene.run(0.5);

  scene.world.apply_force(sick, {std::nan(""), 0, 0});
  scene.world.step(kTick);

  const Events events = scene.world.take_events();
  REQUIRE(events.lost.size() == 1);
  CHECK(events.lost[0] == sick);
  CHECK_FALSE(scene.world.enabled(sick));
  CHECK(distance(scene.at(sick), {0, 0.5, 0}) < 0.01);
  scene.run(1);
  CHECK(is_finite(scene.at(neighbour)));
  CHECK(scene.at(neighbour).y == Approx(0.5).margin(0.02));  // fell to the floor: 2 % of its size of penetration
}

TEST_CASE("motion: a body at rest falls asleep within a second and every change wakes it", "[physics]") {
  Scene scene;
  const BodyId ground = scene.floor();
  const BodyId id = scene.add(body(box({1, 1, 1})), {0, 0.5, 0});
  const auto rest = [&] {
    scene.run(2);
    REQUIRE(scene.world.asleep(id));
  };

  rest();
  CHECK(scene.world.moved().empty());
  scene.world.apply_impulse(id, {0.1, 0, 0});
  CHECK_FALSE(scene.world.asleep(id));
  rest();
  scene.world.apply_force(id, {0.1, 0, 0});
  CHECK_FALSE(scene.world.asleep(id));
  rest();
  scene.world.set_velocity(id, {0, 0.1, 0});
  CHECK_FALSE(scene.world.asleep(id));
  rest();
  WorldSettings settings = scene.world.settings();
  settings.gravity = {0, -5, 0};
  scene.world.configure(settings);
  CHECK_FALSE(scene.world.asleep(id));
  rest();
  scene.world.remove(ground);
  CHECK_FALSE(scene.world.asleep(id));
  scene.run(1);
  CHECK(scene.at(id).y < -1);
}

TEST_CASE("motion: a rider stays in its place on a carrier that sways and on one that turns", "[physics]") {
  Scene sway;
  const BodyId plate = sway.add(body(box({6, 1, 6}), BodyType::kinematic), {});
  BodyDef def = body(box({1, 1, 1}));
  def.friction = 1;  // with the plate's: 0.5
  const BodyId rider = sway.add(def, {0, 1, 0});
  double slip = 0;
  for (int i = 1; i <= 300; ++i) {
    const double x = 0.5 * (1 - std::cos(2 * kPi * 0.3 * i * kTick));
    sway.world.move(plate, {{x, 0, 0}, {}});
    sway.world.step(kTick);
    slip = std::max(slip, std::abs(sway.at(rider).x - x));
  }
  CHECK(slip < 2e-4);

  // At 2 rad/s a metre from the middle, where friction could hold 2.2 rad/s.
  Scene turn;
  const BodyId table = turn.add(body(box({6, 1, 6}), BodyType::kinematic), {});
  def = body(box({0.2, 0.2, 0.2}));
  def.friction = 1;
  def.velocity = {0, 0, -2};
  def.angular_velocity = {0, 2, 0};
  const BodyId stone = turn.add(def, {1, 0.6, 0});
  for (int i = 1; i <= 600; ++i) {
    turn.world.move(table, {{}, axis_angle({0, 1, 0}, 2 * i * kTick)});
    turn.world.step(kTick);
  }
  const Vec3 place = conjugate(axis_angle({0, 1, 0}, 20)) * turn.at(stone);
  CHECK(std::hypot(place.x - 1, place.z) < 5e-4);
}

TEST_CASE("motion: a carrier that starts at once throws nothing up", "[physics]") {
  Scene scene;
  const BodyId lift = scene.add(body(box({6, 1, 6}), BodyType::kinematic), {});
  const BodyId rider = scene.add(body(box({1, 1, 1})), {0, 1, 0});
  scene.run(0.5);
  for (int i = 1; i <= 60; ++i) {
    scene.world.move(lift, {{0, 2 * i * kTick, 0}, {}});
    scene.world.step(kTick);
    CHECK(scene.at(rider).y - scene.at(lift).y < 1.001);
    CHECK(scene.at(rider).y - scene.at(lift).y > 0.99);
  }
}

TEST_CASE("motion: what flies past wakes nobody, and what touches wakes all that the body lies against", "[physics]") {
  Scene scene;
  scene.floor();
  std::vector<BodyId> row;
  for (int i = 0; i < 5; ++i) row.push_back(scene.add(body(box({1, 1, 1})), {1.001 * i, 0.5, 0}));
  scene.run(2);
  for (const BodyId id : row) {
    REQUIRE(scene.world.asleep(id));
    CHECK(scene.world.velocity(id) == Vec3{});
    CHECK(scene.world.angular_velocity(id) == Vec3{});
  }
  scene.world.take_events();

  BodyDef stone = body(ball(0.1));
  stone.gravity_factor = 0;
  stone.velocity = {10, 0, 0};
  scene.add(stone, {-3, 1.22, 0});  // 12 cm above them, by less than its way in a tick
  scene.run(1);
  for (const BodyId id : row) CHECK(scene.world.asleep(id));

  const BodyId hit = scene.add(stone, {-3, 0.5, 0});
  const std::vector<Vec3> before = {scene.at(row[0]), scene.at(row[4])};
  for (int i = 0; i < 60 && scene.world.asleep(row[0]); ++i) scene.world.step(kTick);
  for (const BodyId id : row) CHECK_FALSE(scene.world.asleep(id));  // in one step, gaps of a millimetre apart
  CHECK(scene.at(hit).x > -1.5);
  int woken = 0;
  for (const SleepEvent& event : scene.world.take_events().sleeps) woken += !event.asleep;
  CHECK(woken == 5);
}

TEST_CASE("motion: who is woken wakes what is joined to him, however many links away", "[physics]") {
  Scene scene(weightless());
  std::vector<BodyId> chain;
  for (int i = 0; i < 30; ++i) chain.push_back(scene.add(body(ball(0.2)), {i * 1.0, 0, 0}));
  for (std::size_t i = 1; i < chain.size(); ++i) {
    JointDef def;
    def.kind = BallDef{};
    def.a = chain[i - 1];
    def.b = chain[i];
    def.anchor = {0.5, 0, 0};
    scene.world.add(def, 0);
  }
  scene.run(2);
  for (const BodyId id : chain) REQUIRE(scene.world.asleep(id));
  scene.world.apply_impulse(chain[29], {0, 0.1, 0});
  for (const BodyId id : chain) CHECK_FALSE(scene.world.asleep(id));
  scene.run(4);
  scene.world.sleep(chain[3]);  // alone, which does not last
  scene.world.step(kTick);
  CHECK_FALSE(scene.world.asleep(chain[3]));
}

// Without slip its motion is a turn w about the line on which it touches; the axis then goes round at w tan(a), a the angle
// between axis and side, the tip stays, and nothing is lost.
TEST_CASE("motion: a cone on its side rolls round its tip and keeps its energy", "[physics]") {
  const double radius = 0.3, height = 0.9, w = 4, a = std::atan2(radius, height);
  Scene scene;
  scene.floor();
  const Vec3 axis{std::cos(a), std::sin(a), 0};  // from the tip, at the origin, to the middle of its base
  BodyDef def = body(upright(ShapeKind::cone, radius, height));
  def.friction = 1;
  def.can_sleep = false;
  def.angular_velocity = {w, 0, 0};
  def.velocity = cross(def.angular_velocity, axis * (height * 0.75));
  const BodyId cone = scene.add(def, axis * (height / 2), between({0, -1, 0}, axis));
  const double before = scene.world.kinetic_energy(cone);

  scene.run(5);

  const Pose pose = scene.world.pose(cone);
  CHECK(scene.world.kinetic_energy(cone) == Approx(before).epsilon(0.01));
  CHECK(distance(pose * Vec3{0, height / 2, 0}, {}) < 0.01);
  const Vec3 base = pose * Vec3{0, -height / 2, 0};
  const double gone = w * std::tan(a) * 5, seen = std::atan2(-base.z, base.x);
  CHECK(std::abs(std::remainder(seen + gone, 2 * kPi)) < 0.02);
}

TEST_CASE("motion: a drifter in empty space does not freeze", "[physics]") {
  Scene scene(weightless());
  const BodyId id = scene.add(body(ball(0.5)), {});
  scene.world.set_velocity(id, {0.5, 0, 0});

  scene.run(10);

  CHECK(scene.at(id).x == Approx(5).epsilon(1e-9));
}
