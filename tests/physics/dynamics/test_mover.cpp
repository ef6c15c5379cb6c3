#include "physics/dynamics/mover.h"

#include <catch2/catch.hpp>

using namespace tumble;
using dynamics::Mover;

namespace {

Mover brick() {
  Mover mover;
  mover.pushable = true;
  mover.inverse_mass = {0.5, 0.5, 0.5};
  mover.inertia = {1, 2, 3};
  mover.rotation = normalized(Quat{0.1, 0.5, -0.3, 0.8});
  mover.refresh();
  return mover;
}

Vec3 angular_momentum(const Mover& mover) { return mover.rotation * scaled(mover.inertia, conjugate(mover.rotation) * mover.spin); }

void fly(Mover& mover, double seconds, int steps) {
  for (int i = 0; i < steps; ++i) {
    dynamics::kick_before(mover, seconds / steps);
    dynamics::drift(mover, seconds / steps);
    dynamics::kick_after(mover, seconds / steps);
  }
}

}  // namespace

TEST_CASE("mover: free flight is the parabola at any step", "[physics][dynamics]") {
  for (const int steps : {1, 7, 240}) {
    Mover mover = brick();
    mover.velocity = {3, 4, 5};
    mover.acceleration = {0.5, -9.81, 0};

    fly(mover, 2, steps);

    CHECK(distance(mover.position, Vec3{3 * 2 + 0.5 * 4 / 2, 4 * 2 - 9.81 * 4 / 2, 5 * 2}) < 1e-12);
    CHECK(distance(mover.velocity, Vec3{4, 4 - 9.81 * 2, 5}) < 1e-12);
  }
}

TEST_CASE("mover: damping is that of its equation at any step", "[physics][dynamics]") {
  constexpr double k = 0.7, g = -9.81, seconds = 3;
  for (const int steps : {1, 50}) {
    Mover mover = brick();
    mover.velocity = {10, 0, 0};
    mover.acceleration = {0, g, 0};
    mover.damping = k;

    fly(mover, seconds, steps);

    const double kept = std::exp(-k * seconds);
    CHECK(mover.velocity.x == Approx(10 * kept).epsilon(1e-12));
    CHECK(mover.position.x == Approx(10 / k * (1 - kept)).epsilon(1e-12));
    CHECK(mover.position.y == Approx(g / k * (seconds - (1 - kept) / k)).epsilon(1e-12));
  }
}

TEST_CASE("mover: a locked axis neither turns nor is pushed, the others turn as about a bearing", "[physics][dynamics]") {
  Mover mover = brick();
  mover.turn_factor = {1, 0, 1};
  mover.refresh();

  mover.push({}, {1, 5, -2});

  CHECK(mover.spin.y == 0);
  // The block of the inertia without y, inverted by hand.
  const dynamics::Symmetric i = dynamics::turned(mover.rotation, mover.inertia);
  const double d = i.xx * i.zz - i.xz * i.xz;
  CHECK(mover.spin.x == Approx((i.zz * 1 - i.xz * -2) / d));
  CHECK(mover.spin.z == Approx((i.xx * -2 - i.xz * 1) / d));
}

TEST_CASE("mover: a shift of its pose changes no momentum", "[physics][dynamics]") {
  Mover mover = brick();
  mover.spin = {3, -20, 7};
  const Vec3 before = angular_momentum(mover);

  mover.shift({0.1, 0, 0}, {0.3, 0.2, -0.4});

  CHECK(distance(angular_momentum(mover), before) < 1e-12 * length(before));
}

TEST_CASE("symmetric: an inverse times its matrix is one", "[physics][dynamics]") {
  const dynamics::Symmetric m = dynamics::turned(normalized(Quat{0.4, -0.2, 0.7, 0.1}), {0.2, 5, 40});
  const dynamics::Symmetric back = dynamics::inverse(m);
  for (const Vec3 e : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) CHECK(distance(back * (m * e), e) < 1e-12);
}
