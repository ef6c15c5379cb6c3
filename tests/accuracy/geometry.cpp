#include "accuracy/geometry.h"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace tumble::accuracy {

namespace {

// A sphere is a point with a radius, a capsule a segment with a radius, a box a box without one.
bool is_round(const Shape& shape) { return shape.shape == ShapeKind::sphere || shape.shape == ShapeKind::capsule; }
bool is_simple(const Shape& shape) { return is_round(shape) || shape.shape == ShapeKind::box; }
double half_segment(const Shape& shape) { return shape.shape == ShapeKind::capsule ? shape.height / 2 - shape.radius : 0; }

struct Segment {
  Vec3 from, to;
  Vec3 at(double t) const { return lerp(from, to, t); }
};
Segment core(const Solid& solid) {
  const Vec3 half{0, half_segment(solid.shape), 0};
  return {solid.pose * -half, solid.pose * half};
}

// Ericson, Real-Time Collision Detection, 5.1.9.
double distance_between(const Segment& p, const Segment& q) {
  const Vec3 u = p.to - p.from, v = q.to - q.from, w = p.from - q.from;
  const double a = dot(u, u), e = dot(v, v), b = dot(u, v), c = dot(u, w), f = dot(v, w);
  constexpr double kPoint = 1e-18;
  double s = 0, t = 0;
  if (a > kPoint && e > kPoint) {
    const double denominator = a * e - b * b;
    if (denominator > 1e-12 * a * e) s = std::clamp((b * f - c * e) / denominator, 0.0, 1.0);
    t = (b * s + f) / e;
    if (t < 0 || t > 1) {
      t = std::clamp(t, 0.0, 1.0);
      s = std::clamp((b * t - c) / a, 0.0, 1.0);
    }
  } else if (a > kPoint) {
    s = std::clamp(-c / a, 0.0, 1.0);
  } else if (e > kPoint) {
    t = std::clamp(f / e, 0.0, 1.0);
  }
  return distance(p.at(s), q.at(t));
}

// Of a point in the box's frame.
double distance_to_box(Vec3 p, Vec3 half) {
  return length(Vec3{std::max(0.0, std::abs(p.x) - half.x), std::max(0.0, std::abs(p.y) - half.y), std::max(0.0, std::abs(p.z) - half.z)});
}

// The distance along a segment is convex: a golden section finds the least.
double distance_to_box(const Segment& s, Vec3 half) {
  constexpr double kGolden = 0.6180339887498949;
  double low = 0, high = 1;
  double t1 = high - kGolden, t2 = low + kGolden;
  double d1 = distance_to_box(s.at(t1), half), d2 = distance_to_box(s.at(t2), half);
  for (int i = 0; i < 50; ++i) {
    if (d1 <= d2) {
      high = t2;
      t2 = t1;
      d2 = d1;
      t1 = high - kGolden * (high - low);
      d1 = distance_to_box(s.at(t1), half);
    } else {
      low = t1;
      t1 = t2;
      d1 = d2;
      t2 = low + kGolden * (high - low);
      d2 = distance_to_box(s.at(t2), half);
    }
  }
  return std::min({d1, d2, distance_to_box(s.from, half), distance_to_box(s.to, half)});
}

std::array<Vec3, 3> axes_of(Quat rotation) { return {rotation * Vec3{1, 0, 0}, rotation * Vec3{0, 1, 0}, rotation * Vec3{0, 0, 1}}; }

// Separating axes: the least overlap over the faces' normals and the products of edges is the depth; below 0 they are
// apart. A capsule's core is a box without width.
struct OrientedBox {
  Vec3 center, half;
  std::array<Vec3, 3> axes;
  double along(Vec3 n) const { return half.x * std::abs(dot(axes[0], n)) + half.y * std::abs(dot(axes[1], n)) + half.z * std::abs(dot(axes[2], n)); }
};
OrientedBox core_box(const Solid& solid) {
  const Vec3 half = is_round(solid.shape) ? Vec3{0, half_segment(solid.shape), 0} : solid.shape.size / 2;
  return {solid.pose.position, half, axes_of(solid.pose.rotation)};
}
double least_overlap(const OrientedBox& a, const OrientedBox& b) {
  double least = INFINITY;
  const auto try_axis = [&](Vec3 axis) {
    const double l = length(axis);
    if (l < 1e-9) return;
    const Vec3 n = axis / l;
    least = std::min(least, a.along(n) + b.along(n) - std::abs(dot(b.center - a.center, n)));
  };
  for (const Vec3& axis : a.axes) try_axis(axis);
  for (const Vec3& axis : b.axes) try_axis(axis);
  for (const Vec3& p : a.axes)
    for (const Vec3& q : b.axes) try_axis(cross(p, q));
  return least;
}

double round_and_box(const Solid& round, const Solid& box) {
  const Pose local = inverse(box.pose);
  const Segment s = core(round);
  const double apart = distance_to_box(Segment{local * s.from, local * s.to}, box.shape.size / 2);
  if (apart > 0) return round.shape.radius - apart;
  return round.shape.radius + std::max(0.0, least_overlap(core_box(round), core_box(box)));
}

// ---- any two convex solids: the depth is the least over all directions of how far a reaches beyond b along it, the height
// of the convex set of all differences a - b over the origin. Where that is least, the set has a flat, a rim or a smooth
// place: known from the points of it that lie furthest along directions nearby.

// How far the set reaches along n, and where.
struct Reach {
  Vec3 point;
  double height = 0;
};
Reach furthest_difference(const Solid& a, const Solid& b, Vec3 n) {
  const Vec3 point = support(a, n) - support(b, -n);
  return {point, dot(point, n)};
}

class Descent {
 public:
  Descent(const Solid& a, const Solid& b, Vec3 start) : a_(&a), b_(&b), best_(start), least_(furthest_difference(a, b, start).height) {}
  // Looks at the directions within `cone` radians, and then nearer and nearer. Ends where the solids are seen to be apart.
  void run(double cone, double nearest) {
    for (int i = 0; i < kMost && cone > nearest && least_ > 0; ++i)
      if (!step(cone)) cone /= 3;
  }
  Vec3 best() const { return best_; }
  double least() const { return least_; }

