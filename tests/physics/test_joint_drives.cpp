#include "joint_bench.h"

using namespace tumble;

TEST_CASE("joints: a motor's torque accelerates by torque over inertia, whatever the step", "[physics]") {
  for (const double tick : {1.0 / 60, 1.0 / 120}) {
    TurnDef angle;
    angle.motor.emplace();
    angle.motor->speed = 100;
    angle.motor->strength = 3;
    Door door(angle);

    door.scene.run(0.5, tick);

    CHECK(door.state().speed == Approx(3 / kRodInertia * 0.5).epsilon(0.01));
  }
}

TEST_CASE("joints: a motor reaches its speed and holds it against a load", "[physics]") {
  SlideDef position;
  position.motor.emplace();
  position.motor->speed = 1.5;
  position.motor->strength = 100;
  Scene scene;
  BodyDef def = body(box({1, 1, 1}));
  def.mass = 5;
  const BodyId lift = scene.add(def, {});
  const JointId joint = scene.world.add(slider(lift, {0, 1, 0}, position), 0);

  scene.run(2);

  CHECK(scene.world.velocity(lift).y == Approx(1.5).epsilon(1e-3));
  CHECK(scene.world.state(joint).force.y == Approx(5 * 9.81).epsilon(1e-3));
}

TEST_CASE("joints: a motor with a target goes there, holds and does not overshoot by more than a degree", "[physics]") {
  TurnDef angle;
  angle.motor.emplace();
  angle.motor->target = radians(90);
  angle.motor->strength = 20;
  Door door(angle);
  double highest = 0;

  for (int i = 0; i < 180; ++i) {
    door.scene.world.step(kTick);
    highest = std::max(highest, door.state().position);
  }

  CHECK(degrees(door.state().position) == Approx(90).margin(0.1));
  CHECK(degrees(highest) < 91);
}

TEST_CASE("joints: a target far behind several turns is reached the long way", "[physics]") {
  TurnDef angle;
  angle.motor.emplace();
  angle.motor->target = 5 * kPi;
  angle.motor->speed = 8;
  Door door(angle);

  door.scene.run(3);

  CHECK(door.state().position == Approx(5 * kPi).margin(0.01));
}

TEST_CASE("joints: a spring swings at its frequency with the inertia about the hinge", "[physics]") {
  TurnDef angle;
  angle.spring.emplace();
  angle.spring->frequency = 2;
  Door door(angle);
  door.scene.world.set_angular_velocity(door.door, {0, 0, 1});
  door.scene.world.set_velocity(door.door, {0, 0.5, 0});

  double last = 0, first = 0, end = 0, highest = 0;
  int crossings = 0;
  for (int i = 1; i <= 300; ++i) {
    door.scene.world.step(kTick);
    const double x = door.state().position;
    if (last < 0 && x >= 0) {
      end = (i - x / (x - last)) * kTick;
      if (crossings++ == 0) first = end;
    }
    if (i > 240) highest = std::max(highest, x);
    last = x;
  }

  REQUIRE(crossings >= 8);
  CHECK((crossings - 1) / (end - first) == Approx(2).epsilon(0.005));
  CHECK(highest == Approx(1 / (2 * kPi * 2)).epsilon(0.1));  // hardly damped after eight swings
}

