#include "physical.h"
#include "physics/solids.h"

using namespace tumble;

namespace {

BodyDef heavy(const Shape& shape, double mass) {
  BodyDef def = body(shape);
  def.mass = mass;
  return def;
}

// A tolerance of 1e-12 is a few hundred roundings; these are closed formulas.
void check(const MassProperties& got, Vec3 inertia, Vec3 center = {}) {
  CHECK(distance(got.inertia, inertia) < 1e-12 * length(inertia));
  CHECK(distance(got.center, center) < 1e-12);
}

}  // namespace

TEST_CASE("mass: solids have their textbook moments", "[physics]") {
  const double m = 3, r = 0.4, h = 1.7;

  check(mass_properties(heavy(box({1, 2, 3}), m)), {m * 13 / 12, m * 10 / 12, m * 5 / 12});
  check(mass_properties(heavy(ball(r), m)), Vec3{1, 1, 1} * (0.4 * m * r * r));
  const double across = m * (3 * r * r + h * h) / 12;
  check(mass_properties(heavy(upright(ShapeKind::cylinder, r, h), m)), {across, m * r * r / 2, across});
  const double cone = m * 3.0 / 80 * (4 * r * r + h * h);
  check(mass_properties(heavy(upright(ShapeKind::cone, r, h), m)), {cone, 0.3 * m * r * r, cone}, {0, -h / 4, 0});
}

TEST_CASE("mass: a torus, by its formula", "[physics]") {
  const double m = 2, big = 1, tube = 0.25;
  const double across = m * (big * big / 2 + 5.0 / 8 * tube * tube);

  check(mass_properties(heavy(ring(big, 2 * tube), m)), {across, m * (big * big + 0.75 * tube * tube), across});
}

TEST_CASE("mass: a capsule is a cylinder and two half balls", "[physics]") {
  // Independent way: integrate discs of thickness dy; 1e-6 is the midpoint rule's error with 20000 discs.
  const double r = 0.3, height = 1.4, density = 500;
  const int discs = 20000;
  double mass = 0, along = 0, across = 0;
  for (int i = 0; i < discs; ++i) {
    const double dy = height / discs, y = -height / 2 + (i + 0.5) * dy;
    const double over = std::max(0.0, std::abs(y) - (height / 2 - r)), disc2 = r * r - over * over;
    const double dm = density * kPi * disc2 * dy;
    mass += dm;
    along += dm * disc2 / 2;
    across += dm * (disc2 / 4 + y * y);
  }
  BodyDef def = body(upright(ShapeKind::capsule, r, height));
  def.density = density;

  const MassProperties got = mass_properties(def);

  CHECK(got.mass == Approx(mass).epsilon(1e-6));
  CHECK(got.inertia.y == Approx(along).epsilon(1e-6));
  CHECK(got.inertia.x == Approx(across).epsilon(1e-6));
}

TEST_CASE("mass: a hull of a box's corners is that box, wherever it lies", "[physics]") {
  Shape hull;
  hull.shape = ShapeKind::hull;
  const Vec3 size{1, 2, 3}, shift{5, -2, 1};
  for (const double x : {-0.5, 0.5})
    for (const double y : {-0.5, 0.5})
      for (const double z : {-0.5, 0.5}) hull.points.push_back(scaled({x, y, z}, size) + shift);
  BodyDef def = body(hull);
  def.density = 2;

  const MassProperties got = mass_properties(def);

  CHECK(got.mass == Approx(12).epsilon(1e-12));
  CHECK(distance(got.center, shift) < 1e-12);
  CHECK(distance(got.inertia, {12.0 * 13 / 12, 12.0 * 10 / 12, 12.0 * 5 / 12}) < 1e-9);
}

TEST_CASE("mass: a pyramid by its formula is the hull of its corners", "[physics]") {
  Shape pyramid;
  pyramid.shape = ShapeKind::pyramid;
  pyramid.size = {1, 2, 3};
  Shape hull;
  hull.shape = ShapeKind::hull;
  hull.points = pyramid_points(pyramid);

  const MassProperties a = mass_properties(heavy(pyramid, 4)), b = mass_properties(heavy(hull, 4));

  CHECK(distance(a.center, b.center) < 1e-12);
  CHECK(distance(a.inertia, b.inertia) < 1e-12);
}

TEST_CASE("mass: two balls on a rod-less dumbbell follow Steiner, also turned", "[physics]") {
  BodyDef def;
  def.mass = 2;
  const Quat turn = axis_angle({1, 2, 3}, 0.7);
  const Vec3 arm = turn * Vec3{1, 0, 0};
  def.colliders = {collider(ball(0.1), arm), collider(ball(0.1), -arm)};

  const MassProperties got = mass_properties(def);

  // Smallest moment along the arm, and the axes turn with it.
  const double own = 2 * 0.4 * 0.01, far = own + 2;
  CHECK(got.inertia.x == Approx(own).epsilon(1e-9));
  CHECK(got.inertia.y == Approx(far).epsilon(1e-9));
  CHECK(got.inertia.z == Approx(far).epsilon(1e-9));
  CHECK(std::abs(dot(got.axes * Vec3{1, 0, 0}, arm)) == Approx(1).epsilon(1e-12));
}

TEST_CASE("mass: densities share out a given mass, and triggers have none", "[physics]") {
  BodyDef def;
  def.mass = 4;
  def.colliders = {collider(box({1, 1, 1}), {-1, 0, 0}), collider(box({1, 1, 1}), {1, 0, 0}), collider(ball(5))};
  def.colliders[1].density = 3;
  def.colliders[2].trigger = true;

  const MassProperties got = mass_properties(def);

  CHECK(got.mass == 4);
  CHECK(got.center.x == Approx(0.5));  // 1 kg at -1, 3 kg at 1
}

TEST_CASE("mass: one kilogram where nothing is said, none of a static body", "[physics]") {
  CHECK(mass_properties(body(ball(3))).mass == 1);
  CHECK(mass_properties(body(ball(3), BodyType::fixed)).mass == 0);
}

TEST_CASE("mass: moments that are given stand in for those of the colliders, about the body's own axes", "[physics]") {
  BodyDef def = body(box({1, 2, 3}));
  def.mass = 6;
  def.colliders[0].rotation = axis_angle({0, 0, 1}, 0.4);
  def.center_of_mass = Vec3{0.1, 0, 0};
  def.inertia = Vec3{3, 4, 5};
  const MassProperties got = mass_properties(def);
  CHECK(got.mass == 6);
  CHECK(got.inertia == Vec3{3, 4, 5});
  CHECK(got.axes == Quat{});
  CHECK(got.center == Vec3{0.1, 0, 0});
}