 private:
  static constexpr int kMost = 100, kAround = 8;

  bool step(double cone) {
    std::vector<Vec3>& points = points_;
    points.clear();
    const auto see = [&](Vec3 n) {
      const Reach there = furthest_difference(*a_, *b_, n);
      if (there.height < least_) least_ = there.height, best_ = n;
      if (std::none_of(points.begin(), points.end(), [&](Vec3 other) { return distance(there.point, other) < 1e-9; })) points.push_back(there.point);
    };
    const Vec3 middle = best_, side = normalized(cross(middle, std::abs(middle.x) < 0.7 ? Vec3{1, 0, 0} : Vec3{0, 1, 0})), other = cross(middle, side);
    const double before = least_;
    see(middle);
    for (int i = 0; i < kAround; ++i) {
      const double angle = (i + cone) * 2 * kPi / kAround;
      const Vec3 n = normalized(middle + (side * std::cos(angle) + other * std::sin(angle)) * cone);
      see(n);
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      offer(points[i], middle, 2 * cone);  // square to a smooth place
      for (std::size_t j = 0; j < i; ++j) {
        const Vec3 edge = points[i] - points[j];
        offer(points[i] - edge * (dot(points[i], edge) / dot(edge, edge)), middle, 2 * cone);  // to a rim
        for (std::size_t k = 0; k < j; ++k) offer(cross(edge, points[k] - points[j]), middle, 2 * cone);  // to a flat
      }
    }
    return least_ < before - 1e-12;
  }

  void offer(Vec3 direction, Vec3 middle, double cone) {
    const double size = length(direction);
    if (!(size > 1e-12)) return;
    const Vec3 n = dot(direction, middle) < 0 ? -direction / size : direction / size;
    if (distance(n, middle) > cone) return;
    for (const Vec3& point : points_)
      if (dot(point, n) >= least_) return;
    const double height = furthest_difference(*a_, *b_, n).height;
    if (height >= least_) return;
    least_ = height;
    best_ = n;
  }

  const Solid *a_, *b_;
  Vec3 best_;
  double least_;
  std::vector<Vec3> points_;  // of the set, seen nearby
};

// From the best of the directions in which solids mostly touch: coarsely from each, then finely from the best two. Where the
// first leads to a depth of next to nothing, no other can tell of less.
double searched_depth(const Solid& a, const Solid& b) {
  constexpr std::size_t kStarts = 8, kFine = 2;
  constexpr double kCone = 0.3, kCoarse = 0.01, kNearest = 1e-7, kNothing = 1e-4;  // radians; m
  std::vector<Descent> starts;
  const auto add = [&](Vec3 direction) {
    if (length(direction) > 1e-9) starts.emplace_back(a, b, normalized(direction));
  };
  add(b.pose.position - a.pose.position);
  const auto axes_a = axes_of(a.pose.rotation), axes_b = axes_of(b.pose.rotation);
  for (const auto& axes : {axes_a, axes_b})
    for (int x = -1; x <= 1; ++x)
      for (int y = -1; y <= 1; ++y)
        for (int z = -1; z <= 1; ++z) add(axes[0] * x + axes[1] * y + axes[2] * z);
  for (const Vec3& p : axes_a)
    for (const Vec3& q : axes_b) add(cross(p, q)), add(cross(q, p));
  const auto better = [](const Descent& p, const Descent& q) { return p.least() < q.least(); };
  std::sort(starts.begin(), starts.end(), better);
  std::vector<Descent> chosen;
  for (Descent& start : starts) {
    const bool known = std::any_of(chosen.begin(), chosen.end(), [&](const Descent& other) { return distance(other.best(), start.best()) < kCone / 2; });
    if (known || start.least() <= 0) continue;
    start.run(kCone, chosen.empty() ? kNearest : kCoarse);
    if (start.least() < kNothing) return std::max(0.0, start.least());
    chosen.push_back(start);
    if (chosen.size() == kStarts) break;
  }
  if (starts.empty() || starts.front().least() <= 0) return 0;
  std::sort(chosen.begin(), chosen.end(), better);
  double least = INFINITY;
  for (std::size_t i = 0; i < std::min(kFine, chosen.size()); ++i) {
    chosen[i].run(kCoarse, kNearest);
    least = std::min(least, chosen[i].least());
  }
  return least;
}

}  // namespace

