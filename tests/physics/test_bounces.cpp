// What flies fast touches for a part of a step only: it is told all the same, once, with the impulse that it took.
#include "physics/physical.h"

using namespace tumble;

namespace {

BodyDef bouncing(const Shape& shape, double restitution, BodyType type = BodyType::dynamic) {
  BodyDef def = body(shape, type);
  def.restitution = restitution;
  return def;
}

}  // namespace

TEST_CASE("bounces: each is told once, with the change of momentum", "[physics]") {
  int bounces = 0;
  for (const Shape& shape : {ball(0.1), box({0.2, 0.2, 0.2})})
    for (int start = 0; start < 40; ++start) {
      Scene scene;
      scene.add(body(box({40, 1, 40}), BodyType::fixed), {0, -0.5, 0});
      const BodyId id = scene.add(bouncing(shape, 0.8), {0, 3 + 0.01 * start, 0});
      const double mass = scene.world.mass_properties(id).mass;
      double before = 0;
      int turns = 0, enters = 0;
      for (int i = 0; i < 200; ++i) {
        scene.world.step(kTick);
        const double now = scene.world.velocity(id).y;
        if (before < -0.5 && now > 0) {
          ++turns;
          // Both legs of the step are in the difference of the speeds, and gravity's part of it.
          for (const ContactEvent& event : scene.world.take_events().contacts) {
            if (event.kind != EventKind::enter) continue;
            ++enters;
            CHECK(event.impulse == Approx(mass * (now - before + 9.81 * kTick)).epsilon(1e-6));
          }
        } else {
          for (const ContactEvent& event : scene.world.take_events().contacts) enters += event.kind == EventKind::enter;
        }
        before = now;
      }
      CHECK(turns >= 1);
      CHECK(enters == turns);
      bounces += turns;
    }
  CHECK(bounces > 80);
}

TEST_CASE("bounces: a tumbling box tells no impulse that it did not take", "[physics]") {
  for (int trial = 0; trial < 20; ++trial) {
    Scene scene(weightless());
    scene.add(body(box({2, 0.5, 2}), BodyType::fixed), {}, axis_angle({0, 0, 1}, 0.4));
    BodyDef def = bouncing(box({0.3, 0.6, 0.2}), 0.5);
    def.friction = 0;
    const BodyId id = scene.add(def, {0.05 * trial - 0.5, 1.5, 0});
    scene.world.set_velocity(id, {1, -12, 0.5});
    scene.world.set_angular_velocity(id, {5, 3.0 * trial, -8});
    scene.world.want_stay(id, true);
    const double mass = scene.world.mass_properties(id).mass;
    for (int i = 0; i < 40; ++i) {
      const Vec3 before = scene.world.velocity(id);
      scene.world.step(kTick);
      double told = 0;
      for (const ContactEvent& event : scene.world.take_events().contacts)
        if (event.kind != EventKind::exit) told += event.impulse;
      // Without friction each impulse is along a normal; several within a step may point in more than one direction.
      const double taken = mass * length(scene.world.velocity(id) - before);
      CHECK(told >= taken * (1 - 1e-6));
      if (taken == 0) CHECK(told == 0);
    }
  }
}

TEST_CASE("bounces: a ball that does not move throws others back wherever it is", "[physics]") {
  for (const BodyType type : {BodyType::fixed, BodyType::kinematic})
    for (const Vec3 place : {Vec3{}, Vec3{0, -5, 0}, Vec3{100, 7, -30}}) {
      Scene scene(weightless());
      scene.add(bouncing(ball(0.5), 0.5, type), place);
      const BodyId id = scene.add(bouncing(ball(0.5), 0.5), place + Vec3{0, 2, 0});
      scene.world.set_velocity(id, {0, -6, 0});
      scene.run(0.5);
      CHECK(scene.world.velocity(id).y == Approx(3));  // both restitutions are 0.5
      const std::vector<ContactEvent> contacts = scene.world.take_events().contacts;
      REQUIRE(!contacts.empty());
      CHECK(distance(contacts[0].point, place + Vec3{0, 0.5, 0}) < 0.01);
    }
}

TEST_CASE("bounces: a ball rolls down a ball that does not move by the same law everywhere", "[physics]") {
  // Without slip a = 5/7 g sin(angle); the spin is the speed of the centre over the radius.
  const auto spin_of = [](Vec3 place) {
    Scene scene;
    BodyDef hill = body(ball(2), BodyType::fixed), def = body(ball(0.2));
    hill.friction = def.friction = 1;
    scene.add(hill, place);
    const double angle = 0.2;
    const BodyId id = scene.add(def, place + Vec3{2.2 * std::sin(angle), 2.2 * std::cos(angle), 0});
    scene.run(0.8);
    CHECK(length(scene.world.velocity(id)) == Approx(0.2 * -scene.world.angular_velocity(id).z).epsilon(0.01));
    return scene.world.angular_velocity(id).z;
  };
  const double there = spin_of({});
  CHECK(there < -2);
  CHECK(spin_of({0, 50, 0}) == Approx(there).epsilon(1e-3));
  CHECK(spin_of({-30, 0, 12}) == Approx(there).epsilon(1e-3));
}

TEST_CASE("bounces: a ball that is moved does not sink into the one it hits", "[physics]") {
  Scene scene(weightless());
  const BodyId pusher = scene.add(body(ball(0.5), BodyType::kinematic), {});
  const BodyId pushed = scene.add(body(ball(0.5)), {1.35, 0, 0});
  double deepest = 0;
  for (int i = 1; i <= 60; ++i) {
    scene.world.move(pusher, {{6 * kTick * i, 0, 0}, {}});
    scene.world.step(kTick);
    deepest = std::max(deepest, 1 - (scene.at(pushed).x - scene.at(pusher).x));
  }
  CHECK(deepest < 1e-3);
}

TEST_CASE("bounces: an exit tells where they last touched", "[physics]") {
  Scene scene;
  scene.add(body(box({40, 1, 40}), BodyType::fixed), {0, -0.5, 0});
  for (int i = 0; i < 40; ++i) {
    const BodyId id = scene.add(bouncing(box({0.3, 0.5, 0.2}), 0.3), {0.8 * (i % 8), 1 + 0.1 * i, 0.8 * (i / 8)});
    scene.world.set_angular_velocity(id, {0.5 * i, 3, -0.3 * i});
  }
  int exits = 0;
  for (int i = 0; i < 300; ++i) {
    scene.world.step(kTick);
    for (const ContactEvent& event : scene.world.take_events().contacts) {
      if (event.kind != EventKind::exit) continue;
      ++exits;
      CHECK(length(event.normal) == Approx(1));
    }
  }
  CHECK(exits > 50);
}
