#include "physics/dynamics/oscillator.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace tumble;

namespace {

// x'' + 2 z w x' + w^2 x = 0 by the classical Runge-Kutta method.
dynamics::Swing integrated(dynamics::Swing s, double w, double z, double seconds) {
  constexpr int steps = 20000;
  const double h = seconds / steps;
  const auto rate = [&](dynamics::Swing at) { return dynamics::Swing{at.velocity, -2 * z * w * at.velocity - w * w * at.position}; };
  const auto moved = [](dynamics::Swing at, dynamics::Swing by, double t) {
    return dynamics::Swing{at.position + by.position * t, at.velocity + by.velocity * t};
  };
  for (int i = 0; i < steps; ++i) {
    const auto a = rate(s), b = rate(moved(s, a, h / 2)), c = rate(moved(s, b, h / 2)), d = rate(moved(s, c, h));
    s.position += h / 6 * (a.position + 2 * b.position + 2 * c.position + d.position);
    s.velocity += h / 6 * (a.velocity + 2 * b.velocity + 2 * c.velocity + d.velocity);
  }
  return s;
}

}  // namespace

TEST_CASE("oscillator: it goes where the equation takes it, at any damping", "[physics][dynamics]") {
  for (const double z : {0.0, 0.1, 0.999999, 1.0, 1.000001, 5.0}) {
    INFO("damping ratio " << z);
    const dynamics::Swing start{0.7, -3}, is = dynamics::swung(start, 12, z, 0.8), should = integrated(start, 12, z, 0.8);
    CHECK(is.position == Approx(should.position).margin(1e-9));
    CHECK(is.velocity == Approx(should.velocity).margin(1e-8));
  }
}

TEST_CASE("oscillator: two halves are one whole, and nothing is too stiff", "[physics][dynamics]") {
  for (const double w : {1e-3, 1.0, 1e4, 1e8}) {
    INFO("w " << w);
    const dynamics::Swing start{1, 0}, whole = dynamics::swung(start, w, 3, 0.1);
    const dynamics::Swing halves = dynamics::swung(dynamics::swung(start, w, 3, 0.05), w, 3, 0.05);
    CHECK(halves.position == Approx(whole.position).margin(1e-12));
    CHECK(std::abs(whole.position) <= 1);
  }
}