Vec3 support(const Solid& solid, Vec3 direction) {
  const Shape& s = solid.shape;
  const Vec3 d = conjugate(solid.pose.rotation) * direction;
  const double across = std::hypot(d.x, d.z);
  const Vec3 rim = across > 1e-12 ? Vec3{s.radius * d.x / across, 0, s.radius * d.z / across} : Vec3{};
  const auto place = [&](Vec3 local) { return solid.pose * local; };
  switch (s.shape) {
    case ShapeKind::sphere: return place(normalized(d) * s.radius);
    case ShapeKind::capsule: return place(Vec3{0, std::copysign(half_segment(s), d.y), 0} + normalized(d) * s.radius);
    case ShapeKind::box: return place({std::copysign(s.size.x / 2, d.x), std::copysign(s.size.y / 2, d.y), std::copysign(s.size.z / 2, d.z)});
    case ShapeKind::cylinder: return place(rim + Vec3{0, std::copysign(s.height / 2, d.y), 0});
    case ShapeKind::cone:
    case ShapeKind::pyramid: {
      const bool cone = s.shape == ShapeKind::cone;
      const double half = (cone ? s.height : s.size.y) / 2;
      const Vec3 tip{0, half, 0};
      const Vec3 base = Vec3{0, -half, 0} + (cone ? rim : Vec3{std::copysign(s.size.x / 2, d.x), 0, std::copysign(s.size.z / 2, d.z)});
      return place(dot(tip, d) > dot(base, d) ? tip : base);
    }
    case ShapeKind::hull: {
      if (s.points.empty()) break;
      const Vec3* best = &s.points.front();
      double most = -INFINITY;
      for (const Vec3& point : s.points)
        if (const double along = dot(point, d); along > most) most = along, best = &point;
      return place(*best);
    }
    default: break;
  }
  throw std::invalid_argument("support: this shape is not convex");
}

Vec3 reach(const Solid& solid) {
  const Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, at = solid.pose.position;
  return {std::max(support(solid, x).x - at.x, at.x - support(solid, -x).x), std::max(support(solid, y).y - at.y, at.y - support(solid, -y).y),
          std::max(support(solid, z).z - at.z, at.z - support(solid, -z).z)};
}

bool overlap_is_exact(const Shape& a, const Shape& b) { return is_simple(a) && is_simple(b); }

double overlap_depth(const Solid& a, const Solid& b) {
  if (!overlap_is_exact(a.shape, b.shape)) return std::max(0.0, searched_depth(a, b));
  if (is_round(a.shape) && is_round(b.shape)) return std::max(0.0, a.shape.radius + b.shape.radius - distance_between(core(a), core(b)));
  if (is_round(a.shape)) return std::max(0.0, round_and_box(a, b));
  if (is_round(b.shape)) return std::max(0.0, round_and_box(b, a));
  return std::max(0.0, least_overlap(core_box(a), core_box(b)));
}

std::vector<Overlap> overlaps(const Simulation& scene, const std::vector<Placed>& bodies) {
  struct Entry {
    Solid solid;
    Vec3 low, high;
    const Placed* placed;
  };
  std::vector<Entry> entries;
  entries.reserve(bodies.size());
  for (const Placed& placed : bodies) {
    Entry entry{{placed.shape, scene.pose(placed.body)}, {}, {}, &placed};
    if (!is_finite(entry.solid.pose.position) || !is_finite(entry.solid.pose.rotation)) continue;
    const Vec3 extent = reach(entry.solid);
    entry.low = entry.solid.pose.position - extent;
    entry.high = entry.solid.pose.position + extent;
    entries.push_back(std::move(entry));
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.low.x < b.low.x; });
  std::vector<Overlap> found;
  for (std::size_t i = 0; i < entries.size(); ++i)
    for (std::size_t j = i + 1; j < entries.size() && entries[j].low.x < entries[i].high.x; ++j) {
      const Entry& a = entries[i];
      const Entry& b = entries[j];
      if (!a.placed->moves && !b.placed->moves) continue;
      if (a.low.y > b.high.y || b.low.y > a.high.y || a.low.z > b.high.z || b.low.z > a.high.z) continue;
      const double depth = overlap_depth(a.solid, b.solid);
      if (depth > 0) found.push_back({std::min(a.placed->body, b.placed->body), std::max(a.placed->body, b.placed->body), depth});
    }
  return found;
}

double deepest(const std::vector<Overlap>& overlaps) {
  double most = 0;
  for (const Overlap& overlap : overlaps) most = std::max(most, overlap.depth);
  return most;
}

double mean_depth(const std::vector<Overlap>& overlaps) {
  double sum = 0;
  for (const Overlap& overlap : overlaps) sum += overlap.depth;
  return overlaps.empty() ? 0 : sum / static_cast<double>(overlaps.size());
}

}  // namespace tumble::accuracy
