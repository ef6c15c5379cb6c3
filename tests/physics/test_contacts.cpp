#include <map>
#include <random>

#include "physical.h"

using namespace tumble;

namespace {

Events run_and_take(Scene& scene, double seconds) {
  scene.run(seconds);
  return scene.world.take_events();
}

}  // namespace

TEST_CASE("contacts: a fall is one enter with its speed and its whole impulse", "[physics]") {
  Scene scene;
  const BodyId ground = scene.floor();
  BodyDef def = body(box({1, 1, 1}));
  def.mass = 3;
  def.can_sleep = false;
  const BodyId id = scene.add(def, {0, 2.5, 0});

  double impulse = 0;
  std::vector<ContactEvent> enters;
  scene.world.want_stay(id, true);
  for (int i = 0; i < 90; ++i) {
    scene.world.step(kTick);
    for (const ContactEvent& event : scene.world.take_events().contacts) {
      impulse += event.impulse;
      if (event.kind == EventKind::enter) enters.push_back(event);
    }
  }

  REQUIRE(enters.size() == 1);
  CHECK(enters[0].a == ground);  // the older
  CHECK(enters[0].b == id);
  CHECK(enters[0].normal.y == Approx(1));
  CHECK(enters[0].point.y == Approx(0).margin(1e-9));  // on the floor, though it sank in by up to 26 mm in the substep
  // From 2 m: sqrt(2 g h), less at most one tick of gravity.
  CHECK(enters[0].speed == Approx(std::sqrt(2 * 9.81 * 2)).margin(9.81 * kTick + 1e-6));
  // The floor stopped all that gravity gave in 1.5 s, up to the millinewton seconds of its breathing.
  CHECK(impulse == Approx(3 * 9.81 * 1.5).epsilon(2e-3));
}

TEST_CASE("contacts: one exit for one enter, by leaving, removal, teleport, disabling and new colliders", "[physics]") {
  Scene scene;
  scene.floor();
  const auto settle = [&](BodyId id) {
    const Events events = run_and_take(scene, 0.5);
    CHECK(count(events.contacts, EventKind::enter, false) == 1);
    CHECK(count(events.contacts, EventKind::exit, false) == 0);
    CHECK(scene.world.contacts(id).size() == 1);
  };
  const auto ended = [&] {
    const Events events = run_and_take(scene, 0.1);
    CHECK(count(events.contacts, EventKind::exit, false) == 1);
    CHECK(count(events.contacts, EventKind::enter, false) == 0);
  };
  const BodyDef def = body(box({1, 1, 1}));

  BodyId id = scene.add(def, {0, 0.5, 0});
  settle(id);
  scene.world.set_velocity(id, {0, 3, 0});
  ended();
  scene.run(2);
  scene.world.take_events();
  scene.world.teleport(id, {{0, 5, 0}, {}});
  ended();
  scene.world.teleport(id, {{0, 0.5, 0}, {}});
  settle(id);
  scene.world.set_enabled(id, false);
  ended();
  scene.world.set_enabled(id, true);
  settle(id);
  BodyDef smaller = scene.world.def(id);
  smaller.colliders = {collider(box({0.5, 0.5, 0.5}))};
  scene.world.configure(id, smaller);
  const Events events = run_and_take(scene, 0.5);
  CHECK(count(events.contacts, EventKind::exit, false) == 1);
  CHECK(count(events.contacts, EventKind::enter, false) == 1);
  scene.world.remove(id);
  ended();
}

TEST_CASE("contacts: removal tells the exit at once, without a step", "[physics]") {
  Scene scene;
  const BodyId ground = scene.floor();
  const BodyId id = scene.add(body(box({1, 1, 1})), {0, 0.5, 0});
  scene.run(0.2);
  scene.world.take_events();

  scene.world.remove(id);

  const Events events = scene.world.take_events();
  REQUIRE(events.contacts.size() == 1);
  CHECK(events.contacts[0].kind == EventKind::exit);
  CHECK(events.contacts[0].b == id);
  CHECK(scene.world.contacts(ground).empty());
}

