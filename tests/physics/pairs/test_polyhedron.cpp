#include "pairs.h"

using namespace tumble;
using namespace tumble::pairs;

namespace {

Polyhedron hull_of(const std::vector<Vec3>& points) { return make_polyhedron(convex_hull(points)); }

std::vector<Vec3> prism(int sides, double radius, double half_height) {
  std::vector<Vec3> points;
  for (int i = 0; i < sides; ++i)
    for (const double y : {-half_height, half_height})
      points.push_back({radius * std::cos(2 * kPi * i / sides), y, radius * std::sin(2 * kPi * i / sides)});
  return points;
}

// Euler's formula, and every face flat with the solid behind it, going round counter-clockwise.
void check_whole(const Polyhedron& solid, double size) {
  const double near = 2e-4 * size;  // the grid on which hulls are found
  const auto vertex = [&](int i) { return solid.vertices[static_cast<std::size_t>(i)]; };
  const auto normal = [&](int i) { return solid.faces[static_cast<std::size_t>(i)].normal; };
  CHECK(solid.vertices.size() + solid.faces.size() == solid.edges.size() + 2);
  for (const Polyhedron::Face& face : solid.faces) {
    CHECK(length(face.normal) == Approx(1));
    for (const Vec3 p : solid.vertices) CHECK(dot(face.normal, p) < face.offset + near);
    for (int i = 0; i < face.count; ++i) {
      const auto at = [&](int k) { return vertex(solid.loops[static_cast<std::size_t>(face.first + k % face.count)]); };
      CHECK(std::abs(dot(face.normal, at(i)) - face.offset) < near);
      CHECK(dot(cross(at(i + 1) - at(i), at(i + 2) - at(i + 1)), face.normal) > 0);
    }
  }
  for (const Polyhedron::Edge& edge : solid.edges) {
    CHECK(dot(cross(normal(edge.left), normal(edge.right)), vertex(edge.to) - vertex(edge.from)) > 0);
  }
}

}  // namespace

TEST_CASE("pairs: a box's hull has six faces of four corners and twelve edges", "[physics][pairs]") {
  std::vector<Vec3> corners;
  for (int i = 0; i < 8; ++i) corners.push_back({i & 1 ? 1.0 : -1.0, i & 2 ? 2.0 : -2.0, i & 4 ? 3.0 : -3.0});

  for (const Polyhedron& solid : {make_box_polyhedron({1, 2, 3}), hull_of(corners)}) {
    CHECK(solid.vertices.size() == 8);
    CHECK(solid.faces.size() == 6);
    CHECK(solid.edges.size() == 12);
    for (const Polyhedron::Face& face : solid.faces) CHECK(face.count == 4);
    check_whole(solid, 1);
  }
}

TEST_CASE("pairs: a prism's caps are one polygon each", "[physics][pairs]") {
  for (const int sides : {3, 5, 12, 40}) {
    const Polyhedron solid = hull_of(prism(sides, 0.7, 0.4));

    CHECK(static_cast<int>(solid.faces.size()) == sides + 2);
    CHECK(static_cast<int>(solid.edges.size()) == 3 * sides);
    check_whole(solid, 1);
  }
}

TEST_CASE("pairs: random hulls are whole, at every size and also where points lie within faces", "[physics][pairs]") {
  Random random(4);
  for (int round = 0; round < 60; ++round) {
    const double size = std::pow(10.0, random.between(-2, 1));
    std::vector<Vec3> points;
    for (int i = 0; i < 24; ++i) points.push_back(random.direction() * size);
    check_whole(hull_of(points), size);
  }
  std::vector<Vec3> grid;
  for (int i = 0; i < 27; ++i) grid.push_back({i % 3 - 1.0, i / 3 % 3 - 1.0, i / 9 - 1.0});
  CHECK(hull_of(grid).vertices.size() == 8);
  check_whole(hull_of(grid), 1);

  for (int round = 0; round < 60; ++round) {
    std::vector<Vec3> some;
    const auto whole = [&] { return std::round(random.between(-2, 2)) * 0.31; };
    for (int i = 0; i < 40; ++i) some.push_back({whole(), whole(), whole()});
    check_whole(hull_of(some), 1);
  }
}
