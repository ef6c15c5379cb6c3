#include <map>

#include "physical.h"

using namespace tumble;

namespace {

BodyDef zone(Vec3 size, BodyType type = BodyType::fixed) {
  BodyDef def = body(box(size), type);
  def.trigger = true;
  return def;
}

// A scene that keeps when its triggers were crossed, in seconds since it began.
struct Timed : Scene {
  using Scene::Scene;
  void steps(int count, const std::function<void(double now)>& before = {}) {
    for (int i = 0; i < count; ++i) {
      if (before) before(now);
      world.step(kTick);
      for (const ContactEvent& event : world.take_events().contacts) {
        if (event.kind == EventKind::enter) entered.push_back(now + event.time);
        if (event.kind == EventKind::exit) left.push_back(now + event.time);
        told.push_back(event);
      }
      now += kTick;
    }
  }
  double now = 0;
  std::vector<double> entered, left;
  std::vector<ContactEvent> told;
};

double fall_time(double way) { return std::sqrt(2 * way / 9.81); }

// The distances of shapes are exact to 1e-10 of their size, and the slowest here takes a microsecond for as much.
constexpr double kExact = 1e-8;

Approx exactly(double value) { return Approx(value).epsilon(0).margin(kExact); }

}  // namespace

TEST_CASE("triggers: a fall through one is told to the time of the formula, wherever in a tick it is", "[physics]") {
  for (int phase = 0; phase < 16; ++phase) {
    Timed scene;
    scene.add(zone({4, 1, 4}), {0, 2, 0});
    const double start = 10 + 0.0131 * phase;
    scene.add(body(ball(0.25)), {0, start, 0});

    scene.steps(100);

    REQUIRE(scene.entered.size() == 1);
    REQUIRE(scene.left.size() == 1);
    CHECK(scene.entered[0] == exactly(fall_time(start - 2.75)));
    CHECK(scene.left[0] == exactly(fall_time(start - 1.25)));
  }
}

TEST_CASE("triggers: what goes through between two steps has both its times, and leaves after it came", "[physics]") {
  for (int phase = 0; phase < 16; ++phase) {
    Timed scene(weightless());
    scene.add(zone({0.01, 4, 4}), {});
    BodyDef def = body(ball(0.1));
    def.velocity = {300, 0, 0};
    const double start = 20 + 5.0 * phase / 16;
    scene.add(def, {-start, 0, 0});

    scene.steps(12);

    REQUIRE(scene.told.size() == 2);
    CHECK(scene.told[0].kind == EventKind::enter);
    CHECK(scene.told[1].kind == EventKind::exit);
    CHECK(scene.entered[0] == exactly((start - 0.105) / 300));
    CHECK(scene.left[0] == exactly((start + 0.105) / 300));
  }
}

TEST_CASE("triggers: an exit told a step late lies before that step", "[physics]") {
  Timed scene(weightless());
  scene.add(zone({0.01, 4, 4}), {});
  BodyDef def = body(ball(0.1));
  def.velocity = {300, 0, 0};
  scene.add(def, {-2.5, 0, 0});

  scene.steps(2);

  REQUIRE(scene.told.size() == 2);
  CHECK(scene.told[0].time == exactly(2.395 / 300));
  CHECK(scene.told[1].time == exactly(2.605 / 300 - kTick));
}

TEST_CASE("triggers: a carrier hears and is heard along the way that it is led", "[physics]") {
  const auto [moved, other] = GENERATE(std::pair(body(ball(0.1), BodyType::kinematic), zone({0.01, 4, 4})),
                                       std::pair(zone({0.01, 4, 4}, BodyType::kinematic), body(ball(0.1), BodyType::kinematic)));
  Timed scene(weightless());
  scene.add(other, {});
  const BodyId carrier = scene.add(moved, {-2.5, 0, 0});

  // 4.2 m a tick, so that it is never seen inside at the end of one.
  scene.steps(4, [&](double now) { scene.world.move(carrier, {{-2.5 + 252 * (now + kTick), 0, 0}, {}}); });

  REQUIRE(scene.entered.size() == 1);
  REQUIRE(scene.left.size() == 1);
  CHECK(scene.entered[0] == exactly(2.395 / 252));
  CHECK(scene.left[0] == exactly(2.605 / 252));
}

TEST_CASE("triggers: a corner that turns in and out again has its times", "[physics]") {
  Timed scene(weightless());
  scene.add(zone({1, 4, 4}), {1.1, 0, 0});
  BodyDef def = body(box({1, 1, 1}));
  def.angular_velocity = {0, 0, 1};
  scene.add(def, {});

  scene.steps(90);

  // It reaches sqrt(1/2) cos(45 degrees - angle) along x, and the trigger's face is at 0.6.
  const double reach = std::acos(0.6 / std::sqrt(0.5));
  REQUIRE(scene.entered.size() == 1);
  REQUIRE(scene.left.size() == 1);
  CHECK(scene.entered[0] == exactly(kPi / 4 - reach));
  CHECK(scene.left[0] == exactly(kPi / 4 + reach));
}

