#include "physics/pairs/collide.h"

#include <algorithm>

#include "physics/pairs/round.h"

namespace tumble::pairs {

namespace {

// A direction within this angle of a face's, cap's or side's own is that one, unless that loses distance.
constexpr double kSnap = 1e-3;
constexpr double kSnapLoss = 1e-7;  // of the size
// Cosine from which on a polygon lies along the normal's plane.
constexpr double kAligned = 1 - 1e-8;
// Points this much further apart than the shapes are (of the size) show that the features do not hold the nearest one.
constexpr double kMissed = 1e-5;
// A side that has come past an edge along it, by more than this (of the size), seen along the direction of before, is to be
// looked at anew: that direction would stop it.
constexpr double kBeside = 1e-4;
// Of the size: shapes that overlap by more are looked at anew in every pass.
constexpr double kShallow = 0.01;
// A triangle met by its rim: see the header.
constexpr double kRimCosine = 0.5;

double size_of(const Placed& a, const Placed& b) { return std::min(size_of(a.shape), size_of(b.shape)); }

double least(const Candidates& found) {
  double separation = 1e300;
  for (int i = 0; i < found.count; ++i) separation = std::min(separation, found.points[i].separation);
  return separation;
}

// `deep`: faces count that are not across the normal too, see around_nearest(). `beside`: see overlap().
void overlap_of_features(const Placed& a, const Placed& b, Vec3 normal, double margin, Candidates& found, bool deep = false, double beside = kAnyhow) {
  Feature on_a = supporting_feature(a, -normal), on_b = supporting_feature(b, normal);
  const auto facing = [&](const Feature& feature) { return feature.count > 2 ? std::abs(dot(feature.normal, normal)) : 0; };
  const bool aligned = deep || std::max(facing(on_a), facing(on_b)) > kAligned;
  if (!aligned || edge_on(on_a, normal)) on_a = supporting_edge(a, -normal);
  if (!aligned || edge_on(on_b, normal)) on_b = supporting_edge(b, normal);
  overlap(on_a, on_b, normal, margin, beside, found);
}

// The direction across the side of a round shape that is nearest to the given outward one; zero if it has none.
Vec3 side_direction(const Placed& placed, Vec3 out) {
  const Vec3 axis = placed.axis[1];
  const Vec3 across = normalized(out - axis * dot(out, axis));
  switch (placed.shape.kind) {
    case Convex::capsule:
    case Convex::cylinder: return across;
    case Convex::cone: return normalized(across * (2 * placed.shape.half_height) + axis * placed.shape.radius);
    default: return {};
  }
}

// A cylinder's side is round about its axis: the direction between axes, or from an axis to an edge, is exact where the
// expanding polytope of shapes that overlap has facets. Zero where there is none.
Vec3 direction_between_axes(const Placed& a, const Placed& b) {
  if (a.shape.kind != Convex::cylinder && b.shape.kind != Convex::cylinder) return {};
  const auto axis_of = [](const Convex& shape) {
    return shape.kind == Convex::cylinder ? make_capsule(0, shape.half_height) : shape;
  };
  const Convex core_a = axis_of(a.shape), core_b = axis_of(b.shape);
  Placed at_a(core_a, {a.position, {}}), at_b(core_b, {b.position, {}});
  std::copy(a.axis, a.axis + 3, at_a.axis);
  std::copy(b.axis, b.axis + 3, at_b.axis);
  Nearest near;
  return nearest(at_a, at_b, 1e300, {}, near) ? near.normal : Vec3{};
}

// The normal, or one of a feature's own that is as good.
Vec3 set_right(const Placed& a, const Placed& b, Vec3 normal) {
  const double size = size_of(a, b), given = separation_along(a, b, normal);
  double most = given - kSnapLoss * size;
  Vec3 best = normal;
  const auto offer = [&](Vec3 each) {
    if (dot(each, normal) <= 0 || length(cross(each, normal)) > kSnap) return false;
    const double separation = separation_along(a, b, each);
    if (separation < most) return false;
    most = separation + 1e-9 * size;  // a later one must be better
    best = each;
    return true;
  };
  const Feature on_a = supporting_feature(a, -normal), on_b = supporting_feature(b, normal);
  bool face = on_a.count > 2 && offer(-on_a.normal);
  face = (on_b.count > 2 && offer(on_b.normal)) || face;
  if (face) return best;
  if (given < 0) offer(direction_between_axes(a, b));
  offer(-side_direction(a, -normal));
  offer(side_direction(b, normal));
  return best;
}

// The direction of the pass before still is right if the features along it hold points that are as near as the shapes:
// while these are apart no others can be nearer, and while they overlap a little no other direction near it is less deep.
bool around_known(const Placed& a, const Placed& b, Vec3 known, double margin, Manifold& out) {
  const double size = size_of(a, b);
  const Vec3 normal = set_right(a, b, known);
  const double separation = separation_along(a, b, normal);
  if (separation > margin || separation < -kShallow * size) return false;
  Candidates found;
  overlap_of_features(a, b, normal, margin, found, false, kBeside * size);
  if (found.count == 0 || least(found) > separation + kMissed * size) return false;
  choose_four(found, normal, out);
  return true;
}

// All points along the direction of the nearest ones. Two that were driven deep into each other, which they are along
// some direction that is no face's, would turn about one point, and only get deeper: they are held apart all over.
bool around_nearest(const Placed& a, const Placed& b, Nearest nearest, double margin, Manifold& out) {
  if (nearest.separation > margin) return false;
  Candidates found;
  const bool round = a.shape.kind == Convex::sphere || b.shape.kind == Convex::sphere;
  if (!round) {
    nearest.normal = set_right(a, b, nearest.normal);
    nearest.separation = separation_along(a, b, nearest.normal);
    overlap_of_features(a, b, nearest.normal, margin, found, nearest.separation < -kShallow * size_of(a, b));
  }
  if (least(found) > nearest.separation + kMissed * size_of(a, b)) {
    // A sphere, always the first of its pair, knows its own point exactly; else the two are as wrong.
    const Vec3 apart = nearest.normal * nearest.separation;
    const Vec3 on_a = round ? nearest.on_a : (nearest.on_a + nearest.on_b + apart) * 0.5;
    found.add({on_a, on_a - apart, nearest.separation, 0});
  }
  choose_four(found, nearest.normal, out);
  return out.count > 0;
}

bool at_edges(const Separation& axis, Manifold& out, double near) {
  const Parameters at = nearest_of_segments(axis.edge_a[0], axis.edge_a[1], axis.edge_b[0], axis.edge_b[1]);
  const Vec3 on_a = lerp(axis.edge_a[0], axis.edge_a[1], at.first), on_b = lerp(axis.edge_b[0], axis.edge_b[1], at.second);
  if (distance(on_a, on_b + axis.normal * axis.distance) > near) return false;
  out.normal = axis.normal;
  out.count = 1;
  out.points[0] = {on_a, on_b, axis.distance, 0};
  return true;
}

bool flat_pair(const Placed& a, const Placed& b, double margin, Cache& cache, Manifold& out) {
  const Separation axis = separation(a, b, margin, cache.kind);
  cache.kind = axis.kind;
  if (axis.kind == Separation::none) return false;
  const double size = size_of(a, b);
  if (axis.kind == Separation::edges) {
    if (at_edges(axis, out, 1e-6 * size)) return true;
  } else {
    Candidates found;
    overlap_of_features(a, b, axis.normal, margin, found);
    // As much as separation() may give away for a face.
    const double near = std::max(0.0, 0.05 * axis.distance) + kMissed * size;
    if (found.count > 0 && (axis.distance <= 0 || least(found) <= axis.distance + near)) {
      choose_four(found, axis.normal, out);
      return true;
    }
  }
  Nearest near;
  return nearest(a, b, margin, axis.normal, near) && around_nearest(a, b, near, margin, out);
}

bool other_pair(const Placed& a, const Placed& b, double margin, const Cache& cache, Manifold& out) {
  Nearest near;
  if (nearest_of_round(a, b, near)) return around_nearest(a, b, near, margin, out);
  if (!(cache.normal == Vec3{}) && around_known(a, b, cache.normal, margin, out)) return true;
  return nearest(a, b, margin, cache.normal, near) && around_nearest(a, b, near, margin, out);
}

bool met_by_rim(const Placed& a, const Placed& b, const Manifold& out) {
  const Placed& triangle = a.shape.kind == Convex::triangle ? a : b;
  if (triangle.shape.kind != Convex::triangle) return false;
  for (int i = 0; i < out.count; ++i)
    if (out.points[i].separation <= 0) return false;
  return std::abs(dot(supporting_feature(triangle, out.normal).normal, out.normal)) < kRimCosine;
}

void swap_sides(Manifold& out) {
  out.normal = -out.normal;
  for (int i = 0; i < out.count; ++i) std::swap(out.points[i].on_a, out.points[i].on_b);
}

}  // namespace

bool collide(const Convex& a, const Pose& pose_a, const Convex& b, const Pose& pose_b, double margin, Cache& cache, Manifold& out) {
  if (a.kind > b.kind) {  // one order for every pair of kinds; the cache is in that order too
    const bool found = collide(b, pose_b, a, pose_a, margin, cache, out);
    swap_sides(out);
    return found;
  }
  // About a's place, so that a far origin costs no digits.
  const Vec3 origin = pose_a.position;
  const Placed at_a(a, {{}, pose_a.rotation}), at_b(b, {pose_b.position - origin, pose_b.rotation});
  out.count = 0;
  const bool flat = has_flat_faces(a) && has_flat_faces(b);
  bool found = flat ? flat_pair(at_a, at_b, margin, cache, out) : other_pair(at_a, at_b, margin, cache, out);
  if (found && met_by_rim(at_a, at_b, out)) found = false;
  if (!found) out.count = 0;
  cache.normal = found ? out.normal : Vec3{};
  for (int i = 0; i < out.count; ++i) out.points[i].on_a += origin, out.points[i].on_b += origin;
  return found;
}

bool closest(const Convex& a, const Pose& pose_a, const Convex& b, const Pose& pose_b, double within, Nearest& out) {
  if (a.kind > b.kind) {
    const bool found = closest(b, pose_b, a, pose_a, within, out);
    out.normal = -out.normal;
    std::swap(out.on_a, out.on_b);
    return found;
  }
  const Vec3 origin = pose_a.position;  // so that a far origin costs no digits
  const Placed at_a(a, {{}, pose_a.rotation}), at_b(b, {pose_b.position - origin, pose_b.rotation});
  const bool known = nearest_of_round(at_a, at_b, out) || nearest(at_a, at_b, within, {}, out);
  if (!known || out.separation > within) return false;
  out.on_a += origin;
  out.on_b += origin;
  return true;
}

}  // namespace tumble::pairs
