#include "physics/rays.h"

#include <algorithm>

namespace tumble {

namespace {

constexpr double kFar = 1e300;

RayHit inside(const Ray& ray) { return {0, -ray.direction, true}; }

// The part of a ray in the shape so far, and the normal where it enters.
struct Span {
  double enter = -kFar, leave = kFar;
  Vec3 normal;

  void clip(double from, double to, Vec3 at) {
    if (from > enter) {
      enter = from;
      normal = at;
    }
    leave = std::min(leave, to);
  }
  // Nothing before `distance` counts, as where the ray meets the far half of a cone.
  std::optional<RayHit> hit(const Ray& ray) const {
    if (enter > leave || leave < 0) return {};
    if (enter <= 0) return inside(ray);
    return RayHit{enter, normal, false};
  }
};

void clip_plane(const Ray& ray, Vec3 normal, double offset, Span& span) {
  const double speed = dot(normal, ray.direction), gap = offset - dot(normal, ray.origin);
  if (speed < 0) span.clip(gap / speed, kFar, normal);
  else if (speed > 0) span.leave = std::min(span.leave, gap / speed);
  else if (gap < 0) span.leave = -kFar;
}

// Solutions of |q + t p| = r, from the point of closest approach, so that a far origin costs no digits.
bool circle(double qx, double qz, double px, double pz, double r, double& from, double& to) {
  const double p2 = px * px + pz * pz;
  if (p2 < 1e-300) {
    from = -kFar;
    to = kFar;
    return qx * qx + qz * qz <= r * r;
  }
  const double nearest = -(qx * px + qz * pz) / p2, across = (qx * pz - qz * px) * (qx * pz - qz * px) / p2;
  if (across > r * r) return false;
  const double half = std::sqrt((r * r - across) / p2);
  from = nearest - half;
  to = nearest + half;
  return true;
}

std::optional<RayHit> earlier(const std::optional<RayHit>& a, const std::optional<RayHit>& b) {
  if (!a || !b) return a ? a : b;
  return a->inside || (!b->inside && a->distance <= b->distance) ? a : b;
}

}  // namespace

std::optional<RayHit> ray_sphere(const Ray& ray, double radius) {
  const double nearest = -dot(ray.origin, ray.direction);
  const Vec3 across = ray.origin + ray.direction * nearest;
  const double half2 = radius * radius - dot(across, across);
  if (half2 < 0) return {};
  const double half = std::sqrt(half2);
  if (nearest + half < 0) return {};
  if (nearest - half <= 0) return inside(ray);
  return RayHit{nearest - half, normalized(across - ray.direction * half), false};
}

std::optional<RayHit> ray_box(const Ray& ray, Vec3 half) {
  Span span;
  for (const double sign : {-1.0, 1.0}) {
    clip_plane(ray, {sign, 0, 0}, half.x, span);
    clip_plane(ray, {0, sign, 0}, half.y, span);
    clip_plane(ray, {0, 0, sign}, half.z, span);
  }
  return span.hit(ray);
}

std::optional<RayHit> ray_cylinder(const Ray& ray, double radius, double half_height) {
  Span span;
  clip_plane(ray, {0, 1, 0}, half_height, span);
  clip_plane(ray, {0, -1, 0}, half_height, span);
  double from, to;
  if (!circle(ray.origin.x, ray.origin.z, ray.direction.x, ray.direction.z, radius, from, to)) return {};
  const Vec3 at = ray.origin + ray.direction * from;
  span.clip(from, to, from > -kFar ? normalized(Vec3{at.x, 0, at.z}) : Vec3{});
  return span.hit(ray);
}

std::optional<RayHit> ray_capsule(const Ray& ray, double radius, double half_axis) {
  const auto cap = [&](double y) { return ray_sphere({ray.origin - Vec3{0, y, 0}, ray.direction}, radius); };
  const auto side = half_axis > 0 ? ray_cylinder(ray, radius, half_axis) : std::nullopt;
  return earlier(earlier(side, cap(half_axis)), cap(-half_axis));
}

std::optional<RayHit> ray_cone(const Ray& ray, double radius, double height) {
  // From the apex down: x^2 + z^2 = (k s)^2, s the way below it. Solved from the ray's point nearest to the origin.
  const double start = -dot(ray.origin, ray.direction);
  const Vec3 o = ray.origin + ray.direction * start, d = ray.direction;
  const double k = radius / height, s = height / 2 - o.y;
  const double a = d.x * d.x + d.z * d.z - k * k * d.y * d.y;
  const double b = o.x * d.x + o.z * d.z + k * k * s * d.y;
  const double c = o.x * o.x + o.z * o.z - k * k * s * s;
  std::optional<RayHit> best;
  const auto offer = [&](double t, Vec3 normal) {
    if (start + t > 0) best = earlier(best, RayHit{start + t, normal, false});
  };
  const double root2 = b * b - a * c;
  if (root2 >= 0 && std::abs(a) > 1e-15) {
    for (const double sign : {-1.0, 1.0}) {
      const double t = (-b + sign * std::sqrt(root2)) / a, below = s - d.y * t;
      if (below < 0 || below > height) continue;
      const Vec3 at = o + d * t;
      const Vec3 out = normalized(Vec3{at.x, k * k * below, at.z});
      if (dot(out, d) < 0) offer(t, out);
    }
  }
  if (d.y > 0) {
    const double t = (-height / 2 - o.y) / d.y;
    const Vec3 at = o + d * t;
    if (at.x * at.x + at.z * at.z <= radius * radius) offer(t, {0, -1, 0});
  }
  const double below = height / 2 - ray.origin.y, around = std::hypot(ray.origin.x, ray.origin.z);
  if (below >= 0 && below <= height && around <= k * below) return inside(ray);
  return best;
}

std::optional<RayHit> ray_planes(const Ray& ray, const std::vector<Plane>& planes) {
  Span span;
  for (const Plane& plane : planes) clip_plane(ray, plane.normal, plane.offset, span);
  return span.hit(ray);
}

std::optional<RayHit> ray_triangle(const Ray& ray, Vec3 a, Vec3 b, Vec3 c) {
  Vec3 normal = cross(b - a, c - a);
  const double speed = dot(normal, ray.direction);
  if (speed == 0) return {};
  const double t = dot(a - ray.origin, normal) / speed;
  if (t < 0) return {};
  const Vec3 p = ray.origin + ray.direction * t;
  const double slack = -1e-9 * dot(normal, normal);  // so that no ray slips through between two triangles
  for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
    if (dot(cross(to - from, p - from), normal) < slack) return {};
  normal = normalized(normal);
  return RayHit{t, speed < 0 ? normal : -normal, false};
}

}  // namespace tumble
