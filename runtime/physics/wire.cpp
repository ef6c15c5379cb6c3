#include "physics/wire.h"

#include <algorithm>
#include <array>
#include <map>

#include "physics/solids.h"

namespace tumble {

namespace {

void add_ring(Wire& wire, double y, double r) { add_arc(wire, {0, y, 0}, {r, 0, 0}, {0, 0, r}, 2 * kPi); }

// Four lines between a low and a high ring.
void add_sides(Wire& wire, double low, double r_low, double high, double r_high) {
  for (const Vec3 out : {Vec3{1, 0, 0}, Vec3{-1, 0, 0}, Vec3{0, 0, 1}, Vec3{0, 0, -1}})
    wire.push_back({out * r_low + Vec3{0, low, 0}, out * r_high + Vec3{0, high, 0}});
}

void add_box(Wire& wire, Vec3 half) {
  for (const double a : {-1.0, 1.0})
    for (const double b : {-1.0, 1.0}) {
      wire.push_back({{-half.x, a * half.y, b * half.z}, {half.x, a * half.y, b * half.z}});
      wire.push_back({{a * half.x, -half.y, b * half.z}, {a * half.x, half.y, b * half.z}});
      wire.push_back({{a * half.x, b * half.y, -half.z}, {a * half.x, b * half.y, half.z}});
    }
}

void add_plane(Wire& wire, double x, double z) {
  const std::array<Vec3, 4> corners = {Vec3{-x, 0, -z}, {x, 0, -z}, {x, 0, z}, {-x, 0, z}};
  for (std::size_t i = 0; i < 4; ++i) wire.push_back({corners[i], corners[(i + 1) % 4]});
}

void add_sphere(Wire& wire, double r) {
  add_ring(wire, 0, r);
  add_arc(wire, {}, {r, 0, 0}, {0, r, 0}, 2 * kPi);
  add_arc(wire, {}, {0, 0, r}, {0, r, 0}, 2 * kPi);
}

void add_capsule(Wire& wire, double r, double half_axis) {
  for (const double sign : {-1.0, 1.0}) {
    const Vec3 center{0, sign * half_axis, 0}, up{0, sign * r, 0};
    add_ring(wire, center.y, r);
    add_arc(wire, center, {r, 0, 0}, up, kPi);
    add_arc(wire, center, {0, 0, r}, up, kPi);
  }
  add_sides(wire, -half_axis, r, half_axis, r);
}

void add_torus(Wire& wire, const Shape& torus) {
  const double r = torus.thickness / 2;
  add_ring(wire, 0, torus.radius + r);
  add_ring(wire, 0, torus.radius - r);
  add_ring(wire, r, torus.radius);
  add_ring(wire, -r, torus.radius);
  for (int i = 0; i < 8; ++i) {
    const Vec3 out{std::cos(kPi * i / 4), 0, std::sin(kPi * i / 4)};
    add_arc(wire, out * torus.radius, out * r, {0, r, 0}, 2 * kPi);
  }
}

void add_triangles(Wire& wire, const std::vector<Triangle>& triangles) {
  struct Edge {
    Vec3 from, to, normal;
    bool flat = false;   // so far only between triangles of one plane
  };
  using Key = std::array<double, 6>;
  std::map<Key, Edge> edges;
  const auto before = [](Vec3 a, Vec3 b) { return std::array{a.x, a.y, a.z} < std::array{b.x, b.y, b.z}; };
  for (const Triangle& t : triangles) {
    const Vec3 normal = normalized(cross(t.b - t.a, t.c - t.a));
    for (auto [from, to] : {std::pair(t.a, t.b), std::pair(t.b, t.c), std::pair(t.c, t.a)}) {
      if (before(to, from)) std::swap(from, to);
      const auto [edge, fresh] = edges.try_emplace({from.x, from.y, from.z, to.x, to.y, to.z}, Edge{from, to, normal});
      if (!fresh) edge->second.flat = std::abs(dot(edge->second.normal, normal)) > 1 - 1e-6;  // within a twelfth of a degree
    }
  }
  for (const auto& [key, edge] : edges)
    if (!edge.flat) wire.push_back({edge.from, edge.to});
}

std::vector<Triangle> triangles_of(const std::vector<Vec3>& points) {
  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i + 2 < points.size(); i += 3) triangles.push_back({points[i], points[i + 1], points[i + 2]});
  return triangles;
}

}  // namespace

void add_arc(Wire& wire, Vec3 center, Vec3 u, Vec3 v, double angle) {
  const int parts = std::max(2, static_cast<int>(std::ceil(std::abs(angle) * 24 / (2 * kPi) - 1e-9)));
  Vec3 last = center + u;
  for (int i = 1; i <= parts; ++i) {
    const double a = angle * i / parts;
    const Vec3 next = center + u * std::cos(a) + v * std::sin(a);
    wire.push_back({last, next});
    last = next;
  }
}

Wire wire_of(const Shape& shape) {
  Wire wire;
  const double r = shape.radius, h = shape.height / 2;
  switch (shape.shape) {
    case ShapeKind::box: add_box(wire, shape.size / 2); break;
    case ShapeKind::sphere: add_sphere(wire, r); break;
    case ShapeKind::capsule: add_capsule(wire, r, std::max(0.0, h - r)); break;
    case ShapeKind::cylinder:
      add_ring(wire, h, r);
      add_ring(wire, -h, r);
      add_sides(wire, -h, r, h, r);
      break;
    case ShapeKind::cone:
      add_ring(wire, -h, r);
      add_sides(wire, -h, r, h, 0);
      break;
    case ShapeKind::pyramid: add_triangles(wire, convex_hull(pyramid_points(shape))); break;
    case ShapeKind::plane: add_plane(wire, shape.size.x / 2, shape.size.z / 2); break;
    case ShapeKind::torus: add_torus(wire, shape); break;
    case ShapeKind::hull: add_triangles(wire, convex_hull(shape.points)); break;
    case ShapeKind::mesh:
    case ShapeKind::height_field: add_triangles(wire, triangles_of(shape.points)); break;
  }
  return wire;
}

}  // namespace tumble
