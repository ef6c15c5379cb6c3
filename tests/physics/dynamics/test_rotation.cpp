#include "physics/dynamics/rotation.h"

#include <catch2/catch.hpp>

namespace tumble::dynamics {

namespace {

constexpr Vec3 kBook{208, 160, 80};  // a box of 2 x 4 x 6 m and 48 kg

struct Spinner {
  Quat rotation;
  Vec3 spin, inertia = kBook;

  Vec3 momentum() const { return rotation * scaled(inertia, conjugate(rotation) * spin); }
  double energy() const { return dot(spin, momentum()) / 2; }
  void run(double seconds, double h) {
    for (long i = 0; i < std::lround(seconds / h); ++i) turn(rotation, spin, inertia, h);
  }
};

}  // namespace

TEST_CASE("rotation: a rotation vector turns by its length about its direction", "[physics]") {
  for (const double angle : {1e-9, 1e-4, 0.3, 3.0, 40.0}) {
    const Quat q = turned_by({}, Vec3{0, 0, angle});

    const Vec3 x = q * Vec3{1, 0, 0};
    CHECK(x.x == Approx(std::cos(angle)).margin(1e-14));
    CHECK(x.y == Approx(std::sin(angle)).margin(1e-14));
  }
}

TEST_CASE("rotation: a tumbling body keeps its angular momentum, and its energy to a thousandth for a minute", "[physics]") {
  Spinner book{{}, {0.01, 5, 0.01}};
  const Vec3 momentum = book.momentum();
  const double energy = book.energy();

  double worst = 0;
  for (int i = 0; i < 60; ++i) {
    book.run(1, 1.0 / 240);
    worst = std::max(worst, std::abs(book.energy() / energy - 1));
  }

  CHECK(distance(book.momentum(), momentum) / length(momentum) < 1e-10);  // rounding of 14400 steps
  CHECK(worst < 1e-3);
}

TEST_CASE("rotation: half the step, a quarter of the error", "[physics]") {
  // A symmetric body turns about its momentum at L / I1 (Poinsot), known in closed form: the axis's direction after t.
  const auto error = [](double h) {
    Spinner top{{}, {2, 20, 0}, {1, 2, 1}};
    const Vec3 momentum = top.momentum(), about = normalized(momentum);
    const Vec3 axis = turned_by({}, about * (length(momentum) / 1)) * Vec3{0, 1, 0};
    top.run(1, h);
    return distance(top.rotation * Vec3{0, 1, 0}, axis);
  };

  CHECK(error(1.0 / 240) / error(1.0 / 480) == Approx(4).epsilon(0.05));
  CHECK(error(1.0 / 960) < 1e-3);
}

TEST_CASE("rotation: a spin of many turns in a step is not cut", "[physics]") {
  Spinner ball{{}, {0, 0, 1000}, {1, 1, 1}}, rod{{}, {0, 0, 1000}, {5, 5, 1}};

  ball.run(1.0 / 60, 1.0 / 60);
  rod.run(1.0 / 60, 1.0 / 60);

  const double angle = 1000.0 / 60;
  for (const Spinner& s : {ball, rod}) {
    CHECK((s.rotation * Vec3{1, 0, 0}).x == Approx(std::cos(angle)).margin(1e-9));
    CHECK(s.spin.z == Approx(1000));
  }
}

}  // namespace tumble::dynamics
