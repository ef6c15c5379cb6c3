// What is changed while all sleeps, or while a body is away, and what of it is felt.
#include "physics/physical.h"

using namespace tumble;

namespace {

// A box asleep on a static floor.
struct Sleeper {
  Scene scene;
  BodyId floor, box_id;
  explicit Sleeper(const WorldSettings& settings = {}) : scene(settings) {
    floor = scene.add(body(box({40, 1, 40}), BodyType::fixed), {0, -0.5, 0});
    box_id = scene.add(body(box({1, 1, 1})), {0, 0.5, 0});
    scene.run(3);
    REQUIRE(scene.world.asleep(box_id));
  }
  void make_belt(double speed) {
    BodyDef belt = scene.world.def(floor);
    belt.surface_velocity = {speed, 0, 0};
    scene.world.configure(floor, belt);
  }
};

}  // namespace

TEST_CASE("changes: a floor that becomes a belt carries what slept on it", "[physics]") {
  Sleeper at;
  at.make_belt(2);
  at.scene.run(2);
  CHECK(at.scene.at(at.box_id).x > 2);
}

TEST_CASE("changes: what slept on a floor that meets it no more falls", "[physics]") {
  WorldSettings settings;
  settings.groups = {"ghosts"};
  Sleeper at(settings);
  BodyDef gone = at.scene.world.def(at.floor);
  gone.collides_with = {"ghosts"};
  at.scene.world.configure(at.floor, gone);
  at.scene.run(1);
  CHECK(at.scene.at(at.box_id).y < -3);
  CHECK(at.scene.world.contacts(at.box_id).empty());
}

TEST_CASE("changes: a trigger that hears a sleeper no more tells its exit", "[physics]") {
  WorldSettings settings;
  settings.groups = {"ghosts"};
  Sleeper at(settings);
  BodyDef zone = body(box({4, 4, 4}), BodyType::fixed);
  zone.trigger = true;
  const BodyId trigger = at.scene.add(zone, {});
  at.scene.run(3);
  REQUIRE(at.scene.world.overlapping(trigger) == std::vector<BodyId>{at.box_id});
  at.scene.world.take_events();
  zone.collides_with = {"ghosts"};
  at.scene.world.configure(trigger, zone);
  at.scene.run(0.1);
  CHECK(at.scene.world.overlapping(trigger).empty());
  CHECK(count(at.scene.world.take_events().contacts, EventKind::exit, true) == 1);
}

TEST_CASE("changes: forces on what is away or put to sleep are not saved up", "[physics]") {
  Scene scene(weightless());
  const BodyId id = scene.add(body(ball(0.5)), {});
  scene.world.set_enabled(id, false);
  for (int i = 0; i < 60; ++i) {
    scene.world.apply_force(id, {10, 0, 0});
    scene.world.apply_torque(id, {0, 1, 0});
    scene.world.step(kTick);
  }
  scene.world.set_enabled(id, true);
  scene.run(kTick);
  CHECK(scene.world.velocity(id) == Vec3{});
  CHECK(scene.world.angular_velocity(id) == Vec3{});

  scene.world.apply_force(id, {6000, 0, 0});
  scene.world.sleep(id);
  scene.run(0.5);
  scene.world.wake(id);
  scene.run(kTick);
  CHECK(scene.world.velocity(id) == Vec3{});
}

TEST_CASE("changes: what hits a sleeper tells how fast it came, not how fast that once was", "[physics]") {
  Scene scene(weightless());
  const BodyId sleeper = scene.add(body(ball(0.5)), {});
  scene.world.set_velocity(sleeper, {-10, 0, 0});
  scene.run(kTick);
  scene.world.sleep(sleeper);
  const BodyId comer = scene.add(body(ball(0.5)), scene.at(sleeper) + Vec3{1.3, 0, 0});
  scene.run(kTick);
  scene.world.sleep(sleeper);
  scene.world.take_events();
  scene.world.set_velocity(comer, {-1, 0, 0});
  scene.run(0.5);
  const std::vector<ContactEvent> contacts = scene.world.take_events().contacts;
  REQUIRE(!contacts.empty());
  CHECK(contacts[0].speed == Approx(1));
}

TEST_CASE("changes: a joint that is configured each tick goes on as one that is not", "[physics]") {
  const auto run = [](bool configured) {
    Scene scene;
    std::vector<JointId> joints;
    BodyId before;
    for (int i = 0; i < 12; ++i) {
      const BodyId id = scene.add(body(box({0.4, 0.1, 0.1})), {0.25 + 0.5 * i, 0, 0});
      JointDef def;
      def.a = id;
      def.b = before;
      def.anchor = {-0.25, 0, 0};
      def.kind = BallDef{};
      joints.push_back(scene.world.add(def, 0));
      before = id;
    }
    for (int i = 0; i < 60; ++i) {
      if (configured) scene.world.configure(joints[3], JointDef(scene.world.def(joints[3])));
      scene.world.step(kTick);
    }
    return scene.world.hash();
  };
  CHECK(run(true) == run(false));
}