TEST_CASE("joints: a spring between two free bodies swings by their reduced mass, damped as told", "[physics]") {
  Scene scene(weightless());
  BodyDef light = body(box({1, 1, 1})), heavy = light;
  light.mass = 1;
  heavy.mass = 4;
  light.can_sleep = heavy.can_sleep = false;
  const BodyId a = scene.add(light, {2, 0, 0}), b = scene.add(heavy, {0, 0, 0});
  SlideDef position;
  position.spring.emplace();
  position.spring->frequency = 1.5;
  position.spring->damping = 0.2;
  position.spring->rest = 0.5;
  JointDef def = slider(a, {1, 0, 0}, position);
  def.b = b;
  const JointId joint = scene.world.add(def, 0);
  const double w = 2 * kPi * 1.5, z = 0.2, wd = w * std::sqrt(1 - z * z);

  for (int i = 1; i <= 60; ++i) {
    scene.world.step(kTick);
    const double t = i * kTick;
    const double x = 0.5 - 0.5 * std::exp(-z * w * t) * (std::cos(wd * t) + z * w / wd * std::sin(wd * t));
    // The recurrence is exact but for its start, half a substep late: w h / 2 of the amplitude.
    CHECK(scene.world.state(joint).position == Approx(x).margin(0.02));
  }
  CHECK(length(scene.world.momentum(a) + scene.world.momentum(b)) < 1e-9);
}

TEST_CASE("joints: friction stops a slide by F / m", "[physics]") {
  SlideDef position;
  position.friction = 4;
  Scene scene(weightless());
  BodyDef def = body(box({1, 1, 1}));
  def.mass = 2;
  const BodyId id = scene.add(def, {});
  scene.world.add(slider(id, {1, 0, 0}, position), 0);
  scene.world.set_velocity(id, {3, 0, 0});

  scene.run(3);

  CHECK(scene.at(id).x == Approx(9 / (2 * 2.0)).epsilon(0.01));
}

namespace {

// A sled of 4 kg on a slider along x with a spring of 2 Hz, and what else acts along it.
struct SprungSled {
  static constexpr double kMass = 4, kRate = kMass * (4 * kPi) * (4 * kPi);  // kg, N/m
  explicit SprungSled(SlideDef position, double damping = 0.5, double rest = 0) {
    position.spring.emplace();
    position.spring->frequency = 2;
    position.spring->damping = damping;
    position.spring->rest = rest;
    BodyDef def = body(box({1, 1, 1}));
    def.mass = kMass;
    def.can_sleep = false;
    joint = scene.world.add(slider(scene.add(def, {}), {1, 0, 0}, position), 0);
  }
  JointState after(double seconds) {
    scene.run(seconds);
    return scene.world.state(joint);
  }
  Scene scene{weightless()};
  JointId joint;
};

SlideDef driven(double speed, double strength) {
  SlideDef position;
  position.motor.emplace();
  position.motor->speed = speed;
  position.motor->strength = strength;
  return position;
}

}  // namespace

TEST_CASE("joints: a motor works against a spring of the same freedom, and where it is weak they balance at F / k", "[physics]") {
  SprungSled strong(driven(-0.25, 5000));
  const JointState pulled = strong.after(1);
  CHECK(pulled.speed == Approx(-0.25).epsilon(1e-6));
  CHECK(pulled.position == Approx(-0.25).epsilon(0.01));
  CHECK(SprungSled(driven(10, 20), 1).after(4).position == Approx(20 / SprungSled::kRate).epsilon(1e-6));
}

TEST_CASE("joints: friction holds a spring that pulls less, and lets one go that pulls more", "[physics]") {
  SlideDef rough;
  rough.friction = 20;  // N
  const double held = 20 / SprungSled::kRate;
  CHECK(std::abs(SprungSled(rough, 0.5, 0.9 * held).after(4).position) < 1e-9);
  // From rest, the sled swings half a turn about where spring and friction balance, and stays within their band.
  const double start = 2.5 * held;
  CHECK(SprungSled(rough, 0, start).after(4).position == Approx(3 * held).epsilon(0.01));
}

TEST_CASE("joints: a spring that presses on a limit presses with its own force", "[physics]") {
  SlideDef limited;
  limited.max = 0.05;
  SprungSled sled(limited, 1, 0.15);
  CHECK(sled.after(2).position == Approx(0.05).margin(1e-6));
  // The joint's force is what its rows give together: along the freedom, spring and limit cancel.
  CHECK(std::abs(sled.scene.world.state(sled.joint).force.x) < 1e-6);
}
