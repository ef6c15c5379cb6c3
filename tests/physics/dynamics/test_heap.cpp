#include "physics/dynamics/heap.h"

#include <catch2/catch.hpp>

#include <deque>
#include <random>

#include "physics/physical.h"

using namespace tumble;
using dynamics::Contact;
using dynamics::HeapOf;
using dynamics::Island;
using dynamics::Mover;

namespace {

constexpr double kStep = 1.0 / 60;
constexpr int kSubsteps = 4, kRounds = 2;

// Cubes of 1 m and 1 kg on each other, each turned a little, that press on one another with what is above them.
struct Towers {
  std::deque<Mover> movers;
  std::deque<Contact> contacts;
  Island island;

  explicit Towers(int towers, int height, unsigned seed = 3, double gap = 1e-3) {
    std::mt19937 random(seed);
    const auto some = [&](double most) { return std::uniform_real_distribution<double>(-most, most)(random); };
    Mover& floor = movers.emplace_back();
    for (int t = 0; t < towers; ++t) {
      Mover* below = &floor;
      for (int i = 0; i < height; ++i) {
        Mover& cube = add({3.0 * t + some(0.05), 0.5 + i, some(0.05)}, {some(0.1), some(0.1), some(0.1)});
        touch(cube, *below, i, some(gap));
        below = &cube;
      }
    }
    for (Contact& contact : contacts) island.contacts.push_back(&contact);
  }

  Mover& add(Vec3 position, Vec3 velocity) {
    Mover& mover = movers.emplace_back();
    mover.position = position;
    mover.velocity = velocity;
    mover.pushable = true;
    mover.inverse_mass = {1, 1, 1};
    mover.inertia = {1.0 / 6, 1.0 / 6, 1.0 / 6};
    mover.acceleration = {0, -9.81, 0};
    mover.refresh();
    island.movers.push_back(&mover);
    return mover;
  }
  void touch(Mover& upper, Mover& lower, int level, double separation) {
    Contact& contact = contacts.emplace_back();
    contact.a = &upper;
    contact.b = &lower;
    contact.set_normal({0, 1, 0});
    contact.friction = 0.5;
    contact.limit_push();
    contact.count = 4;
    for (int k = 0; k < 4; ++k) {
      const Vec3 arm{k & 1 ? 0.45 : -0.45, -0.5, k & 2 ? 0.45 : -0.45};
      contact.points[k].arm_a = arm;
      contact.points[k].arm_b = upper.position + arm - lower.position;
      contact.points[k].separation = separation;
      contact.points[k].impulse = 2.0 * level;
    }
  }
  template <class F>
  void run() {
    Team team(1);
    HeapOf<F> heap;
    heap.add(island);
    heap.run(kStep, kSubsteps, kRounds, team);
  }
};

}  // namespace

TEST_CASE("heap: four lanes give the numbers of one", "[physics][dynamics]") {
  Towers wide(7, 5), narrow(7, 5);

  wide.run<dynamics::Four>();
  narrow.run<float>();

  for (std::size_t i = 0; i < wide.movers.size(); ++i) {
    CHECK(wide.movers[i].position == narrow.movers[i].position);
    CHECK(wide.movers[i].velocity == narrow.movers[i].velocity);
    CHECK(wide.movers[i].spin == narrow.movers[i].spin);
  }
  for (std::size_t i = 0; i < wide.contacts.size(); ++i) CHECK(wide.contacts[i].pressing() == narrow.contacts[i].pressing());
}

TEST_CASE("heap: any number of threads gives the same", "[physics][dynamics]") {
  Towers one(60, 9, 5), three(60, 9, 5);
  one.run<dynamics::Four>();

  Team team(3);
  HeapOf<dynamics::Four> heap;
  heap.add(three.island);
  heap.run(kStep, kSubsteps, kRounds, team);

  for (std::size_t i = 0; i < one.movers.size(); ++i) {
    CHECK(one.movers[i].velocity == three.movers[i].velocity);
    CHECK(one.movers[i].position == three.movers[i].position);
  }
}

TEST_CASE("heap: islands that are solved together do not know of each other", "[physics][dynamics]") {
  Towers alone(1, 9, 5), together(1, 9, 5), other(3, 4, 8);
  Team team(1);
  HeapOf<dynamics::Four> heap;
  heap.add(other.island);
  heap.add(together.island);

  alone.run<dynamics::Four>();
  heap.run(kStep, kSubsteps, kRounds, team);

  for (std::size_t i = 0; i < alone.movers.size(); ++i) CHECK(alone.movers[i].velocity == together.movers[i].velocity);
}

// The scalar islands of island.h solve the same equations, with other rounding and another order of contacts.
TEST_CASE("heap: goes the way of the scalar islands where both converge", "[physics][dynamics]") {
  Towers wide(3, 3, 3, 0), scalar(3, 3, 3, 0);

  Team team(1);
  HeapOf<dynamics::Four> heap;
  heap.add(wide.island);
  heap.run(kStep, 32, 60, team);
  dynamics::run(scalar.island, kStep, 32, 60);

  for (std::size_t i = 0; i < wide.movers.size(); ++i) {
    CHECK(distance(wide.movers[i].position, scalar.movers[i].position) < 2e-4);
    CHECK(distance(wide.movers[i].velocity, scalar.movers[i].velocity) < 0.02);
  }
}

