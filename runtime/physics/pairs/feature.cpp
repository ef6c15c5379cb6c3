#include "physics/pairs/feature.h"

#include <algorithm>

namespace tumble::pairs {

namespace {

// An edge or side this near to being across the direction (sine of the angle) touches along its length, not at a point.
constexpr double kAcross = 0.05;
// Wider for capsules, which are all side: what touches at one end may come to lie down within a pass.
constexpr double kCapsuleAcross = 0.25;
// A cap tilted by less (sine) counts as flat: its corners then stay where they are on the body.
constexpr double kFlat = 1e-4;
constexpr int kRimCorners = 8;
constexpr double kHalf = std::numbers::sqrt2 / 2;
constexpr double kCos[kRimCorners] = {1, kHalf, 0, -kHalf, -1, -kHalf, 0, kHalf};  // of whole eighths of a turn

enum : std::uint32_t { kUpper = 0, kLower = 1, kRim = 16 };

Feature point_feature(Vec3 point, std::uint32_t id) {
  Feature feature;
  feature.count = 1;
  feature.points[0] = point;
  feature.ids[0] = id;
  return feature;
}

Feature segment_feature(Vec3 a, std::uint32_t id_a, Vec3 b, std::uint32_t id_b) {
  Feature feature = point_feature(a, id_a);
  feature.count = 2;
  feature.points[1] = b;
  feature.ids[1] = id_b;
  return feature;
}

Feature box_face(const Placed& placed, Vec3 local) {
  const Vec3 half = placed.shape.half;
  const double size[3] = {std::abs(local.x), std::abs(local.y), std::abs(local.z)};
  const int k = size[0] >= size[1] && size[0] >= size[2] ? 0 : size[1] >= size[2] ? 1 : 2;
  const double along[3] = {local.x, local.y, local.z}, extent[3] = {half.x, half.y, half.z};
  const int u = (k + 1) % 3, v = (k + 2) % 3;
  const bool up = along[k] >= 0;
  const Vec3 out = placed.axis[k] * (up ? 1.0 : -1.0), center = placed.position + out * extent[k];
  // Counter-clockwise about the axis; the other way round for the face on its negative side.
  const int turn_u[4] = {-1, 1, 1, -1}, turn_v[4] = {-1, -1, 1, 1};
  Feature feature;
  feature.count = 4;
  feature.normal = out;
  for (int i = 0; i < 4; ++i) {
    const int corner = up ? i : 3 - i;
    const int su = turn_u[corner], sv = turn_v[corner];
    feature.points[i] = center + placed.axis[u] * (su * extent[u]) + placed.axis[v] * (sv * extent[v]);
    feature.ids[i] = static_cast<std::uint32_t>((up ? 1 << k : 0) | (su > 0 ? 1 << u : 0) | (sv > 0 ? 1 << v : 0));
  }
  return feature;
}

Feature solid_face(const Placed& placed, Vec3 local) {
  const Polyhedron& solid = *placed.shape.solid;
  const Polyhedron::Face* best = &solid.faces[0];
  for (const Polyhedron::Face& face : solid.faces)
    if (dot(face.normal, local) > dot(best->normal, local)) best = &face;
  Feature feature;
  feature.normal = placed.turned(best->normal);
  const int stride = (best->count + Feature::kMost - 1) / Feature::kMost;
  for (int i = 0; i < best->count; i += stride) {
    const int vertex = solid.loops[static_cast<std::size_t>(best->first + i)];
    feature.points[feature.count] = placed.world(solid.vertices[static_cast<std::size_t>(vertex)]);
    feature.ids[feature.count++] = static_cast<std::uint32_t>(vertex);
  }
  return feature;
}

Feature triangle_face(const Placed& placed, Vec3 local) {
  const Vec3* c = placed.shape.corners;
  const Vec3 normal = normalized(cross(c[1] - c[0], c[2] - c[0]));
  const bool front = dot(normal, local) >= 0;
  Feature feature;
  feature.count = 3;
  feature.normal = placed.turned(front ? normal : -normal);
  for (int i = 0; i < 3; ++i) {
    const int corner = front ? i : 2 - i;
    feature.points[i] = placed.world(c[corner]);
    feature.ids[i] = static_cast<std::uint32_t>(corner);
  }
  return feature;
}

Feature capsule_feature(const Placed& placed, Vec3 local) {
  const double r = placed.shape.radius, h = placed.shape.half_height;
  const double across = std::hypot(local.x, local.z);
  if (std::abs(local.y) > kCapsuleAcross || h <= 0)
    return point_feature(placed.world(Vec3{0, local.y >= 0 ? h : -h, 0} + local * r), local.y >= 0 ? kUpper : kLower);
  // At the end that lies nearer the furthest point is on the ball, at the other on the side.
  const Vec3 side = Vec3{local.x, 0, local.z} * (r / across), ball = local * r;
  const Vec3 upper = Vec3{0, h, 0} + (local.y >= 0 ? ball : side), lower = Vec3{0, -h, 0} + (local.y <= 0 ? ball : side);
  return segment_feature(placed.world(upper), kUpper, placed.world(lower), kLower);
}

// The cap or base at a height, its outside up or down.
Feature rim_polygon(const Placed& placed, Vec3 local, double height, bool up) {
  const double r = placed.shape.radius, tilt = std::hypot(local.x, local.z);
  const double c = tilt > kFlat ? local.x / tilt : 1, s = tilt > kFlat ? local.z / tilt : 0;
  Feature feature;
  feature.count = kRimCorners;
  feature.normal = placed.axis[1] * (up ? 1.0 : -1.0);
  for (int i = 0; i < kRimCorners; ++i) {
    const double ca = kCos[i], sa = up ? -kCos[(i + 6) % 8] : kCos[(i + 6) % 8];  // about +y, x turns towards -z
    feature.points[i] = placed.world({r * (c * ca - s * sa), height, r * (s * ca + c * sa)});
    feature.ids[i] = kRim + static_cast<std::uint32_t>(i) + (up ? 0u : kRimCorners);
  }
  return feature;
}

Feature cylinder_feature(const Placed& placed, Vec3 local) {
  const double r = placed.shape.radius, h = placed.shape.half_height, across = std::hypot(local.x, local.z);
  if (std::abs(local.y) >= across) return rim_polygon(placed, local, local.y >= 0 ? h : -h, local.y >= 0);
  const Vec3 out = Vec3{local.x, 0, local.z} * (r / across);
  return segment_feature(placed.world(out + Vec3{0, h, 0}), kUpper, placed.world(out - Vec3{0, h, 0}), kLower);
}

// Sine of the angle by which a direction is off the flank's normal, positive towards the apex.
double off_flank(const Convex& cone, Vec3 local, double across) {
  const double r = cone.radius, height = 2 * cone.half_height;
  return (local.y * height - across * r) / std::hypot(r, height);
}

Feature flank(const Placed& placed, Vec3 local, double across) {
  const double r = placed.shape.radius, h = placed.shape.half_height;
  const Vec3 rim{local.x * r / across, -h, local.z * r / across};
  return segment_feature(placed.world({0, h, 0}), kUpper, placed.world(rim), kLower);
}

Feature cone_feature(const Placed& placed, Vec3 local) {
  const double h = placed.shape.half_height, across = std::hypot(local.x, local.z);
  if (-local.y >= across) return rim_polygon(placed, local, -h, false);
  if (across <= kFlat || off_flank(placed.shape, local, across) > 0.7) return point_feature(placed.world({0, h, 0}), kUpper);
  return flank(placed, local, across);
}

// Of the edges at a vertex the one that is most across the direction.
struct EdgeChoice {
  Vec3 vertex, end;
  int vertex_id = 0, end_id = 0;
  double slope = 1;  // sine of the angle to being across
  void offer(Vec3 other, int id, Vec3 local) {
    const double slant = std::abs(dot(normalized(other - vertex), local));
    if (slant < slope) slope = slant, end = other, end_id = id;
  }
};

EdgeChoice box_edge(const Convex& box, Vec3 d) {
  const int at = (d.x >= 0 ? 1 : 0) | (d.y >= 0 ? 2 : 0) | (d.z >= 0 ? 4 : 0);
  const auto corner = [&](int i) { return scaled(box.half, {i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0}); };
  EdgeChoice choice{corner(at), {}, at};
  for (int bit = 1; bit < 8; bit *= 2) choice.offer(corner(at ^ bit), at ^ bit, d);
  return choice;
}

EdgeChoice solid_edge(const Polyhedron& solid, Vec3 d) {
  int at = 0;
  const auto vertex = [&](int i) { return solid.vertices[static_cast<std::size_t>(i)]; };
  for (int i = 1; i < static_cast<int>(solid.vertices.size()); ++i)
    if (dot(vertex(i), d) > dot(vertex(at), d)) at = i;
  EdgeChoice choice{vertex(at), {}, at};
  for (const Polyhedron::Edge& edge : solid.edges) {
    if (edge.from == at) choice.offer(vertex(edge.to), edge.to, d);
    if (edge.to == at) choice.offer(vertex(edge.from), edge.from, d);
  }
  return choice;
}

EdgeChoice triangle_edge(const Vec3* corners, Vec3 d) {
  int at = 0;
  for (int i = 1; i < 3; ++i)
    if (dot(corners[i], d) > dot(corners[at], d)) at = i;
  EdgeChoice choice{corners[at], {}, at};
  for (int i = 0; i < 3; ++i)
    if (i != at) choice.offer(corners[i], i, d);
  return choice;
}

Feature edge_feature(const Placed& placed, const EdgeChoice& choice) {
  Vec3 a = choice.vertex, b = choice.end;
  auto id_a = static_cast<std::uint32_t>(choice.vertex_id), id_b = static_cast<std::uint32_t>(choice.end_id);
  if (choice.slope > kAcross) return point_feature(placed.world(a), id_a);
  if (id_a > id_b) std::swap(a, b), std::swap(id_a, id_b);  // which of the two is further may change with every pass
  return segment_feature(placed.world(a), id_a, placed.world(b), id_b);
}

}  // namespace

Feature supporting_feature(const Placed& placed, Vec3 direction) {
  const Vec3 local = placed.turned_back(direction);
  switch (placed.shape.kind) {
    case Convex::sphere: break;
    case Convex::capsule: return capsule_feature(placed, local);
    case Convex::box: return box_face(placed, local);
    case Convex::cylinder: return cylinder_feature(placed, local);
    case Convex::cone: return cone_feature(placed, local);
    case Convex::polyhedron: return solid_face(placed, local);
    case Convex::triangle: return triangle_face(placed, local);
  }
  return point_feature(placed.position + direction * placed.shape.radius, 0);
}

Feature supporting_edge(const Placed& placed, Vec3 direction) {
  const Vec3 local = placed.turned_back(direction);
  const double across = std::hypot(local.x, local.z);
  switch (placed.shape.kind) {
    case Convex::sphere:
    case Convex::capsule: return supporting_feature(placed, direction);
    case Convex::box: return edge_feature(placed, box_edge(placed.shape, local));
    case Convex::polyhedron: return edge_feature(placed, solid_edge(*placed.shape.solid, local));
    case Convex::triangle: return edge_feature(placed, triangle_edge(placed.shape.corners, local));
    case Convex::cylinder:
      if (std::abs(local.y) <= kAcross) return cylinder_feature(placed, local);
      break;
    case Convex::cone:
      if (across > kFlat && std::abs(off_flank(placed.shape, local, across)) <= kAcross) return flank(placed, local, across);
      break;
  }
  return point_feature(furthest(placed, direction), kRim);
}

}  // namespace tumble::pairs
