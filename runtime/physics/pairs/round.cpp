#include "physics/pairs/round.h"

#include <algorithm>

namespace tumble::pairs {

namespace {

Vec3 any_across(Vec3 axis) { return normalized(cross(axis, std::abs(axis.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0})); }

// Around two points of the cores; where they are one, `otherwise` is the normal.
void between_points(Vec3 core_a, double round_a, Vec3 core_b, double round_b, Vec3 otherwise, Nearest& out) {
  const Vec3 apart = core_a - core_b;
  const double size = length(apart);
  out.normal = size > 1e-12 * (round_a + round_b) ? apart / size : otherwise;
  out.on_a = core_a - out.normal * round_a;
  out.on_b = core_b + out.normal * round_b;
  out.separation = size - round_a - round_b;
}

void sphere_box(const Placed& sphere, const Placed& box, Nearest& out) {
  const double radius = sphere.shape.radius;
  const Vec3 half = box.shape.half, p = box.turned_back(sphere.position - box.position);
  const Vec3 on{std::clamp(p.x, -half.x, half.x), std::clamp(p.y, -half.y, half.y), std::clamp(p.z, -half.z, half.z)};
  if (!(on == p)) {
    // Seen from within the box's frame the normal of a face is exact.
    const Vec3 apart = p - on;
    const double size = length(apart);
    out.normal = box.turned(apart / size);
    out.on_b = box.world(on);
    out.separation = size - radius;
  } else {
    const double depth[3] = {half.x - std::abs(p.x), half.y - std::abs(p.y), half.z - std::abs(p.z)};
    const double side[3] = {p.x, p.y, p.z};
    const int k = depth[0] <= depth[1] && depth[0] <= depth[2] ? 0 : depth[1] <= depth[2] ? 1 : 2;
    out.normal = box.axis[k] * (side[k] >= 0 ? 1.0 : -1.0);
    out.on_b = sphere.position + out.normal * depth[k];
    out.separation = -depth[k] - radius;
  }
  out.on_a = sphere.position - out.normal * radius;
}

// The point of a triangle nearest to p (C. Ericson, Real-Time Collision Detection, 5.1.5).
Vec3 nearest_of_triangle(Vec3 p, Vec3 a, Vec3 b, Vec3 c) {
  const Vec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
  const double d1 = dot(ab, ap), d2 = dot(ac, ap), d3 = dot(ab, bp), d4 = dot(ac, bp), d5 = dot(ab, cp), d6 = dot(ac, cp);
  if (d1 <= 0 && d2 <= 0) return a;
  if (d3 >= 0 && d4 <= d3) return b;
  if (d6 >= 0 && d5 <= d6) return c;
  const double vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + ab * (d1 / (d1 - d3));
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + ac * (d2 / (d2 - d6));
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return b + (c - b) * ((d4 - d3) / (d4 - d3 + d5 - d6));
  return a + ab * (vb / (va + vb + vc)) + ac * (vc / (va + vb + vc));
}

void sphere_triangle(const Placed& sphere, const Placed& triangle, Nearest& out) {
  const Vec3 a = triangle.world(triangle.shape.corners[0]), b = triangle.world(triangle.shape.corners[1]),
             c = triangle.world(triangle.shape.corners[2]);
  const Vec3 flat = normalized(cross(b - a, c - a));
  between_points(sphere.position, sphere.shape.radius, nearest_of_triangle(sphere.position, a, b, c), 0, flat, out);
}

void sphere_capsule(const Placed& sphere, const Placed& capsule, Nearest& out) {
  const double h = capsule.shape.half_height, along = dot(sphere.position - capsule.position, capsule.axis[1]);
  const Vec3 core = capsule.position + capsule.axis[1] * std::clamp(along, -h, h);
  between_points(sphere.position, sphere.shape.radius, core, capsule.shape.radius, any_across(capsule.axis[1]), out);
}

void capsule_capsule(const Placed& a, const Placed& b, Nearest& out) {
  const Vec3 ha = a.axis[1] * a.shape.half_height, hb = b.axis[1] * b.shape.half_height;
  const Vec3 a0 = a.position - ha, b0 = b.position - hb;
  const Parameters at = nearest_of_segments(a0, a.position + ha, b0, b.position + hb);
  const Vec3 across = cross(a.axis[1], b.axis[1]);
  const Vec3 otherwise = length(across) > 1e-6 ? normalized(across) : any_across(a.axis[1]);
  between_points(a0 + ha * (2 * at.first), a.shape.radius, b0 + hb * (2 * at.second), b.shape.radius, otherwise, out);
}

}  // namespace

Parameters nearest_of_segments(Vec3 a0, Vec3 a1, Vec3 b0, Vec3 b1) {
  const Vec3 da = a1 - a0, db = b1 - b0, between = b0 - a0;
  const double aa = dot(da, da), bb = dot(db, db), ab = dot(da, db), a_between = dot(da, between), b_between = dot(db, between);
  const double turn = aa * bb - ab * ab;
  if (aa <= 0) return {0, bb > 0 ? std::clamp(-b_between / bb, 0.0, 1.0) : 0};
  if (bb <= 0) return {std::clamp(a_between / aa, 0.0, 1.0), 0};
  double s;
  if (turn > 1e-12 * aa * bb) {
    s = std::clamp((a_between * bb - ab * b_between) / turn, 0.0, 1.0);
  } else {
    const double first = a_between / aa, second = (a_between + ab) / aa;  // b's ends along a
    s = (std::clamp(std::min(first, second), 0.0, 1.0) + std::clamp(std::max(first, second), 0.0, 1.0)) / 2;
  }
  const double t = std::clamp((ab * s - b_between) / bb, 0.0, 1.0);
  return {std::clamp((a_between + ab * t) / aa, 0.0, 1.0), t};
}

bool nearest_of_round(const Placed& a, const Placed& b, Nearest& out) {
  if (a.shape.kind == Convex::capsule && b.shape.kind == Convex::capsule) return capsule_capsule(a, b, out), true;
  if (a.shape.kind != Convex::sphere) return false;
  switch (b.shape.kind) {
    case Convex::sphere: between_points(a.position, a.shape.radius, b.position, b.shape.radius, {0, 1, 0}, out); return true;
    case Convex::capsule: sphere_capsule(a, b, out); return true;
    case Convex::box: sphere_box(a, b, out); return true;
    case Convex::triangle: sphere_triangle(a, b, out); return true;
    default: return false;
  }
}

}  // namespace tumble::pairs
