#include "physics/pairs/convex.h"

#include <algorithm>

namespace tumble::pairs {

namespace {

// The point of a disc of this radius about the axis y; its middle where the direction is along the axis.
Vec3 on_rim(Vec3 direction, double radius, double height) {
  const double across = std::hypot(direction.x, direction.z);
  if (across <= 1e-12 * std::abs(direction.y)) return {0, height, 0};
  return {direction.x * radius / across, height, direction.z * radius / across};
}

Vec3 furthest_vertex(const Vec3* points, std::size_t count, Vec3 direction) {
  std::size_t best = 0;
  double most = dot(points[0], direction);
  for (std::size_t i = 1; i < count; ++i) {
    const double along = dot(points[i], direction);
    if (along > most) most = along, best = i;
  }
  return points[best];
}

Vec3 furthest_of_cone(const Convex& cone, Vec3 d) {
  const double rim = cone.radius * std::hypot(d.x, d.z) - cone.half_height * d.y;
  if (cone.half_height * d.y >= rim) return {0, cone.half_height, 0};
  return on_rim(d, cone.radius, -cone.half_height);
}

Vec3 local_furthest(const Convex& shape, Vec3 d) {
  switch (shape.kind) {
    case Convex::sphere: break;
    case Convex::capsule: return {0, d.y >= 0 ? shape.half_height : -shape.half_height, 0};
    case Convex::box:
      return {d.x >= 0 ? shape.half.x : -shape.half.x, d.y >= 0 ? shape.half.y : -shape.half.y, d.z >= 0 ? shape.half.z : -shape.half.z};
    case Convex::cylinder: return on_rim(d, shape.radius, d.y >= 0 ? shape.half_height : -shape.half_height);
    case Convex::cone: return furthest_of_cone(shape, d);
    case Convex::polyhedron: return furthest_vertex(shape.solid->vertices.data(), shape.solid->vertices.size(), d);
    case Convex::triangle: return furthest_vertex(shape.corners, 3, d);
  }
  return {};
}

}  // namespace

Convex make_sphere(double radius) {
  Convex shape;
  shape.radius = radius;
  return shape;
}

Convex make_capsule(double radius, double half_height) {
  Convex shape;
  shape.kind = Convex::capsule;
  shape.radius = radius;
  shape.half_height = half_height;
  return shape;
}

Convex make_box(Vec3 half) {
  Convex shape;
  shape.kind = Convex::box;
  shape.half = half;
  return shape;
}

Convex make_cylinder(double radius, double half_height) {
  Convex shape = make_capsule(radius, half_height);
  shape.kind = Convex::cylinder;
  return shape;
}

Convex make_cone(double radius, double half_height) {
  Convex shape = make_capsule(radius, half_height);
  shape.kind = Convex::cone;
  return shape;
}

Convex make_solid(const Polyhedron& solid) {
  Convex shape;
  shape.kind = Convex::polyhedron;
  shape.solid = &solid;
  return shape;
}

Convex make_triangle(Vec3 a, Vec3 b, Vec3 c) {
  Convex shape;
  shape.kind = Convex::triangle;
  shape.corners[0] = a;
  shape.corners[1] = b;
  shape.corners[2] = c;
  return shape;
}

Placed::Placed(const Convex& given, const Pose& pose)
    : shape(given),
      position(pose.position),
      axis{pose.rotation * Vec3{1, 0, 0}, pose.rotation * Vec3{0, 1, 0}, pose.rotation * Vec3{0, 0, 1}} {}

Vec3 furthest_of_core(const Placed& placed, Vec3 direction) {
  return placed.world(local_furthest(placed.shape, placed.turned_back(direction)));
}

double rounding(const Convex& shape) {
  return shape.kind == Convex::sphere || shape.kind == Convex::capsule ? shape.radius : 0;
}

Vec3 furthest(const Placed& placed, Vec3 direction) {
  const Vec3 core = furthest_of_core(placed, direction);
  const double round = rounding(placed.shape);
  return round > 0 ? core + normalized(direction) * round : core;
}

Vec3 middle(const Placed& placed) {
  const Convex& shape = placed.shape;
  if (shape.kind == Convex::polyhedron) return placed.world(shape.solid->center);
  if (shape.kind == Convex::triangle) return placed.world((shape.corners[0] + shape.corners[1] + shape.corners[2]) / 3);
  return placed.position;
}

double size_of(const Convex& shape) {
  switch (shape.kind) {
    case Convex::box: return length(shape.half);
    case Convex::polyhedron: return distance(shape.solid->vertices[0], shape.solid->center);
    case Convex::triangle: return std::max(distance(shape.corners[0], shape.corners[1]), distance(shape.corners[0], shape.corners[2])) / 2;
    default: return std::max(shape.radius, shape.half_height);
  }
}

double separation_along(const Placed& a, const Placed& b, Vec3 normal) {
  return dot(furthest_of_core(a, -normal) - furthest_of_core(b, normal), normal) - rounding(a.shape) - rounding(b.shape);
}

}  // namespace tumble::pairs
