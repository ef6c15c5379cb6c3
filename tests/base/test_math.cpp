#include "base/math.h"

#include <catch2/catch.hpp>
#include <random>

using namespace tumble;

namespace {

// A rotation about one axis of the frame, by its textbook matrix: the independent way to what the quaternions do.
struct Matrix {
  Vec3 x, y, z;  // columns
  Vec3 operator*(Vec3 v) const { return x * v.x + y * v.y + z * v.z; }
};
Matrix about_x(double a) { return {{1, 0, 0}, {0, std::cos(a), std::sin(a)}, {0, -std::sin(a), std::cos(a)}}; }
Matrix about_y(double a) { return {{std::cos(a), 0, -std::sin(a)}, {0, 1, 0}, {std::sin(a), 0, std::cos(a)}}; }
Matrix about_z(double a) { return {{std::cos(a), std::sin(a), 0}, {-std::sin(a), std::cos(a), 0}, {0, 0, 1}}; }

class Randoms {
 public:
  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  Vec3 vector() { return {number(-1, 1), number(-1, 1), number(-1, 1)}; }
  Quat rotation() { return normalized(Quat{number(-1, 1), number(-1, 1), number(-1, 1), number(-1, 1)}); }

 private:
  std::mt19937_64 engine_{1};
};

// Rounding of a few dozen operations on numbers near 1.
constexpr double kTolerance = 1e-13;

bool near(Vec3 a, Vec3 b, double tolerance = kTolerance) { return length(a - b) <= tolerance; }
bool same_rotation(Quat a, Quat b, double tolerance = kTolerance) {
  return near(a * Vec3{1, 0, 0}, b * Vec3{1, 0, 0}, tolerance) && near(a * Vec3{0, 1, 0}, b * Vec3{0, 1, 0}, tolerance);
}

}  // namespace

TEST_CASE("math: a quaternion turns right-handed about its axis", "[base]") {
  CHECK(near(axis_angle({0, 3, 0}, kPi / 2) * Vec3{0, 0, -1}, {-1, 0, 0}));
  CHECK(near(axis_angle({0, 0, 1}, kPi / 2) * Vec3{1, 0, 0}, {0, 1, 0}));
}

TEST_CASE("math: a product turns by its right factor first, and the conjugate turns back", "[base]") {
  Randoms random;
  for (int i = 0; i < 100; ++i) {
    const Quat a = random.rotation(), b = random.rotation();
    const Vec3 v = random.vector();
    CHECK(near((a * b) * v, a * (b * v)));
    CHECK(near(conjugate(a) * (a * v), v));
    CHECK(length(a * v) == Approx(length(v)));
  }
}

TEST_CASE("math: Euler angles are the product of matrices about y, x and z", "[base]") {
  Randoms random;
  for (int i = 0; i < 100; ++i) {
    const Vec3 angles = random.vector() * kPi, v = random.vector();
    CHECK(near(from_euler(angles) * v, about_y(angles.y) * (about_x(angles.x) * (about_z(angles.z) * v))));
  }
}

TEST_CASE("math: to_euler gives angles that make the same rotation", "[base]") {
  Randoms random;
  for (int i = 0; i < 1000; ++i) {
    const Quat q = random.rotation();
    const Vec3 angles = to_euler(q);
    CHECK(std::abs(angles.x) <= kPi / 2);
    CHECK(same_rotation(from_euler(angles), q, 1e-10));
  }
}

TEST_CASE("math: Euler angles within their range come back", "[base]") {
  Randoms random;
  for (int i = 0; i < 100; ++i) {
    const Vec3 angles{random.number(-1.5, 1.5), random.number(-3, 3), random.number(-3, 3)};
    CHECK(near(to_euler(from_euler(angles)), angles, 1e-12));
  }
}

