#include "assets/mesh.h"

#include <algorithm>
#include <cmath>

#include "assets/mesh_detail.h"
#include "base/hash.h"

namespace tumble {
namespace {

constexpr int kSides = 32;       // around the axis
constexpr int kRings = 16;       // from pole to pole
constexpr int kTorusSides = 48;  // around the axis
constexpr int kTubeSides = 16;

// How many corners go round, and along half a circle, when each step of coarseness halves them.
struct Detail {
  int sides = kSides, rings = kRings, torus_sides = kTorusSides, tube_sides = kTubeSides;

  explicit Detail(int coarseness)
      : sides(kSides >> coarseness), rings(kRings >> coarseness), torus_sides(kTorusSides >> coarseness), tube_sides(kTubeSides >> coarseness) {}
};

// How far a chord lies within its circle.
double sagitta(double radius, int sides) { return radius * (1 - std::cos(kPi / sides)); }

// u to the right and v down, 0..1.
std::uint32_t add_vertex(Mesh& mesh, Vec3 position, Vec3 normal, double u, double v) {
  const auto f = [](double value) { return static_cast<float>(value); };
  mesh.vertices.push_back(
      {{f(position.x), f(position.y), f(position.z)}, {f(normal.x), f(normal.y), f(normal.z)}, {f(u), f(v)}});
  return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
}

void add_triangle(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  mesh.triangles.insert(mesh.triangles.end(), {a, b, c});
}

// A triangle or a quadrangle, counter-clockwise seen from outside and from its lower left corner on.
void add_face(Mesh& mesh, const std::vector<Vec3>& corners) {
  const Vec3 normal = normalized(cross(corners[1] - corners[0], corners[2] - corners[0]));
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  const bool pointed = corners.size() == 3;
  const double u[] = {0, 1, pointed ? 0.5 : 1, 0}, v[] = {1, 1, 0, 0};
  for (std::size_t i = 0; i < corners.size(); ++i) add_vertex(mesh, corners[i], normal, u[i], v[i]);
  for (std::uint32_t i = 2; i < corners.size(); ++i) add_triangle(mesh, first, first + i - 1, first + i);
}

// The direction across the axis at step i of n; exact at the seam, so that first and last vertices coincide.
Vec3 around(int i, int n) {
  const double angle = 2 * kPi * (i % n) / n;
  return {std::sin(angle), 0, std::cos(angle)};
}

// A point of an outline to be turned about y: `across` from the axis, at height `y`, with the outline's normal there.
struct Outline {
  double across, y;
  double normal_across, normal_y;
};

// How far along the outline each point lies, 0..1.
std::vector<double> shares(const std::vector<Outline>& outline) {
  std::vector<double> result{0};
  for (std::size_t i = 1; i < outline.size(); ++i)
    result.push_back(result.back() + std::hypot(outline[i].across - outline[i - 1].across, outline[i].y - outline[i - 1].y));
  const double whole = std::max(result.back(), 1e-12);
  for (double& share : result) share /= whole;
  return result;
}

// Turns an outline that runs upwards about the y axis. Points on the axis give no degenerate triangles. A picture goes
// round it once.
void add_turned(Mesh& mesh, const std::vector<Outline>& outline, int sides) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  const std::vector<double> up = shares(outline);
  for (int i = 0; i <= sides; ++i)
    for (std::size_t k = 0; k < outline.size(); ++k) {
      const Outline& p = outline[k];
      const Vec3 out = around(i, sides);
      add_vertex(mesh, out * p.across + Vec3{0, p.y, 0}, out * p.normal_across + Vec3{0, p.normal_y, 0},
                 double(i) / sides, 1 - up[k]);
    }
  const auto n = static_cast<std::uint32_t>(outline.size());
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(sides); ++i)
    for (std::uint32_t k = 0; k + 1 < n; ++k) {
      const std::uint32_t low = first + i * n + k, next = low + n;
      if (outline[k].across > 0) add_triangle(mesh, low, next, low + 1);
      if (outline[k + 1].across > 0) add_triangle(mesh, low + 1, next, next + 1);
    }
}

