#include "physics/dynamics/mechanism.h"

#include <catch2/catch.hpp>

#include <deque>

#include "physics/joint.h"

using namespace tumble;
using dynamics::Link;
using dynamics::Mechanism;
using dynamics::Mover;

namespace {

constexpr double kGravity = 9.81;

// Rods of 1 m along a direction from the origin, joined by balls, and the steps of the solver around one mechanism.
struct Chain {
  std::deque<Mover> movers;
  std::deque<Link> links;
  JointKind kind = BallDef{};
  std::unique_ptr<Mechanism> mechanism;

  Mover& rod(Vec3 center, Vec3 along, double mass) {
    Mover& mover = movers.emplace_back();
    mover.position = center;
    mover.rotation = between({1, 0, 0}, along);
    mover.pushable = true;
    mover.inverse_mass = Vec3{1, 1, 1} / mass;
    mover.inertia = Vec3{0.001, 1.0 / 12 + 0.001, 1.0 / 12 + 0.001} * mass;
    mover.acceleration = {0, -kGravity, 0};
    mover.refresh();
    return mover;
  }
  void join(Mover& a, Vec3 at_a, Mover& b, Vec3 at_b) {
    Link& link = links.emplace_back();
    link.kind = &kind;
    link.a = &a;
    link.b = &b;
    link.local_a.position = at_a;
    link.local_b.position = at_b;
  }
  Chain(int count, Vec3 along, double last_mass = 1) {
    movers.emplace_back();  // the wall
    for (int i = 0; i < count; ++i) rod(along * (i + 0.5), along, i + 1 == count ? last_mass : 1);
    for (int i = 0; i < count; ++i)
      join(movers[static_cast<std::size_t>(i) + 1], {-0.5, 0, 0}, movers[static_cast<std::size_t>(i)], {i == 0 ? 0 : 0.5, 0, 0});
  }
  void run(double seconds, double h) {
    std::vector<Link*> list;
    for (Link& link : links) list.push_back(&link);
    mechanism = std::make_unique<Mechanism>(list);
    for (long i = 0; i < std::lround(seconds / h); ++i) {
      for (Link& link : links) link.impulse = link.twist = {};
      mechanism->begin_step(h);
      mechanism->begin();
      for (Mover& mover : movers)
        if (mover.pushable) kick_before(mover, h);
      mechanism->solve_before(h);
      for (Mover& mover : movers) drift(mover, h);
      mechanism->close_gaps(h);
      mechanism->turn_to_now(h);
      for (Mover& mover : movers)
        if (mover.pushable) kick_after(mover, h);
      mechanism->solve_after(h);
    }
  }
  double gap() {
    double most = 0;
    for (Link& link : links) {
      const JointFrame now = dynamics::frame(link);
      most = std::max(most, distance(now.a.position, now.b.position));
    }
    return most;
  }
  double energy() const {
    double sum = 0;
    for (const Mover& mover : movers) {
      if (!mover.pushable) continue;
      const Vec3 spin = conjugate(mover.rotation) * mover.spin;
      const double mass = 1 / mover.inverse_mass.x;
      sum += (mass * dot(mover.velocity, mover.velocity) + dot(scaled(mover.inertia, spin), spin)) / 2 + mass * kGravity * mover.position.y;
    }
    return sum;
  }
};

}  // namespace

TEST_CASE("mechanism: a double pendulum keeps its energy for ten seconds", "[physics][dynamics]") {
  Chain chain(2, {1, 0, 0});
  const double start = chain.energy();

  chain.run(10, 1.0 / 240);

  // Over what it can turn into motion: 2 rods from level to hanging.
  CHECK(std::abs(chain.energy() - start) < 2e-3 * kGravity * (0.5 + 1.5));
  CHECK(chain.gap() < 1e-8);
}

TEST_CASE("mechanism: each joint of a hanging chain bears what is below, a thousand times a link's weight too", "[physics][dynamics]") {
  Chain chain(10, {0, -1, 0}, 1000);

  chain.run(2, 1.0 / 240);

  for (std::size_t i = 0; i < chain.links.size(); ++i) {
    const double below = 1000 + 9 - static_cast<double>(i);
    CHECK(chain.links[i].impulse.y * 240 == Approx(below * kGravity).epsilon(1e-6));
  }
  CHECK(chain.gap() < 1e-8);
}

TEST_CASE("mechanism: a taut rope between two walls has no way to fall, and does not burst", "[physics][dynamics]") {
  Chain chain(20, {1, 0, 0});
  Mover& wall = chain.movers.emplace_back();
  wall.position = {20, 0, 0};
  chain.join(chain.movers[20], {0.5, 0, 0}, wall, {});
  const double start = chain.energy();

  chain.run(3, 1.0 / 240);

  CHECK(chain.gap() < 0.01);
  CHECK(chain.energy() < start + 1e-3 * 20 * kGravity);
}
