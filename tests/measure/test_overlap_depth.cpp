// The suite measures how deep bodies lie in each other by its own search; the engine has another. Both are to agree.
#include "accuracy/geometry.h"
#include "physics/pairs/pairs.h"

using namespace tumble;

namespace {

struct OfShape {
  Shape shape;
  pairs::Polyhedron solid;
  pairs::Convex convex;
};

OfShape box_kind(Vec3 size) {
  OfShape kind;
  kind.shape.size = size;
  kind.convex = pairs::make_box(size / 2);
  return kind;
}

OfShape round_kind(ShapeKind shape, double radius, double height) {
  OfShape kind;
  kind.shape.shape = shape;
  kind.shape.radius = radius;
  kind.shape.height = height;
  kind.convex = shape == ShapeKind::cone ? pairs::make_cone(radius, height / 2) : pairs::make_cylinder(radius, height / 2);
  return kind;
}

// A cube whose corners are cut off.
OfShape hull_kind() {
  OfShape kind;
  kind.shape.shape = ShapeKind::hull;
  for (const double a : {-1.0, 1.0})
    for (const double b : {-1.0, 1.0})
      for (const double c : {-1.0, 1.0})
        for (const Vec3 corner : {Vec3{a * 0.2, b * 0.4, c * 0.4}, Vec3{a * 0.4, b * 0.2, c * 0.4}, Vec3{a * 0.4, b * 0.4, c * 0.2}})
          kind.shape.points.push_back(corner);
  kind.solid = pairs::make_polyhedron(convex_hull(kind.shape.points));
  return kind;
}

}  // namespace

TEST_CASE("overlap depth: the suite's search and the engine's find the same", "[measure]") {
  OfShape kinds[] = {box_kind({0.9, 0.7, 0.8}), round_kind(ShapeKind::cylinder, 0.4, 0.8), round_kind(ShapeKind::cone, 0.5, 1), hull_kind()};
  kinds[3].convex = pairs::make_solid(kinds[3].solid);
  pairs::Random random(9);
  int overlapping = 0;
  for (const OfShape& a : kinds)
    for (const OfShape& b : kinds)
      for (int i = 0; i < 40; ++i) {
        const Pose at_a{{}, random.rotation()}, at_b{random.direction() * random.between(0.5, 1.1), random.rotation()};
        pairs::Nearest near;
        const bool found = pairs::closest(a.convex, at_a, b.convex, at_b, 0, near);
        const double depth = accuracy::overlap_depth({a.shape, at_a}, {b.shape, at_b});
        INFO(static_cast<int>(a.shape.shape) << " and " << static_cast<int>(b.shape.shape) << ", try " << i);
        CHECK(depth == Approx(found ? -near.separation : 0).margin(1e-4));
        overlapping += found;
      }
  CHECK(overlapping > 300);
}

TEST_CASE("overlap depth: a cylinder that lies in a box, by its formula", "[measure]") {
  const OfShape box = box_kind({2, 1, 2}), cylinder = round_kind(ShapeKind::cylinder, 0.4, 1);
  const Quat lying = axis_angle({0, 0, 1}, kPi / 2) * axis_angle({1, 0, 0}, 0.3);
  for (const double depth : {0.0, 1e-5, 1e-3, 0.1})
    CHECK(accuracy::overlap_depth({box.shape, {}}, {cylinder.shape, {{0.1, 0.9 - depth, 0}, lying}}) == Approx(depth).margin(1e-7));
}
