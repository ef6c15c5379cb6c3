// Where a ray enters a convex shape: closed forms, in the shape's own frame.
#pragma once

#include <optional>
#include <vector>

#include "base/math.h"

namespace tumble {

struct Ray {
  Vec3 origin, direction;  // of length 1
};
struct RayHit {
  double distance = 0;
  Vec3 normal;             // outward
  bool inside = false;     // it began inside: distance 0, normal against the direction
};
struct Plane {
  Vec3 normal;             // outward, of length 1
  double offset = 0;       // the shape is where dot(normal, p) <= offset
};

// All centred on the origin, axis y.
std::optional<RayHit> ray_sphere(const Ray& ray, double radius);
std::optional<RayHit> ray_box(const Ray& ray, Vec3 half);
std::optional<RayHit> ray_capsule(const Ray& ray, double radius, double half_axis);
std::optional<RayHit> ray_cylinder(const Ray& ray, double radius, double half_height);
std::optional<RayHit> ray_cone(const Ray& ray, double radius, double height);
std::optional<RayHit> ray_planes(const Ray& ray, const std::vector<Plane>& planes);
// From either side; the normal is on the side of the origin.
std::optional<RayHit> ray_triangle(const Ray& ray, Vec3 a, Vec3 b, Vec3 c);

}  // namespace tumble
