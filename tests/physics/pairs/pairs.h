// Random shapes and poses, distances of points from surfaces, and what every manifold must fulfil.
#pragma once

#include <catch2/catch.hpp>

#include <algorithm>
#include <random>

#include "physics/pairs/collide.h"

namespace tumble::pairs {

struct Random {
  std::mt19937 engine;
  explicit Random(unsigned seed) : engine(seed) {}
  double between(double low, double high) { return low + (high - low) * (engine() / 4294967296.0); }
  Vec3 vector(double size) { return {between(-size, size), between(-size, size), between(-size, size)}; }
  Vec3 direction() {
    for (;;)
      if (const Vec3 v = vector(1); length(v) > 0.1 && length(v) < 1) return normalized(v);
  }
  Quat rotation() { return axis_angle(direction(), between(0, 2 * kPi)); }
  Pose pose(double size) { return {vector(size), rotation()}; }
};

inline double outside(double x, double y) { return std::min(std::max(x, y), 0.0) + std::hypot(std::max(x, 0.0), std::max(y, 0.0)); }

// Signed distance of a point from the surface: exact outside and on it.
inline double surface_distance(const Convex& shape, Vec3 p) {
  const double across = std::hypot(p.x, p.z);
  switch (shape.kind) {
    case Convex::sphere: return length(p) - shape.radius;
    case Convex::capsule: return distance(p, {0, std::clamp(p.y, -shape.half_height, shape.half_height), 0}) - shape.radius;
    case Convex::box: return outside(std::abs(p.x) - shape.half.x, outside(std::abs(p.y) - shape.half.y, std::abs(p.z) - shape.half.z));
    case Convex::cylinder: return outside(across - shape.radius, std::abs(p.y) - shape.half_height);
    case Convex::cone: {
      const double h = 2 * shape.half_height, r = shape.radius;
      return std::max((across * h + (p.y - shape.half_height) * r) / std::hypot(h, r), -shape.half_height - p.y);
    }
    case Convex::polyhedron: {
      double most = -1e300;
      for (const Polyhedron::Face& face : shape.solid->faces) most = std::max(most, dot(face.normal, p) - face.offset);
      return most;
    }
    case Convex::triangle: break;
  }
  const Vec3* c = shape.corners;
  const Vec3 normal = normalized(cross(c[1] - c[0], c[2] - c[0]));
  double most = std::abs(dot(normal, p - c[0]));
  for (int i = 0; i < 3; ++i) most = std::max(most, dot(normalized(cross(c[(i + 1) % 3] - c[i], normal)), p - c[i]));
  return most;
}

inline double off_surface(const Convex& shape, const Pose& pose, Vec3 point) {
  return std::abs(surface_distance(shape, inverse(pose) * point));
}

struct Look {
  Manifold manifold;
  bool found = false;
  double least() const {
    double separation = 1e300;
    for (int i = 0; i < manifold.count; ++i) separation = std::min(separation, manifold.points[i].separation);
    return separation;
  }
};
inline Look look(const Convex& a, const Pose& at_a, const Convex& b, const Pose& at_b, double margin = 0.1) {
  Look seen;
  Cache cache;
  seen.found = collide(a, at_a, b, at_b, margin, cache, seen.manifold);
  return seen;
}

}  // namespace tumble::pairs
