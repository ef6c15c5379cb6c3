#include "assets/mesh_detail.h"

#include <catch2/catch.hpp>
#include <map>

using namespace tumble;

namespace {

Shape shape_of(ShapeKind kind) {
  Shape shape;
  shape.shape = kind;
  shape.size = {1.2, 0.8, 2.0};
  shape.radius = 0.7;
  shape.height = 2.2;
  shape.thickness = 0.3;
  shape.points = {{-1, -1, -1}, {1, -1, -1}, {1, -1, 1}, {-1, -1, 1}, {0.2, 1.5, 0.1}, {0, 0, 0}, {0.1, -0.2, 0}};
  return shape;
}

Vec3 position(const Mesh& mesh, std::size_t corner) {
  const auto& p = mesh.vertices[mesh.triangles[corner]].position;
  return {p[0], p[1], p[2]};
}
Vec3 normal(const Mesh& mesh, std::size_t corner) {
  const auto& n = mesh.vertices[mesh.triangles[corner]].normal;
  return {n[0], n[1], n[2]};
}

// By the divergence theorem: the sum of the tetrahedra from the origin to each triangle.
double volume(const Mesh& mesh) {
  double sum = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3)
    sum += dot(position(mesh, i), cross(position(mesh, i + 1), position(mesh, i + 2))) / 6;
  return sum;
}

// How often each directed edge occurs; places that coincide to a micrometre are one.
std::map<std::pair<std::array<long, 3>, std::array<long, 3>>, int> edges(const Mesh& mesh) {
  const auto place = [&](std::size_t corner) {
    const Vec3 p = position(mesh, corner) * 1e6;
    return std::array<long, 3>{std::lround(p.x), std::lround(p.y), std::lround(p.z)};
  };
  std::map<std::pair<std::array<long, 3>, std::array<long, 3>>, int> count;
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3)
    for (std::size_t k = 0; k < 3; ++k) ++count[{place(i + k), place(i + (k + 1) % 3)}];
  return count;
}

const std::vector<ShapeKind> kSolids = {ShapeKind::box,  ShapeKind::sphere,  ShapeKind::capsule, ShapeKind::cylinder,
                                        ShapeKind::cone, ShapeKind::pyramid, ShapeKind::torus,   ShapeKind::hull};

std::string name_of(ShapeKind kind) { return enum_names(kind)[static_cast<std::size_t>(kind)]; }

}  // namespace

TEST_CASE("mesh: every solid is watertight", "[assets]") {
  for (const ShapeKind kind : kSolids) {
    INFO(name_of(kind));
    int open = 0, crowded = 0;

    const auto count = edges(make_mesh(shape_of(kind)));
    for (const auto& [edge, times] : count) {
      open += !count.contains({edge.second, edge.first});
      crowded += times != 1;
    }

    CHECK(open == 0);
    CHECK(crowded == 0);
  }
}

TEST_CASE("mesh: triangles are counter-clockwise and normals are units that point outward", "[assets]") {
  for (const ShapeKind kind : kSolids) {
    INFO(name_of(kind));
    const Mesh mesh = make_mesh(shape_of(kind));
    double least_agreement = 1, worst_length = 0;

    for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
      const Vec3 a = position(mesh, i);
      const Vec3 face = normalized(cross(position(mesh, i + 1) - a, position(mesh, i + 2) - a));
      for (std::size_t k = 0; k < 3; ++k) {
        least_agreement = std::min(least_agreement, dot(face, normal(mesh, i + k)));
        worst_length = std::max(worst_length, std::abs(length(normal(mesh, i + k)) - 1));
      }
    }

    CHECK(least_agreement > 0.9);  // smooth normals lean off a facet's own by up to half its angle
    CHECK(worst_length < 1e-6);
  }
}

TEST_CASE("mesh: volumes are those of the shapes, less what facets cut off", "[assets]") {
  const Shape s = shape_of(ShapeKind::box);
  const double r = s.radius, h = s.height, tube = s.thickness / 2;
  const double round = 32 * std::sin(2 * kPi / 32) / (2 * kPi);  // area of a 32-sided polygon over the circle's
  const auto volume_of = [](ShapeKind kind) { return volume(make_mesh(shape_of(kind))); };

  CHECK(volume_of(ShapeKind::box) == Approx(1.2 * 0.8 * 2.0).epsilon(1e-5));
  CHECK(volume_of(ShapeKind::pyramid) == Approx(1.2 * 0.8 * 2.0 / 3).epsilon(1e-5));
  CHECK(volume_of(ShapeKind::cylinder) == Approx(round * kPi * r * r * h).epsilon(1e-5));
  CHECK(volume_of(ShapeKind::cone) == Approx(round * kPi * r * r * h / 3).epsilon(1e-5));
  CHECK(volume_of(ShapeKind::hull) == Approx(2 * 2 * 2.5 / 3).epsilon(1e-5));
  CHECK(volume_of(ShapeKind::plane) == Approx(0).margin(1e-9));
  // Facets curved both ways lose at most 2 % here, and never gain.
  const double ball = 4 * kPi * r * r * r / 3;
  CHECK(volume_of(ShapeKind::sphere) / ball == Approx(0.99).margin(0.01));
  CHECK(volume_of(ShapeKind::capsule) / (ball + kPi * r * r * (h - 2 * r)) == Approx(0.99).margin(0.01));
  CHECK(volume_of(ShapeKind::torus) / (2 * kPi * r * kPi * tube * tube) == Approx(0.98).margin(0.02));
}

