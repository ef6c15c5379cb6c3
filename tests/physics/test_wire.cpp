#include "physics/wire.h"

#include <catch2/catch.hpp>

#include <algorithm>

#include "physics/solids.h"

using namespace tumble;

namespace {

Shape shape(ShapeKind kind) {
  Shape result;
  result.shape = kind;
  return result;
}

// How far a point lies from the shape's surface.
double off(const Shape& s, Vec3 p) {
  const double out = std::hypot(p.x, p.z), r = s.radius, h = s.height / 2;
  const double nearest = std::min(std::abs(out - r), std::abs(std::abs(p.y) - h));
  switch (s.shape) {
    case ShapeKind::sphere: return std::abs(length(p) - r);
    case ShapeKind::capsule: return std::abs(std::hypot(out, std::max(0.0, std::abs(p.y) - (h - r))) - r);
    case ShapeKind::cylinder: return nearest;
    case ShapeKind::cone: return std::abs(out - r * (h - p.y) / (2 * h));
    case ShapeKind::torus: return std::abs(std::hypot(out - r, p.y) - s.thickness / 2);
    default: return 1e9;
  }
}

Vec3 reach(const Wire& wire) {
  Vec3 most;
  for (const WireLine& line : wire)
    for (const Vec3 p : {line.from, line.to})
      most = {std::max(most.x, std::abs(p.x)), std::max(most.y, std::abs(p.y)), std::max(most.z, std::abs(p.z))};
  return most;
}

}  // namespace

TEST_CASE("wire: the ends of all lines of a round shape lie on its surface", "[physics][wire]") {
  for (const ShapeKind kind : {ShapeKind::sphere, ShapeKind::capsule, ShapeKind::cylinder, ShapeKind::cone, ShapeKind::torus}) {
    Shape round = shape(kind);
    round.radius = 0.4;
    round.height = 1.7;
    round.thickness = 0.3;
    INFO(enum_names(kind)[static_cast<std::size_t>(kind)]);
    for (const WireLine& line : wire_of(round)) {
      CHECK(off(round, line.from) < 1e-12);
      CHECK(off(round, line.to) < 1e-12);
    }
    CHECK(distance(reach(wire_of(round)), half_extents(round)) < 1e-12);
  }
}

TEST_CASE("wire: what has corners is drawn by its edges", "[physics][wire]") {
  Shape box = shape(ShapeKind::box);
  box.size = {1, 2, 3};
  CHECK(wire_of(box).size() == 12);
  CHECK(reach(wire_of(box)) == Vec3{0.5, 1, 1.5});
  CHECK(wire_of(shape(ShapeKind::plane)).size() == 4);
  CHECK(wire_of(shape(ShapeKind::pyramid)).size() == 8);

  double length_of_edges = 0;
  for (const WireLine& line : wire_of(box)) length_of_edges += distance(line.from, line.to);
  CHECK(length_of_edges == Approx(4 * (1 + 2 + 3)));
}

TEST_CASE("wire: a hull's and a mesh's edges come once, and none crosses a flat face", "[physics][wire]") {
  Shape hull = shape(ShapeKind::hull);
  for (const double x : {-1.0, 1.0})
    for (const double y : {-2.0, 2.0})
      for (const double z : {-3.0, 3.0}) hull.points.push_back({x, y, z});
  CHECK(wire_of(hull).size() == 12);  // a box's, without the diagonals of its 12 triangles

  Shape mesh = shape(ShapeKind::mesh);
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 0}, {1, 0, 1}, {0, 0, 1}};
  CHECK(wire_of(mesh).size() == 4);
  mesh.points.back().y = 0.5;
  CHECK(wire_of(mesh).size() == 5);  // now folded
  CHECK(wire_of(shape(ShapeKind::mesh)).empty());
}