TEST_CASE("math: looking straight up or down has a yaw and no roll", "[base]") {
  for (const double x : {kPi / 2, -kPi / 2})
    for (double y = -3; y <= 3; y += 0.5)
      for (const double z : {0.0, 0.7}) {
        const Quat q = from_euler({x, y, z});
        const Vec3 angles = to_euler(q);
        CHECK(angles.z == 0);
        CHECK(same_rotation(from_euler(angles), q, 1e-7));
      }
}

TEST_CASE("math: look_rotation turns -z to forward and keeps y as near to up as it can", "[base]") {
  Randoms random;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 forward = normalized(random.vector()), up = normalized(random.vector());
    const Quat q = look_rotation(forward * 5, up);
    CHECK(near(q * Vec3{0, 0, -1}, forward, 1e-12));
    CHECK(std::abs(dot(q * Vec3{1, 0, 0}, up)) < 1e-12);
    CHECK(dot(q * Vec3{0, 1, 0}, up) >= -1e-12);
  }
}

TEST_CASE("math: look_rotation along up is a rotation all the same", "[base]") {
  for (const Vec3& forward : {Vec3{0, 1, 0}, Vec3{0, -1, 0}}) {
    const Quat q = look_rotation(forward);
    CHECK(length(q) == Approx(1));
    CHECK(near(q * Vec3{0, 0, -1}, forward));
  }
  CHECK(near(look_rotation({1, 0, 0}, {1, 0, 0}) * Vec3{0, 0, -1}, {1, 0, 0}));
  CHECK(look_rotation({}) == Quat{});
}

TEST_CASE("math: between takes one direction to the other by the smallest angle", "[base]") {
  Randoms random;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 a = normalized(random.vector()), b = normalized(random.vector());
    const Quat q = between(a * 2, b * 3);
    CHECK(near(q * a, b, 1e-12));
    CHECK(2 * std::acos(std::min(1.0, q.w)) == Approx(std::acos(dot(a, b))).margin(1e-6));
  }
}

TEST_CASE("math: between opposite directions turns half way round", "[base]") {
  for (const Vec3& a : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}, normalized(Vec3{1, 2, 3})})
    CHECK(near(between(a, -a) * a, -a, 1e-12));
}

TEST_CASE("math: slerp turns at a constant rate and the short way", "[base]") {
  const Quat a = axis_angle({0, 1, 0}, 0.2), b = axis_angle({0, 1, 0}, 1.4);
  const Quat far_side{-b.x, -b.y, -b.z, -b.w};
  for (double t = 0; t <= 1; t += 0.125) {
    CHECK(same_rotation(slerp(a, b, t), axis_angle({0, 1, 0}, 0.2 + 1.2 * t), 1e-12));
    CHECK(same_rotation(slerp(a, far_side, t), axis_angle({0, 1, 0}, 0.2 + 1.2 * t), 1e-12));
  }
}

TEST_CASE("math: slerp of nearly equal rotations stays between them", "[base]") {
  const Quat a = axis_angle({1, 0, 0}, 0.3), b = axis_angle({1, 0, 0}, 0.3 + 1e-9);
  CHECK(same_rotation(slerp(a, b, 0.5), axis_angle({1, 0, 0}, 0.3 + 0.5e-9), 1e-14));
  CHECK(same_rotation(slerp(a, a, 0.5), a));
}

TEST_CASE("math: poses compose like the points they move, and invert", "[base]") {
  Randoms random;
  for (int i = 0; i < 100; ++i) {
    const Pose a{random.vector(), random.rotation()}, b{random.vector(), random.rotation()};
    const Vec3 v = random.vector();
    CHECK(near((a * b) * v, a * (b * v)));
    CHECK(near(inverse(a) * (a * v), v));
  }
}

TEST_CASE("math: what has no direction is normalized to a harmless value", "[base]") {
  CHECK(normalized(Vec3{}) == Vec3{});
  CHECK(normalized(Quat{0, 0, 0, 0}) == Quat{});
}
