// Contacts that can be told by hand.
#include "pairs.h"

using namespace tumble;
using namespace tumble::pairs;

namespace {

const Convex kTable = make_box({2, 0.5, 2});
const Pose kTablePose{{0, -0.5, 0}, {}};  // its top at y = 0

Look on_table(const Convex& shape, const Pose& pose, double margin = 0.05) { return look(shape, pose, kTable, kTablePose, margin); }

bool has_point(const Manifold& m, Vec3 on_a, double near = 1e-9) {
  return std::any_of(m.points, m.points + m.count, [&](const Point& p) { return distance(p.on_a, on_a) < near; });
}

}  // namespace

TEST_CASE("pairs: a box on a table stands on its four corners", "[physics][pairs]") {
  const Convex box = make_box({0.5, 0.25, 0.3});
  for (const double gap : {-0.01, -1e-6, 0.0, 0.004}) {
    const Quat turn = axis_angle({0, 1, 0}, 0.3);
    const Look seen = on_table(box, {{0.2, 0.25 + gap, -0.1}, turn});

    REQUIRE(seen.manifold.count == 4);
    CHECK(distance(seen.manifold.normal, {0, 1, 0}) < 1e-12);
    for (const double x : {-0.5, 0.5})
      for (const double z : {-0.3, 0.3}) CHECK(has_point(seen.manifold, Vec3{0.2, gap, -0.1} + turn * Vec3{x, 0, z}));
    for (int i = 0; i < 4; ++i) CHECK(seen.manifold.points[i].separation == Approx(gap).margin(1e-12));
  }
}

TEST_CASE("pairs: a box over the table's rim stands on two corners and on the rim", "[physics][pairs]") {
  const Look seen = on_table(make_box({0.5, 0.25, 0.3}), {{1.8, 0.249, 0}, {}});

  REQUIRE(seen.manifold.count == 4);
  for (const double x : {1.3, 2.0})
    for (const double z : {-0.3, 0.3}) CHECK(has_point(seen.manifold, {x, -0.001, z}));
}

TEST_CASE("pairs: nothing is found beyond the margin", "[physics][pairs]") {
  CHECK_FALSE(on_table(make_box({0.5, 0.25, 0.3}), {{0, 0.31, 0}, {}}).found);
  CHECK(on_table(make_box({0.5, 0.25, 0.3}), {{0, 0.299, 0}, {}}).found);
  CHECK_FALSE(on_table(make_cylinder(0.3, 0.25), {{0, 0.31, 0}, {}}).found);
  CHECK_FALSE(on_table(make_sphere(0.25), {{0, 0.31, 0}, {}}).found);
}

TEST_CASE("pairs: points keep their names while bodies move a little", "[physics][pairs]") {
  const Convex box = make_box({0.5, 0.25, 0.3});
  const auto names = [](const Look& seen) {
    std::vector<std::uint32_t> all;
    for (int i = 0; i < seen.manifold.count; ++i) all.push_back(seen.manifold.points[i].feature);
    std::sort(all.begin(), all.end());
    return all;
  };
  const Look first = on_table(box, {{1.8, 0.249, 0.1}, axis_angle({0, 1, 0}, 0.4)});
  const Look second = on_table(box, {{1.81, 0.2491, 0.11}, axis_angle({0, 1, 0}, 0.41)});

  CHECK(first.manifold.count == 4);
  CHECK(names(first) == names(second));
  const std::vector<std::uint32_t> all = names(first);
  CHECK(std::adjacent_find(all.begin(), all.end()) == all.end());
}

TEST_CASE("pairs: two crossed edges touch at one point", "[physics][pairs]") {
  // Two cubes of 1 m, each turned by 45 degrees so that an edge looks at the other: along x below, along z above.
  const Convex cube = make_box({0.5, 0.5, 0.5});
  const double reach = std::sqrt(0.5);
  const Pose below{{}, axis_angle({1, 0, 0}, kPi / 4)}, above{{0.1, 2 * reach - 0.002, -0.2}, axis_angle({0, 0, 1}, kPi / 4)};

  const Look seen = look(cube, above, cube, below);

  REQUIRE(seen.manifold.count == 1);
  CHECK(distance(seen.manifold.normal, {0, 1, 0}) < 1e-9);
  CHECK(distance(seen.manifold.points[0].on_b, {0.1, reach, 0}) < 1e-9);
  CHECK(distance(seen.manifold.points[0].on_a, {0.1, reach - 0.002, 0}) < 1e-9);
}

TEST_CASE("pairs: a tilted box's lowest corner is the one point, exactly", "[physics][pairs]") {
  const Vec3 half{0.5, 0.25, 0.3};
  const Quat turn = axis_angle({0.3, 0.2, 1}, 0.8);
  double lowest = 0;
  for (const Vec3 corner : make_box_polyhedron(half).vertices) lowest = std::min(lowest, (turn * corner).y);

  const Look seen = on_table(make_box(half), {{0, -lowest - 0.003, 0}, turn});

  CHECK(seen.manifold.count == 1);
  CHECK(seen.least() == Approx(-0.003).margin(1e-12));
}

