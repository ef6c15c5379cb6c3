#include "physics/dynamics/energy.h"

#include <catch2/catch.hpp>

#include <deque>

#include "physics/dynamics/island.h"
#include "physics/joint.h"

using namespace tumble;
using namespace tumble::dynamics;

namespace {

constexpr double kGravity = 9.81;

double mass(const Mover& mover) { return 1 / mover.inverse_mass.x; }

// Rods of 1 m and 1 kg from the origin along x, on balls. `hung` from the origin, or with nothing to hold them.
struct Rods {
  JointKind kind = BallDef{};
  std::deque<Mover> movers;
  std::deque<Link> links;
  std::vector<Link*> all;
  std::vector<Mover*> bodies;
  long substeps = 0, changes = 0;  // of the run

  Rods(int count, bool hung) {
    movers.emplace_back();  // what cannot move
    for (int i = 0; i < count; ++i) {
      Mover& mover = movers.emplace_back();
      mover.position = {i + 0.5, 0, 0};
      mover.pushable = mover.bound = true;
      mover.inverse_mass = {1, 1, 1};
      mover.inertia = {0.002, 1.0 / 12, 1.0 / 12};
      mover.acceleration = {0, -kGravity, 0};
      mover.refresh();
      bodies.push_back(&mover);
      if (i == 0 && !hung) continue;
      Link& link = links.emplace_back();
      link.kind = &kind;
      link.a = &mover;
      link.b = &movers[static_cast<std::size_t>(i)];
      link.local_a.position = {-0.5, 0, 0};
      link.local_b.position = {i == 0 ? 0 : 0.5, 0, 0};
      all.push_back(&link);
      refresh(link);
    }
  }
  double energy() const {
    double sum = 0;
    for (const Mover* mover : bodies) sum += kinetic_energy(*mover) + mass(*mover) * kGravity * mover->position.y;
    return sum;
  }
  Vec3 momentum() const {
    Vec3 sum;
    for (const Mover* mover : bodies) sum += mover->velocity * mass(*mover);
    return sum;
  }
  Vec3 angular_momentum() const {
    Vec3 sum;
    for (const Mover* mover : bodies)
      sum += cross(mover->position, mover->velocity) * mass(*mover) + turned(mover->rotation, mover->inertia) * mover->spin;
    return sum;
  }
  // Largest way of the energy from the start up and down.
  std::pair<double, double> run_for(double seconds) {
    const double start = energy();
    double up = 0, down = 0;
    Mechanism mechanism(all);
    int last = 4;
    for (int tick = 0; tick < std::lround(seconds * 60); ++tick) {
      std::vector<Island> islands = find_islands(movers, {}, {&mechanism});
      const int count = run(islands.front(), 1.0 / 60, 4, 1);
      substeps += count;
      changes += count != last;
      last = count;
      up = std::max(up, energy() - start);
      down = std::max(down, start - energy());
    }
    return {up, down};
  }
};

}  // namespace

TEST_CASE("energy: pendulums that whip keep theirs though the substeps change on the way", "[physics][dynamics]") {
  for (const int count : {2, 10}) {
    Rods rods(count, true);
    const double scale = kGravity * count * count / 2;  // from level to hanging

    const auto [up, down] = rods.run_for(60);

    INFO(count << " rods");
    CHECK(up < 1e-3 * scale);
    CHECK(down < 5e-3 * scale);
    CHECK(rods.changes > 20);
  }
}

TEST_CASE("energy: what is given to a mechanism changes neither momentum nor, where it floats, angular momentum", "[physics][dynamics]") {
  Rods rods(3, false);
  for (std::size_t i = 0; i < 3; ++i) rods.bodies[i]->spin = {0.3, 1.0 - static_cast<double>(i), 2.0 * static_cast<double>(i)};
  for (std::size_t i = 1; i < 3; ++i)  // joints stay together
    rods.bodies[i]->velocity = rods.bodies[i - 1]->velocity_at({0.5, 0, 0}) - cross(rods.bodies[i]->spin, {-0.5, 0, 0});
  const double before = rods.energy();
  const Vec3 momentum = rods.momentum(), angular = rods.angular_momentum();

  REQUIRE(add_energy(rods.bodies, rods.all, 1e-3));

  CHECK(rods.energy() - before == Approx(1e-3).epsilon(1e-9));
  CHECK(distance(rods.momentum(), momentum) < 1e-12);
  CHECK(distance(rods.angular_momentum(), angular) < 1e-12);
  for (Link* link : rods.all)
    for (const JointRow& row : link->rows.held) CHECK(std::abs(speed(*link, row)) < 1e-12);
}

TEST_CASE("energy: what hangs from a ball keeps its angular momentum about the vertical when energy is given", "[physics][dynamics]") {
  Rods rods(2, true);
  rods.bodies[0]->spin = {0, 2, 1};
  rods.bodies[0]->velocity = cross(rods.bodies[0]->spin, {0.5, 0, 0});
  rods.bodies[1]->spin = {0, -1, 3};
  rods.bodies[1]->velocity = cross(rods.bodies[0]->spin, {1, 0, 0}) + cross(rods.bodies[1]->spin, {0.5, 0, 0});
  const double before = rods.energy();
  const Vec3 angular = rods.angular_momentum();

  REQUIRE(add_energy(rods.bodies, rods.all, -1e-3));

  CHECK(rods.energy() - before == Approx(-1e-3).epsilon(1e-9));
  CHECK(rods.angular_momentum().y == Approx(angular.y).epsilon(1e-12));
}

TEST_CASE("energy: none is given to what moves as one", "[physics][dynamics]") {
  Rods rods(2, false);
  for (Mover* mover : rods.bodies) mover->velocity = {1, 2, 3};

  CHECK_FALSE(add_energy(rods.bodies, rods.all, 1e-3));
  CHECK(rods.bodies[0]->velocity == Vec3{1, 2, 3});
}
