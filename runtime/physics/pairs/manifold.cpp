#include "physics/pairs/manifold.h"

#include <algorithm>

namespace tumble::pairs {

namespace {

// Of the extent of all candidates: nearer ones are one point, the deeper of them.
constexpr double kSamePoint = 1e-3;
// Of the same: a candidate must be better by this to be chosen before an earlier one.
constexpr double kBetter = 1e-6;

// Alike for a and b.
Vec3 place(const Point& point) { return (point.on_a + point.on_b) * 0.5; }

double extent_of(const Candidates& found) {
  double most = 0;
  for (int i = 1; i < found.count; ++i) most = std::max(most, distance(place(found.points[i]), place(found.points[0])));
  return most;
}

Candidates without_twins(const Candidates& found, double near) {
  Candidates kept;
  for (int i = 0; i < found.count; ++i) {
    const Point& point = found.points[i];
    Point* const end = kept.points + kept.count;
    Point* const twin = std::find_if(kept.points, end, [&](const Point& p) { return distance(place(p), place(point)) <= near; });
    if (twin == end) kept.add(point);
    else if (point.separation < twin->separation) *twin = point;
  }
  return kept;
}

// The first candidate whose value is not bettered by more than `better`.
template <class F>
int best(const Candidates& found, double better, F value) {
  int chosen = -1;
  double most = 0;
  for (int i = 0; i < found.count; ++i) {
    const double v = value(found.points[i]);
    if (chosen < 0 || v > most + better) chosen = i, most = v;
  }
  return chosen;
}

}  // namespace

void choose_four(const Candidates& all, Vec3 normal, Manifold& out) {
  const double extent = extent_of(all);
  const Candidates found = without_twins(all, kSamePoint * extent);
  out.normal = normal;
  out.count = 0;
  const auto keep = [&](int i) { out.points[out.count++] = found.points[i]; };
  if (found.count <= 4) {
    for (int i = 0; i < found.count; ++i) keep(i);
    return;
  }

  const double better = kBetter * extent, better_area = better * extent;
  keep(best(found, better, [](const Point& p) { return -p.separation; }));
  const Vec3 a = place(out.points[0]);
  keep(best(found, better, [&](const Point& p) { return distance(place(p), a); }));
  const Vec3 b = place(out.points[1]);
  const auto area = [&](Vec3 p, Vec3 q, Vec3 r) { return dot(cross(q - p, r - p), normal); };
  const int third = best(found, better_area, [&](const Point& p) { return std::abs(area(a, b, place(p))); });
  if (std::abs(area(a, b, place(found.points[third]))) <= better_area) return;  // all on one line
  keep(third);
  const Vec3 c = place(out.points[2]);
  const double side = area(a, b, c) > 0 ? 1 : -1;
  // What a point adds is the triangle outside the side that it looks at.
  const auto added = [&](const Point& p) {
    return -std::min({side * area(a, b, place(p)), side * area(b, c, place(p)), side * area(c, a, place(p))});
  };
  const int fourth = best(found, better_area, added);
  if (added(found.points[fourth]) > better_area) keep(fourth);
}

bool clip(const Convex& a, const Pose& pose_a, const Convex& b, const Pose& pose_b, Vec3 normal, double margin, Manifold& out) {
  Candidates found;
  overlap(supporting_feature({a, pose_a}, -normal), supporting_feature({b, pose_b}, normal), normal, margin, kAnyhow, found);
  choose_four(found, normal, out);
  return out.count > 0;
}

}  // namespace tumble::pairs