TEST_CASE("pairs: a cylinder stands on four points of its rim", "[physics][pairs]") {
  for (const double gap : {-0.002, 1e-5, 0.003}) {
    const Look seen = on_table(make_cylinder(0.3, 0.4), {{0.1, 0.4 + gap, 0.2}, axis_angle({0, 1, 0}, 1)});

    REQUIRE(seen.manifold.count == 4);
    CHECK(distance(seen.manifold.normal, {0, 1, 0}) < 1e-9);
    Vec3 middle;
    for (int i = 0; i < 4; ++i) {
      CHECK(seen.manifold.points[i].separation == Approx(gap).margin(1e-9));
      CHECK(distance(seen.manifold.points[i].on_b, {0.1, 0, 0.2}) == Approx(0.3));
      middle += seen.manifold.points[i].on_b / 4;
    }
    CHECK(distance(middle, {0.1, 0, 0.2}) < 1e-9);
  }
}

TEST_CASE("pairs: a tilted cylinder touches where its rim is lowest", "[physics][pairs]") {
  const double r = 0.3, h = 0.4;
  for (const double tilt : {1e-3, 0.01, 0.1, 0.6, 1.2}) {
    for (const double heading : {0.0, 0.37, 2.0}) {
      const double lowest = h * std::cos(tilt) + r * std::sin(tilt), gap = tilt < 0.05 ? 0.001 : -0.001;
      const Quat turn = axis_angle({0, 1, 0}, heading) * axis_angle({0, 0, 1}, tilt);
      const Look seen = on_table(make_cylinder(r, h), {{0, lowest + gap, 0}, turn}, 1);

      INFO("tilt " << tilt << ", heading " << heading);
      REQUIRE(seen.found);
      CHECK(seen.least() == Approx(gap).margin(1e-9));
      CHECK(distance(seen.manifold.normal, {0, 1, 0}) < 1e-9);
    }
  }
}

TEST_CASE("pairs: a lying cylinder and a lying capsule touch at two ends", "[physics][pairs]") {
  for (const Convex& shape : {make_cylinder(0.2, 0.5), make_capsule(0.2, 0.5)}) {
    const Look seen = on_table(shape, {{0.1, 0.199, 0}, axis_angle({0, 0, 1}, kPi / 2)});

    REQUIRE(seen.manifold.count == 2);
    CHECK(has_point(seen.manifold, {-0.4, -0.001, 0}));
    CHECK(has_point(seen.manifold, {0.6, -0.001, 0}));
  }
}

TEST_CASE("pairs: a cone stands on its base and lies on its flank", "[physics][pairs]") {
  const double r = 0.3, height = 0.8, slope = std::atan2(r, height);
  const Look upright = on_table(make_cone(r, height / 2), {{0, height / 2 - 0.001, 0}, {}});
  CHECK(upright.manifold.count == 4);
  CHECK(upright.least() == Approx(-0.001).margin(1e-9));

  // Lying, its axis is off the ground's by its half angle; the middle of its axis then is this high.
  const double middle = height / 2 * std::sin(slope);
  const Look lying = on_table(make_cone(r, height / 2), {{0, middle, 0}, axis_angle({0, 0, 1}, kPi / 2 + slope)});
  CHECK(lying.manifold.count == 2);
  CHECK(lying.least() == Approx(0).margin(1e-9));
}

TEST_CASE("pairs: cylinders stand on one another, and lie beside one another", "[physics][pairs]") {
  const Convex one = make_cylinder(0.3, 0.4);
  const Look stacked = look(one, {{0.1, 0.8, 0}, axis_angle({0, 1, 0}, 0.2)}, one, {});
  REQUIRE(stacked.manifold.count == 4);
  CHECK(distance(stacked.manifold.normal, {0, 1, 0}) < 1e-9);
  CHECK(stacked.least() == Approx(0).margin(1e-7));

  const Look beside = look(one, {{0.599, 0.2, 0}, {}}, one, {});
  REQUIRE(beside.manifold.count == 2);
  CHECK(distance(beside.manifold.normal, {1, 0, 0}) < 1e-6);
  CHECK(beside.least() == Approx(-0.001).margin(1e-6));
}

TEST_CASE("pairs: capsules along each other touch twice, across each other once", "[physics][pairs]") {
  const Convex capsule = make_capsule(0.2, 0.5);
  CHECK(look(capsule, {{0.39, 0.3, 0}, {}}, capsule, {}).manifold.count == 2);
  const Look across = look(capsule, {{0.39, 0.3, 0}, axis_angle({1, 0, 0}, kPi / 2)}, capsule, {});
  REQUIRE(across.manifold.count == 1);
  CHECK(across.least() == Approx(-0.01).margin(1e-12));
}