// A quarter or half circle's share of an outline: `rings` steps from angle `from` to `to` above the horizontal.
void add_arc(std::vector<Outline>& outline, double across, double y, double radius, double from, double to, int rings) {
  for (int i = 0; i <= rings; ++i) {
    const double angle = from + (to - from) * i / rings;
    const bool pole = std::abs(std::abs(angle) - kPi / 2) < 1e-9 && across == 0;
    const double cosine = pole ? 0 : std::cos(angle), sine = std::sin(angle);
    outline.push_back({across + radius * cosine, y + radius * sine, cosine, sine});
  }
}

Mesh make_box(Vec3 size) {
  const Vec3 h = size / 2;
  const Vec3 c[8] = {{-h.x, -h.y, -h.z}, {h.x, -h.y, -h.z}, {h.x, -h.y, h.z}, {-h.x, -h.y, h.z},
                     {-h.x, h.y, -h.z},  {h.x, h.y, -h.z},  {h.x, h.y, h.z},  {-h.x, h.y, h.z}};
  constexpr int faces[6][4] = {{0, 1, 2, 3}, {7, 6, 5, 4}, {3, 2, 6, 7}, {1, 0, 4, 5}, {2, 1, 5, 6}, {0, 3, 7, 4}};
  Mesh mesh;
  for (const auto& f : faces) add_face(mesh, {c[f[0]], c[f[1]], c[f[2]], c[f[3]]});
  return mesh;
}

Mesh make_pyramid(Vec3 size) {
  const Vec3 h = size / 2;
  const Vec3 a{-h.x, -h.y, -h.z}, b{h.x, -h.y, -h.z}, c{h.x, -h.y, h.z}, d{-h.x, -h.y, h.z}, top{0, h.y, 0};
  Mesh mesh;
  add_face(mesh, {a, b, c, d});
  for (const auto& [from, to] : {std::pair{d, c}, {c, b}, {b, a}, {a, d}}) add_face(mesh, {from, to, top});
  return mesh;
}

Mesh make_plane(Vec3 size) {
  const double x = size.x / 2, z = size.z / 2;
  Mesh mesh;
  add_face(mesh, {{-x, 0, z}, {x, 0, z}, {x, 0, -z}, {-x, 0, -z}});
  add_face(mesh, {{-x, 0, -z}, {x, 0, -z}, {x, 0, z}, {-x, 0, z}});
  return mesh;
}

// A sphere cut at its equator and pulled apart; with height 2 radius, a sphere.
Mesh make_capsule(double radius, double height, const Detail& detail) {
  const double half = std::max(0.0, height / 2 - radius);
  std::vector<Outline> outline;
  add_arc(outline, 0, -half, radius, -kPi / 2, 0, detail.rings / 2);
  if (half == 0) outline.pop_back();
  add_arc(outline, 0, half, radius, 0, kPi / 2, detail.rings / 2);
  Mesh mesh;
  add_turned(mesh, outline, detail.sides);
  return mesh;
}

// A disc across the axis, facing up or down.
void add_cap(Mesh& mesh, double radius, double y, bool up, int sides) {
  const std::size_t first = mesh.vertices.size();
  if (up) add_turned(mesh, {{radius, y, 0, 1}, {0, y, 0, 1}}, sides);
  else add_turned(mesh, {{0, y, 0, -1}, {radius, y, 0, -1}}, sides);
  for (std::size_t i = first; i < mesh.vertices.size(); ++i) {
    Vertex& vertex = mesh.vertices[i];
    const float down = up ? vertex.position[2] : -vertex.position[2];
    vertex.uv = {0.5f + vertex.position[0] / static_cast<float>(2 * radius), 0.5f + down / static_cast<float>(2 * radius)};
  }
}