TEST_CASE("heap: what touches nothing flies as in a vacuum, with damping and torque too", "[physics][dynamics]") {
  Towers flight(0, 0);
  Mover& mover = flight.add({0, 100, 0}, {3, 1, -2});
  Mover& floor = flight.movers.front();
  flight.touch(mover, floor, 0, 50);
  flight.island.contacts.push_back(&flight.contacts.back());
  mover.damping = 0.7;
  mover.torque = {0, 0.5, 0};

  for (int i = 0; i < 60; ++i) flight.run<dynamics::Four>();

  // v' = a - k v, and a torque about a principal axis.
  const double k = 0.7, lost = (1 - std::exp(-k)) / k, fall = -9.81 / k;
  CHECK(mover.position.x == Approx(3 * lost).epsilon(1e-5));
  CHECK(mover.position.y == Approx(100 + (1 - fall) * lost + fall).epsilon(1e-5));
  CHECK(mover.velocity.y == Approx((1 - fall) * std::exp(-k) + fall).epsilon(1e-5));
  CHECK(mover.spin.y == Approx(0.5 * 6).epsilon(1e-5));
}

TEST_CASE("heap: a wall comes to rest, and its floor bears its weight", "[physics]") {
  Scene scene;
  const BodyId floor = scene.floor();
  std::vector<BodyId> bricks;
  for (int row = 0; row < 5; ++row)
    for (int column = 0; column < 6; ++column) bricks.push_back(scene.add(body(box({1, 0.5, 0.5})), {column * 1.01 + 0.5 * (row % 2), 0.25 + 0.5 * row, 0}));

  scene.run(3);

  double speed = 0, borne = 0;
  for (const BodyId id : bricks) speed = std::max(speed, length(scene.world.velocity(id)));
  for (const ContactEvent& contact : scene.world.contacts(floor)) borne += contact.impulse * std::abs(contact.normal.y);
  CHECK(speed < 1e-3);
  CHECK(borne == Approx(30 * 9.81 * kTick).epsilon(1e-3));
}

// Nothing pushes its columns aside: they would topple by what a solver leaves of the blow.
TEST_CASE("heap: a wall that lands stays a wall", "[physics]") {
  for (const double height : {4.8, 4.95, 5.05}) {
    Scene scene;
    scene.floor();
    std::vector<std::pair<BodyId, Vec3>> cubes;
    for (int row = 0; row < 10; ++row)
      for (int column = 0; column < 10; ++column) {
        BodyDef cube = body(box({1, 1, 1}));
        cube.friction = 0.6;
        const double x = (column - 4.5) * 1.002;
        cubes.emplace_back(scene.add(cube, {x, height + 0.5 + row * 1.002, 0}), Vec3{x, row + 0.5, 0});
      }
    scene.run(5);
    for (const auto& [cube, place] : cubes) CHECK(distance(scene.at(cube), place) < 0.05);
  }
}

TEST_CASE("heap: a belt and a carrier take it along", "[physics]") {
  for (const bool belt : {true, false}) {
    Scene scene;
    BodyDef ground = body(box({40, 1, 40}), belt ? BodyType::fixed : BodyType::kinematic);
    if (belt) ground.surface_velocity = {1, 0, 0};
    const BodyId carrier = scene.add(ground, {0, -0.5, 0});
    std::vector<BodyId> cubes;
    for (int i = 0; i < 12; ++i) cubes.push_back(scene.add(body(box({0.5, 0.5, 0.5})), {0.52 * (i % 4), 0.25 + 0.5 * (i / 4), 0}));

    for (int i = 1; i <= 120; ++i) {
      if (!belt) scene.world.move(carrier, {{i / 60.0, -0.5, 0}, {}});
      scene.world.step(kTick);
    }

    INFO((belt ? "a belt" : "a carrier"));
    for (const BodyId id : cubes) {
      CHECK(scene.world.velocity(id).x == Approx(1).margin(1e-3));
      CHECK(std::abs(scene.world.velocity(id).y) < 1e-3);
    }
  }
}

TEST_CASE("heap: slides at once where friction's default is taken away", "[physics]") {
  WorldSettings settings;
  settings.gravity = {1.5, -9.81, 0};  // held by 0.25, the product of both defaults, of 9.81
  settings.sleeping = false;
  Scene scene(settings);
  scene.floor();
  std::vector<BodyId> cubes;
  for (int i = 0; i < 12; ++i) cubes.push_back(scene.add(body(box({0.5, 0.5, 0.5})), {0.52 * (i % 4), 0.25 + 0.5 * (i / 4), 0}));
  scene.run(1);
  for (const BodyId id : cubes) CHECK(length(scene.world.velocity(id)) < 0.01);

  settings.default_friction = 0;
  scene.world.configure(settings);
  scene.run(0.5);

  double sum = 0;
  for (const BodyId id : cubes) sum += scene.world.velocity(id).x;
  CHECK(sum / 12 == Approx(0.75).epsilon(0.02));  // all of 1.5 m/s^2 for half a second
}