TEST_CASE("triggers: a trigger that is a part of what falls is timed by that part", "[physics]") {
  Timed scene;
  BodyDef faller;
  faller.colliders = {collider(box({1, 1, 1})), collider(ball(0.5), {0, -2, 0})};
  faller.colliders[1].trigger = true;
  scene.add(faller, {3, 9, 0});
  scene.add(body(ball(0.2), BodyType::kinematic), {3, 1, 0});

  scene.steps(70);

  REQUIRE_FALSE(scene.entered.empty());
  CHECK(scene.entered[0] == exactly(fall_time(9 - 2 - 0.5 - 1.2)));
}

TEST_CASE("triggers: a mesh is timed by the triangle that comes first", "[physics]") {
  Timed scene;
  Shape ground;
  ground.shape = ShapeKind::mesh;
  ground.points = {{-5, 0, -5}, {-5, 0, 5}, {5, 0, 5}, {-5, 0, -5}, {5, 0, 5}, {5, 0, -5}, {0, 2, 0}, {-5, 0, 5}, {5, 0, 5}};
  scene.add(body(ground, BodyType::kinematic), {});
  BodyDef faller = zone({0.5, 0.5, 0.5}, BodyType::dynamic);
  scene.add(faller, {0, 5, -0.2});

  scene.steps(80);

  // The highest corner is at z = 0, under the box.
  REQUIRE_FALSE(scene.entered.empty());
  CHECK(scene.entered[0] == exactly(fall_time(5 - 0.25 - 2)));
}

TEST_CASE("triggers: what comes and goes between two steps does so when the next begins", "[physics]") {
  Timed scene(weightless());
  const BodyId trigger = scene.add(zone({2, 2, 2}), {10, 0, 0});
  const BodyId visitor = scene.add(body(ball(0.5)), {});
  scene.steps(3);

  scene.world.teleport(visitor, {{10, 0, 0}, {}});
  scene.steps(1);
  scene.world.teleport(visitor, {{}, {}});
  scene.steps(1);
  scene.world.teleport(trigger, {{}, {}});
  scene.steps(1);
  scene.world.remove(visitor);
  scene.steps(1);

  REQUIRE(scene.told.size() == 4);
  for (const ContactEvent& event : scene.told) CHECK(event.time == 0);
}

TEST_CASE("triggers: while something stays the time told is the step's end", "[physics]") {
  Timed scene(weightless());
  scene.add(zone({2, 2, 2}), {});
  const BodyId visitor = scene.add(body(ball(0.5)), {});
  scene.world.want_stay(visitor, true);

  scene.steps(3);

  REQUIRE(scene.told.size() == 3);
  CHECK(scene.told[2].kind == EventKind::stay);
  CHECK(scene.told[2].time == kTick);
}

TEST_CASE("triggers: what is thrown up into one and falls out again has the times of one parabola", "[physics]") {
  Timed scene;
  scene.add(zone({4, 1, 4}), {0, 1.8, 0});   // from 1.3 up; the ball's top comes to 1.3 + 0.039
  BodyDef def = body(ball(0.25));
  def.velocity = {0, 4.62, 0};
  scene.add(def, {});

  scene.steps(60);

  const double high = 1.3 - 0.25, root = std::sqrt(4.62 * 4.62 - 2 * 9.81 * high);
  REQUIRE(scene.entered.size() == 1);
  REQUIRE(scene.left.size() == 1);
  CHECK(scene.entered[0] == exactly((4.62 - root) / 9.81));
  CHECK(scene.left[0] == exactly((4.62 + root) / 9.81));
}

TEST_CASE("triggers: a beam that turns hears what it lies on", "[physics]") {
  for (const double step : {4.0, 10.0})
    for (int k = 1; k <= 8; ++k) {
      Scene scene(weightless());
      BodyDef beam;
      beam.type = BodyType::kinematic;
      beam.colliders = {collider(box({10, 0.2, 0.2}), {5.1, 0, 0})};
      beam.colliders[0].trigger = true;
      const BodyId turning = scene.add(beam, {});
      const double angle = radians(step * k);
      scene.add(body(ball(0.05)), {9.5 * std::cos(angle), 9.5 * std::sin(angle), 0});
      int enters = 0;
      for (int i = 1; i <= 10; ++i) {
        scene.world.move(turning, {{}, axis_angle({0, 0, 1}, radians(step * i))});
        scene.world.step(kTick);
        enters += count(scene.world.take_events().contacts, EventKind::enter, true);
      }
      CHECK(enters == 1);
    }
}