TEST_CASE("contacts: falling asleep ends nothing and asleep means no stays", "[physics]") {
  Scene scene;
  scene.floor();
  const BodyId id = scene.add(body(box({1, 1, 1})), {0, 0.5, 0});
  scene.world.want_stay(id, true);

  const Events events = run_and_take(scene, 3);

  REQUIRE(scene.world.asleep(id));
  CHECK(count(events.contacts, EventKind::exit, false) == 0);
  CHECK(count(events.contacts, EventKind::stay, false) > 5);
  CHECK(events.sleeps.size() == 1);
  CHECK(scene.world.contacts(id).size() == 1);
  CHECK(run_and_take(scene, 0.5).contacts.empty());
}

TEST_CASE("contacts: a trigger is its exact shape, not its box", "[physics]") {
  Scene scene(weightless());
  BodyDef zone = body(box({10, 0.2, 2}), BodyType::fixed);
  zone.trigger = true;
  const BodyId trigger = scene.add(zone, {}, axis_angle({0, 0, 1}, radians(45)));
  // In the corner of the slab's box, 2 m from the slab.
  const BodyId visitor = scene.add(body(ball(0.5)), {-2, 2 - 0.0, 0}, {});

  CHECK(run_and_take(scene, 0.2).contacts.empty());
  scene.world.teleport(visitor, {{2, 2.5, 0}, {}});  // 0.35 m from its middle plane
  const Events events = run_and_take(scene, 0.2);

  REQUIRE(count(events.contacts, EventKind::enter, true) == 1);
  CHECK(scene.world.overlapping(trigger) == std::vector<BodyId>{visitor});
  CHECK(scene.world.overlapping(visitor) == std::vector<BodyId>{trigger});
  CHECK(scene.world.contacts(visitor).empty());
}

TEST_CASE("contacts: a trigger hears dynamic and kinematic bodies, not static ones, and stops nobody", "[physics]") {
  Scene scene;
  BodyDef zone = body(box({4, 1, 4}), BodyType::kinematic);
  zone.trigger = true;
  scene.add(zone, {0, 2, 0});
  scene.add(body(box({1, 1, 1}), BodyType::fixed), {1, 2, 1});
  const BodyId gate = scene.add(body(box({0.5, 0.5, 0.5}), BodyType::kinematic), {-1, 2, -1});
  const BodyId stone = scene.add(body(ball(0.1)), {0, 4, 0});

  const Events events = run_and_take(scene, 1);

  std::vector<BodyId> visitors;
  for (const ContactEvent& event : events.contacts)
    if (event.kind == EventKind::enter) visitors.push_back(event.b);
  CHECK(visitors == std::vector<BodyId>{gate, stone});
  CHECK(count(events.contacts, EventKind::exit, true) == 1);
  CHECK(scene.at(stone).y == Approx(4 - 9.81 / 2).epsilon(1e-9));
}

TEST_CASE("contacts: one collider of a body may be the trigger", "[physics]") {
  Scene scene(weightless());
  BodyDef def;
  def.colliders = {collider(ball(0.5)), collider(ball(2))};
  def.colliders[1].trigger = true;
  const BodyId id = scene.add(def, {});
  const BodyId visitor = scene.add(body(ball(0.5)), {2, 0, 0});

  const Events events = run_and_take(scene, kTick);

  REQUIRE(events.contacts.size() == 1);
  CHECK(events.contacts[0].trigger);
  CHECK(events.contacts[0].collider_a == 1);
  scene.world.set_velocity(visitor, {-1, 0, 0});
  const Events later = run_and_take(scene, 2);
  CHECK(count(later.contacts, EventKind::enter, false) == 1);
  CHECK(scene.world.velocity(id).x < -0.1);  // the small one is solid
}

