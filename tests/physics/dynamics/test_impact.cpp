#include "physics/dynamics/impact.h"

#include <catch2/catch.hpp>

#include <deque>

#include "physics/physical.h"

using namespace tumble;
using dynamics::Contact;
using dynamics::Mover;

namespace {

// Balls of 1 kg and radius 0.5 m, without weight.
struct Balls {
  std::deque<Mover> movers;
  std::deque<Contact> contacts;

  Mover& ball(Vec3 position, Vec3 velocity) {
    Mover& mover = movers.emplace_back();
    mover.position = position;
    mover.velocity = velocity;
    mover.pushable = true;
    mover.inverse_mass = {1, 1, 1};
    mover.inertia = {0.1, 0.1, 0.1};
    mover.refresh();
    return mover;
  }
  void meet(Mover& a, Mover& b, double restitution) {
    Contact& contact = contacts.emplace_back();
    contact.a = &a;
    contact.b = &b;
    contact.radius_a = contact.radius_b = 0.5;
    contact.set_normal(normalized(a.position - b.position));
    contact.count = 1;
    contact.points[0].restitution = restitution;
  }
  void step(double h) {
    std::vector<Contact*> list;
    for (Contact& contact : contacts) list.push_back(&contact);
    for (Contact& contact : contacts) contact.begin(h);
    for (Mover& mover : movers) kick_before(mover, h);
    for (Contact& contact : contacts) contact.foresee(h);
    dynamics::bounce(list, {}, h);
    for (Mover& mover : movers) drift(mover, h);
    for (Mover& mover : movers) kick_after(mover, h);
  }
};

}  // namespace

TEST_CASE("impact: a row of balls that touch hands a blow on to the last", "[physics][dynamics]") {
  Balls row;
  for (int i = 0; i < 5; ++i) row.ball({i == 0 ? -0.01 : static_cast<double>(i), 0, 0}, {i == 0 ? 2.0 : 0.0, 0, 0});
  for (std::size_t i = 0; i < 4; ++i) row.meet(row.movers[i], row.movers[i + 1], 1);

  row.step(1.0 / 60);

  for (std::size_t i = 0; i < 4; ++i) CHECK(length(row.movers[i].velocity) < 1e-12);
  CHECK(row.movers[4].velocity.x == Approx(2));
  // The first went 1 cm to the others, the last all the rest of the way.
  CHECK(row.movers[0].position.x == Approx(0).margin(1e-12));
  CHECK(row.movers[4].position.x == Approx(4 + 2.0 / 60 - 0.01));
}

TEST_CASE("impact: two balls that meet aside part along the line of their centres where they met", "[physics][dynamics]") {
  for (const double e : {0.0, 0.5, 1.0}) {
    Balls pair;
    Mover &fast = pair.ball({-1.02, 0.4, 0}, {4, 0, 0}), &still = pair.ball({0, 0, 0}, {});
    pair.meet(fast, still, e);

    pair.step(1.0 / 20);

    if (e == 0) continue;  // those are the solver's business
    const Vec3 n{-std::sqrt(1 - 0.16), 0.4, 0};  // from the other to the fast one
    const double impulse = -(1 + e) * 4 * n.x / 2;
    CHECK(distance(fast.velocity, Vec3{4, 0, 0} + n * impulse) < 1e-9);
    CHECK(distance(still.velocity, n * -impulse) < 1e-9);
    const double met = (1.02 + n.x) / 4, left = 1.0 / 20 - met;
    CHECK(distance(still.position, n * (-impulse * left)) < 1e-9);
  }
}

TEST_CASE("impact: a hit that falls between two steps is one", "[physics]") {
  for (const double speed : {1.0, 3.7, 4.0, 16.0}) {
    Scene scene(weightless());
    scene.add(body(box({1, 4, 4}), BodyType::fixed), {0.5, 0, 0});
    BodyDef def = body(ball(0.5));
    def.velocity = {speed, 0, 0};
    def.restitution = 1;
    const BodyId id = scene.add(def, {-0.5 - 6 * speed * kTick, 0, 0});

    scene.run(0.2);

    INFO(speed << " m/s");
    CHECK(scene.world.velocity(id).x == Approx(-speed));
  }
}
