#include "physics/solids.h"

#include <algorithm>

namespace tumble {

namespace {

Solid diagonal(double volume, Vec3 center, Vec3 inertia) {
  Solid solid{volume, center, {}};
  solid.inertia[0][0] = inertia.x;
  solid.inertia[1][1] = inertia.y;
  solid.inertia[2][2] = inertia.z;
  return solid;
}

Solid box(Vec3 size, Vec3 center) {
  const double v = size.x * size.y * size.z;
  const Vec3 s = scaled(size, size);
  return diagonal(v, center, Vec3{s.y + s.z, s.x + s.z, s.x + s.y} * (v / 12));
}

Solid sphere(double r) {
  const double v = 4.0 / 3 * kPi * r * r * r, i = 0.4 * v * r * r;
  return diagonal(v, {}, {i, i, i});
}

Solid cylinder(double r, double h) {
  const double v = kPi * r * r * h, across = v * (3 * r * r + h * h) / 12;
  return diagonal(v, {}, {across, v * r * r / 2, across});
}

// A cylinder and two half balls; a half ball's centre is 3/8 r above its flat side.
Solid capsule(double r, double height) {
  const double h = std::max(0.0, height - 2 * r);
  const double vc = kPi * r * r * h, vs = 4.0 / 3 * kPi * r * r * r;
  const double along = vc * r * r / 2 + 0.4 * vs * r * r;
  const double across = vc * (r * r / 4 + h * h / 12) + vs * (0.4 * r * r + h * h / 4 + 3.0 / 8 * h * r);
  return diagonal(vc + vs, {}, {across, along, across});
}

Solid cone(double r, double h) {
  const double v = kPi * r * r * h / 3, across = v * 3.0 / 80 * (4 * r * r + h * h);
  return diagonal(v, {0, -h / 4, 0}, {across, 0.3 * v * r * r, across});
}

Solid pyramid(Vec3 size) {
  const double v = size.x * size.y * size.z / 3;
  const Vec3 s = scaled(size, size);
  const double rise = 3.0 / 80 * s.y;
  return diagonal(v, {0, -size.y / 4, 0}, Vec3{s.z / 20 + rise, (s.x + s.z) / 20, s.x / 20 + rise} * v);
}

Solid torus(double big, double thickness) {
  const double r = thickness / 2, v = 2 * kPi * kPi * big * r * r;
  const double across = v * (big * big / 2 + 5.0 / 8 * r * r);
  return diagonal(v, {}, {across, v * (big * big + 0.75 * r * r), across});
}

double component(Vec3 v, int i) { return i == 0 ? v.x : i == 1 ? v.y : v.z; }

// Sum over the tetrahedra between an inner point and each face: volume det/6, first moment det/24 (a + b + c), second
// moment det/120 (aa + bb + cc + ss) with s = a + b + c.
Solid polyhedron(const std::vector<Triangle>& faces) {
  if (faces.empty()) return {};
  const Vec3 inner = faces.front().a;
  double six_volumes = 0;
  Vec3 first;
  std::array<std::array<double, 3>, 3> second{};
  for (const Triangle& face : faces) {
    const Vec3 a = face.a - inner, b = face.b - inner, c = face.c - inner, s = a + b + c;
    const double det = dot(a, cross(b, c));
    six_volumes += det;
    first += s * (det / 24);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        for (const Vec3 v : {a, b, c, s}) second[i][j] += det / 120 * component(v, i) * component(v, j);
  }

  Solid solid;
  solid.volume = six_volumes / 6;
  if (solid.volume <= 0) return {};
  const Vec3 center = first / solid.volume;
  solid.center = inner + center;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) second[i][j] -= solid.volume * component(center, i) * component(center, j);
  const double trace = second[0][0] + second[1][1] + second[2][2];
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) solid.inertia[i][j] = (i == j ? trace : 0) - second[i][j];
  return solid;
}

}  // namespace

double plane_thickness(const Shape& plane) { return std::min(0.1, 0.1 * std::min(plane.size.x, plane.size.z)); }

std::vector<Vec3> pyramid_points(const Shape& pyramid) {
  const Vec3 h = pyramid.size / 2;
  return {{-h.x, -h.y, -h.z}, {h.x, -h.y, -h.z}, {h.x, -h.y, h.z}, {-h.x, -h.y, h.z}, {0, h.y, 0}};
}

Solid solid_of(const Shape& shape) {
  switch (shape.shape) {
    case ShapeKind::box: return box(shape.size, {});
    case ShapeKind::sphere: return sphere(shape.radius);
    case ShapeKind::capsule: return capsule(shape.radius, shape.height);
    case ShapeKind::cylinder: return cylinder(shape.radius, shape.height);
    case ShapeKind::cone: return cone(shape.radius, shape.height);
    case ShapeKind::pyramid: return pyramid(shape.size);
    case ShapeKind::plane: {
      const double t = plane_thickness(shape);
      return box({shape.size.x, t, shape.size.z}, {0, -t / 2, 0});
    }
    case ShapeKind::torus: return torus(shape.radius, shape.thickness);
    case ShapeKind::hull: return polyhedron(convex_hull(shape.points));
    case ShapeKind::mesh:
    case ShapeKind::height_field: break;
  }
  return {};
}

}  // namespace tumble