Mesh make_cylinder(double radius, double height, const Detail& detail) {
  Mesh mesh;
  add_cap(mesh, radius, -height / 2, false, detail.sides);
  add_turned(mesh, {{radius, -height / 2, 1, 0}, {radius, height / 2, 1, 0}}, detail.sides);
  add_cap(mesh, radius, height / 2, true, detail.sides);
  return mesh;
}

Mesh make_cone(double radius, double height, const Detail& detail) {
  const double slant = std::hypot(radius, height);
  const double across = height / slant, up = radius / slant;
  Mesh mesh;
  add_cap(mesh, radius, -height / 2, false, detail.sides);
  add_turned(mesh, {{radius, -height / 2, across, up}, {0, height / 2, across, up}}, detail.sides);
  return mesh;
}

Mesh make_torus(double radius, double thickness, const Detail& detail) {
  std::vector<Outline> outline;
  add_arc(outline, radius, 0, thickness / 2, -kPi, kPi, detail.tube_sides);
  outline.back() = outline.front();
  Mesh mesh;
  add_turned(mesh, outline, detail.torus_sides);
  return mesh;
}

}  // namespace

bool is_stand_in(const Shape& shape) {
  if (shape.shape == ShapeKind::hull) return shape.points.empty();
  return shape.shape == ShapeKind::mesh || shape.shape == ShapeKind::height_field;
}

Mesh make_mesh(const Shape& shape) { return make_mesh(shape, 0); }

Mesh make_mesh(const Shape& shape, int coarseness) {
  if (is_stand_in(shape)) return make_box(shape.size);
  const Detail detail(coarseness);
  switch (shape.shape) {
    case ShapeKind::sphere: return make_capsule(shape.radius, 2 * shape.radius, detail);
    case ShapeKind::capsule: return make_capsule(shape.radius, shape.height, detail);
    case ShapeKind::cylinder: return make_cylinder(shape.radius, shape.height, detail);
    case ShapeKind::cone: return make_cone(shape.radius, shape.height, detail);
    case ShapeKind::pyramid: return make_pyramid(shape.size);
    case ShapeKind::plane: return make_plane(shape.size);
    case ShapeKind::torus: return make_torus(shape.radius, shape.thickness, detail);
    case ShapeKind::hull: return make_hull(shape.points);
    default: return make_box(shape.size);
  }
}

int coarseness_within(const Shape& shape, double distance) {
  const auto off = [&](const Detail& detail) {
    switch (shape.shape) {
      case ShapeKind::cylinder:
      case ShapeKind::cone: return sagitta(shape.radius, detail.sides);
      // The middle of a face that is curved both ways lies in by both.
      case ShapeKind::sphere:
      case ShapeKind::capsule: return 2 * sagitta(shape.radius, detail.sides);
      case ShapeKind::torus:
        return sagitta(shape.radius + shape.thickness / 2, detail.torus_sides) + sagitta(shape.thickness / 2, detail.tube_sides);
      default: return 0.0;
    }
  };
  if (off(Detail(0)) == 0) return 0;  // nothing round: there is one mesh only
  int coarseness = 0;
  while (coarseness < kCoarsest && off(Detail(coarseness + 1)) <= distance) ++coarseness;
  return coarseness;
}

std::uint64_t mesh_key(const Shape& shape) {
  Hash hash;
  hash.add(static_cast<std::uint64_t>(shape.shape));
  switch (shape.shape) {
    case ShapeKind::box:
    case ShapeKind::pyramid:
    case ShapeKind::plane: hash.add(shape.size); break;
    case ShapeKind::sphere: hash.add(shape.radius); break;
    case ShapeKind::capsule:
    case ShapeKind::cylinder:
    case ShapeKind::cone: hash.add(shape.radius).add(shape.height); break;
    case ShapeKind::torus: hash.add(shape.radius).add(shape.thickness); break;
    default:
      hash.add(shape.size).add(shape.file);
      for (const Vec3 point : shape.points) hash.add(point);
  }
  return hash.value();
}

}  // namespace tumble