TEST_CASE("contacts: a trigger that moves over a sleeper hears it and loses it", "[physics]") {
  Scene scene;
  scene.floor();
  const BodyId sleeper = scene.add(body(box({1, 1, 1})), {0, 0.5, 0});
  BodyDef zone = body(box({1, 1, 1}), BodyType::kinematic);
  zone.trigger = true;
  const BodyId trigger = scene.add(zone, {5, 0.5, 0});
  scene.run(2);
  REQUIRE(scene.world.asleep(sleeper));
  scene.world.take_events();

  scene.world.move(trigger, {{0.2, 0.5, 0}, {}});
  CHECK(count(run_and_take(scene, 0.1).contacts, EventKind::enter, true) == 1);
  CHECK(scene.world.asleep(sleeper));  // a trigger wakes nobody
  scene.world.move(trigger, {{5, 0.5, 0}, {}});
  CHECK(count(run_and_take(scene, 0.1).contacts, EventKind::exit, true) == 1);
}

TEST_CASE("contacts: what was put to sleep in flight meets a blow with no speed", "[physics]") {
  Scene scene(weightless());
  BodyDef def = body(ball(0.5));
  def.velocity = {5, 0, 0};
  const BodyId sleeper = scene.add(def, {});
  // 30 mm apart after a few ticks: one later it is so near that the step that wakes the sleeper is that of the blow.
  def.velocity = {-1, 0, 0};
  scene.add(def, {1 + 0.03 + 2 * kTick * (5 + 1) + 3 * kTick, 0, 0});
  scene.run(2 * kTick);
  scene.world.sleep(sleeper);

  const Events events = run_and_take(scene, 0.2);

  REQUIRE(count(events.contacts, EventKind::enter, false) == 1);
  CHECK(events.contacts[0].speed == Approx(1));
}

TEST_CASE("contacts: groups meet only where both agree", "[physics]") {
  WorldSettings settings;
  settings.groups = {"player", "ghost"};
  Scene scene(settings);
  scene.floor();
  const auto drop = [&](std::string group, std::vector<std::string> collides_with, double x) {
    BodyDef def = body(ball(0.5));
    def.group = group;
    def.collides_with = collides_with;
    return scene.add(def, {x, 1, 0});
  };
  const BodyId plain = drop("", {}, 0), walker = drop("player", {"default"}, 3), ghost = drop("ghost", {"player"}, 6);

  scene.run(1);

  CHECK(scene.at(plain).y == Approx(0.5).margin(0.01));
  CHECK(scene.at(walker).y == Approx(0.5).margin(0.01));
  CHECK(scene.at(ghost).y < -1);  // the floor would have it, but it does not want the floor
  CHECK_THROWS_WITH(drop("palyer", {}, 9), Catch::Contains("no collision group 'palyer'") && Catch::Contains("did you mean 'player'"));
}

TEST_CASE("contacts: every enter is followed by exactly one exit, whatever comes and goes", "[physics]") {
  std::mt19937 random(7);
  const auto between = [&](double low, double high) { return low + (high - low) * (random() / 4294967296.0); };
  Scene scene;
  const BodyId ground = scene.floor();
  std::vector<BodyId> bodies;
  std::map<std::tuple<BodyId, BodyId, bool>, int> open;
  int enters = 0;

  const auto listen = [&] {
    for (const ContactEvent& event : scene.world.take_events().contacts) {
      int& state = open[{event.a, event.b, event.trigger}];
      if (event.kind == EventKind::enter) {
        REQUIRE(state == 0);
        state = 1;
        ++enters;
      } else if (event.kind == EventKind::exit) {
        REQUIRE(state == 1);
        state = 0;
      }
    }
  };
  for (int i = 0; i < 400; ++i) {
    const Vec3 place{between(-2, 2), between(0, 4), between(-2, 2)};
    const auto pick = [&]() -> std::size_t { return random() % bodies.size(); };
    switch (bodies.size() < 5 ? 0 : random() % 8) {
      case 0:
      case 1: {
        BodyDef def = body(random() % 2 ? ball(0.4) : box({0.8, 0.5, 0.6}), static_cast<BodyType>(random() % 3 == 0 ? 2 : 0));
        def.trigger = random() % 4 == 0;
        def.restitution = 0.5;
        bodies.push_back(scene.add(def, place));
        break;
      }
      case 2: {
        const std::size_t at = pick();
        scene.world.remove(bodies[at]);
        bodies.erase(bodies.begin() + static_cast<std::ptrdiff_t>(at));
        break;
      }
      case 3: scene.world.teleport(bodies[pick()], {place, {}}); break;
      case 4: scene.world.set_enabled(bodies[pick()], random() % 3 != 0); break;
      case 5: {
        const BodyId id = bodies[pick()];
        BodyDef def = scene.world.def(id);
        def.trigger = !def.trigger;
        scene.world.configure(id, def);
        break;
      }
      case 6: scene.world.apply_impulse(bodies[pick()], place); break;
      default: scene.world.move(bodies[pick()], {place, {}}); break;
    }
    if (random() % 3 != 0) scene.world.step(kTick);
    listen();
  }
  scene.world.remove(ground);
  for (const BodyId id : bodies) scene.world.remove(id);
  listen();

  CHECK(enters > 100);
  for (const auto& [key, state] : open) CHECK(state == 0);
}