TEST_CASE("mesh: a coarser mesh is closed, lies within the shape, and not deeper than was allowed", "[assets]") {
  for (const ShapeKind kind : {ShapeKind::sphere, ShapeKind::capsule, ShapeKind::cylinder, ShapeKind::cone, ShapeKind::torus}) {
    INFO(name_of(kind));
    const Shape shape = shape_of(kind);
    for (const double allowed : {0.0, 0.01, 0.02, 0.05, 0.1, 1.0}) {
      const int coarseness = coarseness_within(shape, allowed);
      const Mesh mesh = make_mesh(shape, coarseness);
      int open = 0;
      const auto count = edges(mesh);
      for (const auto& [edge, times] : count) open += !count.contains({edge.second, edge.first});
      CHECK(open == 0);
      if (kind != ShapeKind::sphere || coarseness == 0) continue;
      double shallowest = 1;
      for (std::size_t i = 0; i < mesh.triangles.size(); i += 3)
        shallowest = std::min(shallowest, length(position(mesh, i) + position(mesh, i + 1) + position(mesh, i + 2)) / 3);
      CHECK(shape.radius - shallowest <= allowed);
    }
    CHECK(coarseness_within(shape, 0) == 0);
    CHECK(coarseness_within(shape, 1) == kCoarsest);
  }
  CHECK(coarseness_within(shape_of(ShapeKind::box), 1) == 0);
}

TEST_CASE("mesh: every mesh fills the box around its shape", "[assets]") {
  for (const ShapeKind kind : kSolids) {
    if (kind == ShapeKind::hull) continue;  // its points need not be centred
    INFO(name_of(kind));
    const Shape shape = shape_of(kind);
    Vec3 reach;

    const Mesh mesh = make_mesh(shape);
    for (const Vertex& v : mesh.vertices)
      reach = {std::max<double>(reach.x, std::abs(v.position[0])), std::max<double>(reach.y, std::abs(v.position[1])),
               std::max<double>(reach.z, std::abs(v.position[2]))};

    CHECK(distance(reach, half_extents(shape)) < 1e-6);
  }
}

TEST_CASE("mesh: a hull of points in one plane, or of fewer than four, is empty", "[assets]") {
  CHECK(make_hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}).triangles.empty());
  CHECK(make_hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 3, 0}}).triangles.empty());
  CHECK(make_hull({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}).triangles.empty());
}

TEST_CASE("mesh: a hull holds all of many points", "[assets]") {
  std::vector<Vec3> points;
  for (int i = 0; i < 300; ++i) points.push_back({std::sin(i * 1.9), std::sin(i * 2.7 + 1), std::sin(i * 4.1 + 2)});

  const Mesh hull = make_hull(points);

  double farthest_out = 0;
  for (std::size_t i = 0; i < hull.triangles.size(); i += 3)
    for (const Vec3 point : points)
      farthest_out = std::max(farthest_out, dot(point - position(hull, i), normal(hull, i)));
  CHECK(farthest_out < 1e-6);
  CHECK(volume(hull) > 4);  // of the cube of volume 8 that the points lie in
}

TEST_CASE("mesh: what a file is to give is a stand-in box until it does", "[assets]") {
  Shape shape;
  shape.shape = ShapeKind::mesh;
  shape.file = "duck.glb";

  CHECK(is_stand_in(shape));
  CHECK_FALSE(is_stand_in(shape_of(ShapeKind::hull)));
  CHECK(volume(make_mesh(shape)) == Approx(1));
}

TEST_CASE("mesh: a picture lies on every face, within 0 and 1", "[assets]") {
  for (const ShapeKind kind : kSolids) {
    INFO(name_of(kind));
    float low = 1, high = 0;
    for (const Vertex& vertex : make_mesh(shape_of(kind)).vertices)
      for (const float part : vertex.uv) {
        low = std::min(low, part);
        high = std::max(high, part);
      }
    CHECK(std::abs(low) < 1e-6f);
    CHECK(std::abs(high - 1) < 1e-6f);
  }
}

TEST_CASE("mesh: on a box's upright faces and its top a picture stands upright and unmirrored", "[assets]") {
  const Mesh mesh = make_mesh(shape_of(ShapeKind::box));
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
    const Vertex &a = mesh.vertices[mesh.triangles[i]], &b = mesh.vertices[mesh.triangles[i + 1]], &c = mesh.vertices[mesh.triangles[i + 2]];
    // Seen from outside triangles are counter-clockwise; with v down the picture's turn the other way.
    const float turn = (b.uv[0] - a.uv[0]) * (c.uv[1] - a.uv[1]) - (b.uv[1] - a.uv[1]) * (c.uv[0] - a.uv[0]);
    CHECK(turn < 0);
    if (a.normal[1] == 0)
      for (const Vertex* vertex : {&a, &b, &c}) CHECK((vertex->uv[1] == 0) == (vertex->position[1] > 0));
  }
}

TEST_CASE("mesh: keys tell shapes apart", "[assets]") {
  Shape a = shape_of(ShapeKind::sphere), b = a, c = shape_of(ShapeKind::capsule);
  b.radius = 0.71;

  CHECK(mesh_key(a) == mesh_key(shape_of(ShapeKind::sphere)));
  CHECK(mesh_key(a) != mesh_key(b));
  CHECK(mesh_key(a) != mesh_key(c));
}