TEST_CASE("pairs: a sphere meets faces, edges and corners of a box, and leaves it by the nearest face", "[physics][pairs]") {
  const Convex ball = make_sphere(0.25), cube = make_box({0.5, 0.5, 0.5});
  const auto at = [&](Vec3 place) { return look(ball, {place, {}}, cube, {}, 0.2); };

  CHECK(at({0.74, 0.1, 0.2}).least() == Approx(-0.01).margin(1e-12));
  const Vec3 edge = normalized(Vec3{1, 2, 0});
  CHECK(distance(at(Vec3{0.5, 0.5, 0.1} + edge * 0.3).manifold.normal, edge) < 1e-12);
  CHECK(at(Vec3{0.5, 0.5, 0.1} + edge * 0.3).least() == Approx(0.05));
  const Vec3 corner = normalized(Vec3{1, 2, -1});
  CHECK(distance(at(Vec3{0.5, 0.5, -0.5} + corner * 0.26).manifold.normal, corner) < 1e-12);
  const Look inside = at({0.1, 0.4, 0});
  CHECK(distance(inside.manifold.normal, {0, 1, 0}) < 1e-12);
  CHECK(inside.least() == Approx(-0.35));
}

TEST_CASE("pairs: what passes beside a corner is told the true direction", "[physics][pairs]") {
  // A gap to the right of the table's rim and above it: separating axes alone would say "right" or "up".
  const double right = 0.012, up = 0.016;
  const Vec3 away = normalized(Vec3{right, up, 0});
  const Look box = on_table(make_box({0.5, 0.5, 0.5}), {{2.5 + right, 0.5 + up, 0}, {}});
  REQUIRE(box.found);
  CHECK(distance(box.manifold.normal, away) < 1e-6);
  CHECK(box.least() == Approx(0.02).margin(1e-9));
  CHECK(box.manifold.count == 2);  // along both edges

  const Look turned = on_table(make_box({0.5, 0.5, 0.5}), {{2 + std::sqrt(0.5) + right, 0.5 + up, 0}, axis_angle({0, 1, 0}, kPi / 4)});
  REQUIRE(turned.found);
  CHECK(distance(turned.manifold.normal, away) < 1e-6);
  CHECK(turned.manifold.count == 1);

  const Look ball = on_table(make_sphere(0.5), {Vec3{2, 0, 0} + away * 0.52, {}});
  CHECK(distance(ball.manifold.normal, away) < 1e-9);
  CHECK_FALSE(on_table(make_box({0.5, 0.5, 0.5}), {{2.54, 0.54, 0}, {}}).found);
}

TEST_CASE("pairs: a box stands on the triangles below it and is not held by the rim of the next one", "[physics][pairs]") {
  const Convex box = make_box({0.3, 0.2, 0.3}), floor = make_triangle({-2, 0, -2}, {0, 0, 2}, {2, 0, -2});
  for (const double gap : {-0.001, 0.002}) {
    const Look seen = look(box, {{0, 0.2 + gap, -0.5}, {}}, floor, {});
    REQUIRE(seen.manifold.count == 4);
    CHECK(distance(seen.manifold.normal, {0, 1, 0}) < 1e-9);
    CHECK(seen.least() == Approx(gap).margin(1e-9));
  }

  // Just before the triangle's rim at z = -2, and with a hair over it.
  CHECK_FALSE(look(box, {{0, 0.2, -2.303}, {}}, floor, {}).found);
  CHECK_FALSE(look(make_sphere(0.2), {{0, 0.1, -2.19}, {}}, floor, {}).manifold.normal.z < -0.9);
  const Look over = look(box, {{0, 0.1995, -2.2998}, {}}, floor, {});
  CHECK(std::abs(over.manifold.normal.y) == Approx(1));
}

TEST_CASE("pairs: a sphere on a triangle is held by its face, its edge and its corner", "[physics][pairs]") {
  const Convex ball = make_sphere(0.3), triangle = make_triangle({0, 0, 0}, {0, 0, 1}, {1, 0, 0});
  CHECK(look(ball, {{0.2, 0.29, 0.2}, {}}, triangle, {}).least() == Approx(-0.01));
  CHECK(look(ball, {{0.2, -0.29, 0.2}, {}}, triangle, {}).manifold.normal.y == Approx(-1));
  CHECK(look(ball, {{-0.16, 0.24, 0.5}, {}}, triangle, {}).least() == Approx(std::hypot(0.16, 0.24) - 0.3));
  CHECK(look(ball, {{-0.1, 0.2, -0.1}, {}}, triangle, {}).least() == Approx(std::sqrt(0.06) - 0.3));
}