TEST_CASE("changes: a joint to the floor leaves what lies there alone", "[physics]") {
  Sleeper at;
  const BodyId post = at.scene.add(body(box({0.2, 1, 0.2})), {10, 3, 0});
  JointDef def;
  def.a = at.floor;
  def.b = post;
  def.anchor = {10, 3, 0};
  def.kind = FixedDef{};
  const JointId joint = at.scene.world.add(def, 0);
  at.scene.run(1);
  CHECK(at.scene.world.asleep(at.box_id));
  at.scene.world.remove(joint);
  at.scene.run(1);
  CHECK(at.scene.world.asleep(at.box_id));
  CHECK(at.scene.at(post).y == Approx(0.5).margin(1e-3));  // it meets the floor again
}

TEST_CASE("changes: a see-saw carries alike whether it or its rider came first", "[physics]") {
  for (const bool carrier_first : {true, false}) {
    Scene scene;
    BodyDef board = body(box({4, 0.2, 1}), BodyType::kinematic), rider = body(box({0.3, 0.3, 0.3}));
    board.friction = rider.friction = 2;
    const auto turned = [](double angle) { return Pose{{}, axis_angle({0, 0, 1}, angle)}; };
    const auto riding = [&](double angle) { return turned(angle) * Pose{{1.5, 0.25, 0}, {}}; };
    BodyId carrier, on;
    if (carrier_first) carrier = scene.world.add(board, turned(-0.25), 0);
    on = scene.world.add(rider, riding(-0.25), 0);
    if (!carrier_first) carrier = scene.world.add(board, turned(-0.25), 0);
    scene.run(0.5);
    double worst = 0;
    for (int i = 1; i <= 60; ++i) {
      const Pose now = turned(-0.25 + 0.5 * kTick * i);
      scene.world.move(carrier, now);
      scene.world.step(kTick);
      worst = std::max(worst, std::abs((inverse(now) * scene.at(on)).y - 0.25));
    }
    INFO("carrier first: " << carrier_first);
    CHECK(worst < 5e-4);
  }
}

TEST_CASE("changes: damping of any strength leaves a heap finite", "[physics]") {
  for (const double damping : {1e2, 3e4, 1e6}) {
    Scene scene;
    scene.floor();
    BodyDef def = body(box({1, 1, 1}));
    def.damping = def.angular_damping = damping;
    std::vector<BodyId> ids;
    for (int i = 0; i < 4; ++i) ids.push_back(scene.add(def, {0, 0.5 + 1.005 * i, 0}));
    scene.run(1);
    CHECK(scene.world.take_events().lost.empty());
    for (std::size_t i = 0; i < ids.size(); ++i) CHECK(scene.at(ids[i]).y == Approx(0.5 + 1.005 * static_cast<double>(i)).margin(0.02));
  }
}

TEST_CASE("changes: a slow belt carries on, and does not lay its load to sleep", "[physics]") {
  Sleeper at;
  at.make_belt(0.004);
  at.scene.run(5);
  CHECK(at.scene.at(at.box_id).x == Approx(0.02).epsilon(0.05));
}

TEST_CASE("changes: a joint tells the same force at any length of a step", "[physics]") {
  for (const double step : {1.0 / 60, 0.1, 0.2}) {
    Scene scene;
    const BodyId id = scene.add(body(box({1, 1, 1})), {0, 5, 0});
    JointDef def;
    def.a = id;
    def.anchor = {0, 5, 0};
    def.kind = FixedDef{};
    const JointId joint = scene.world.add(def, 0);
    scene.run(1, step);
    CHECK(length(scene.world.state(joint).force) == Approx(9.81 * scene.world.mass_properties(id).mass).epsilon(1e-3));
  }
}

TEST_CASE("changes: a body that is pushed hard does not go through what is thin", "[physics]") {
  for (const double pull : {200.0, 400.0, 2000.0})
    for (int start = 0; start < 40; ++start) {
      Scene scene(weightless());
      scene.add(body(box({2, 0.01, 2}), BodyType::fixed), {});
      const BodyId id = scene.add(body(ball(0.01)), {0, 0.015 + 0.001 * start, 0});
      const double mass = scene.world.mass_properties(id).mass;
      for (int i = 0; i < 30; ++i) {
        scene.world.apply_force(id, {0, -pull * mass, 0});
        scene.world.step(kTick);
      }
      INFO(pull << " m/s^2 from " << start << " mm");
      CHECK(scene.at(id).y > 0);
    }
}