TEST_CASE("contacts: what is told of a contact that stays is of the last step", "[physics]") {
  Scene scene;
  const BodyId floor = scene.floor();
  const BodyId cube = scene.add(body(box({1, 1, 1})), {0, 0.5, 0});
  const auto load = [&] {
    double sum = 0;
    scene.world.each_contact([&](const ContactEvent& contact) { sum += contact.a == floor ? contact.impulse : 0; });
    REQUIRE(scene.world.contacts(floor).size() == 1);
    CHECK(scene.world.contacts(floor)[0].impulse == Approx(sum));
    return sum;
  };
  scene.run(0.25);
  CHECK(load() == Approx(9.81 * kTick).epsilon(1e-3));

  for (int i = 0; i < 30; ++i) {
    scene.world.apply_force(cube, {0, -20, 0});
    scene.world.step(kTick);
  }

  CHECK(load() == Approx((9.81 + 20) * kTick).epsilon(1e-3));
}

TEST_CASE("contacts: a plank that tips over the seam of two triangles does not fall through", "[physics]") {
  Shape ground;
  ground.shape = ShapeKind::mesh;
  const Vec3 a{-10, 0, -10}, b{-10, 0, 10}, c{10, 0, 10}, d{10, 0, -10};
  ground.points = {a, b, c, a, c, d};
  BodyDef def = body(box({2, 0.06, 2}));
  def.mass = 10;
  for (int i = 0; i < 48; ++i) {
    INFO("start " << i);
    const double part = i / 48.0;
    Scene scene;
    scene.add(body(ground, BodyType::fixed), {});
    const BodyId plank = scene.add(def, {0, 5 + 0.1 * part, 0}, axis_angle({1, 0, 0}, 0.1 + 0.9 * part) * axis_angle({0, 0, 1}, 0.2));
    scene.run(2);
    CHECK(scene.at(plank).y > 0.02);
  }
}

TEST_CASE("contacts: a capsule walks along a wall of tiles as along one piece", "[physics]") {
  const auto walk = [](bool tiles) {
    Scene scene;
    scene.floor();
    if (!tiles) scene.add(body(box({16, 3, 1}), BodyType::fixed), {0, 1.5, 0.5});
    for (int x = -8; tiles && x < 8; ++x)
      for (int y = 0; y < 3; ++y) scene.add(body(box({1, 1, 1}), BodyType::fixed), {x + 0.5, y + 0.5, 0.5});
    BodyDef walker = body(upright(ShapeKind::capsule, 0.3, 1.8));
    walker.mass = 70;
    walker.lock_rotation = "xyz";
    const BodyId id = scene.add(walker, {-6, 0.9, -0.3});
    for (int tick = 0; tick < 180; ++tick) {
      scene.world.set_velocity(id, {4, scene.world.velocity(id).y, 1});  // pressed against it, too
      scene.world.step(kTick);
    }
    return scene.at(id);
  };
  CHECK(distance(walk(true), walk(false)) < 1e-3);
}
