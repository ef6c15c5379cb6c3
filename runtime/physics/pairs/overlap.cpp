#include <algorithm>

#include "physics/pairs/manifold.h"

namespace tumble::pairs {

namespace {

// Beyond this (cosine of the angle to the normal) a polygon is seen from its edge and its heights are no longer sure.
constexpr double kEdgeOn = 0.17;
// Segments that cross at a smaller angle (sine) lie along each other and touch at two points.
constexpr double kAlong = 0.01;

struct Flat {
  double x, y;
};
Flat operator-(Flat a, Flat b) { return {a.x - b.x, a.y - b.y}; }
Flat mix(Flat a, Flat b, double t) { return {a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t}; }
double cross(Flat a, Flat b) { return a.x * b.y - a.y * b.x; }
double dot(Flat a, Flat b) { return a.x * b.x + a.y * b.y; }
double length(Flat a) { return std::sqrt(dot(a, a)); }

// Axes across the normal; features are drawn in this plane, seen from where the normal points to.
struct View {
  Vec3 origin, u, v, normal;
  View(Vec3 from, Vec3 along) : origin(from), normal(along) {
    const Vec3 other = std::abs(along.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    u = normalized(tumble::cross(other, along));
    v = tumble::cross(along, u);
  }
  Flat flat(Vec3 p) const { return {tumble::dot(p - origin, u), tumble::dot(p - origin, v)}; }
  Vec3 point(Flat p, double height) const { return origin + u * p.x + v * p.y + normal * height; }
  double height(Vec3 p) const { return tumble::dot(p - origin, normal); }
};

// Height over the view's plane of a polygon's plane.
struct Slope {
  double base = 0, dx = 0, dy = 0;
  Slope(const View& view, const Feature& polygon) {
    const double facing = tumble::dot(polygon.normal, view.normal);
    dx = -tumble::dot(polygon.normal, view.u) / facing;
    dy = -tumble::dot(polygon.normal, view.v) / facing;
    const Flat first = view.flat(polygon.points[0]);
    base = view.height(polygon.points[0]) - dx * first.x - dy * first.y;
  }
  double at(Flat p) const { return base + dx * p.x + dy * p.y; }
};

// Without defaults: an outline is mostly unused, and filling it takes longer than using it.
struct Corner {
  Flat at;
  std::uint32_t tag;     // what it is: a corner of a or b, or a crossing
  std::uint32_t edge;    // that leaves it: the name of the edge's first corner
  bool edge_of_b;
};
struct Outline {
  int count = 0;
  Corner corners[2 * Feature::kMost];
  void add(const Corner& corner) {
    if (count < 2 * Feature::kMost) corners[count++] = corner;
  }
};

std::uint32_t corner_tag(bool of_b, std::uint32_t id) { return (of_b ? 2u << 30 : 1u << 30) | (id & 0x3fffffff); }
std::uint32_t crossing_tag(std::uint32_t edge_a, std::uint32_t edge_b) { return 3u << 30 | (edge_a & 0x7fff) << 15 | (edge_b & 0x7fff); }

// Counter-clockwise in the view; a's outside looks against the normal, so it is drawn backwards.
Outline draw(const View& view, const Feature& feature, bool of_b) {
  const bool backwards = tumble::dot(feature.normal, view.normal) < 0;
  Outline outline;
  for (int i = 0; i < feature.count; ++i) {
    const int k = backwards ? feature.count - 1 - i : i;
    outline.add({view.flat(feature.points[k]), corner_tag(of_b, feature.ids[k]), feature.ids[k], of_b});
  }
  return outline;
}

// Where the outgoing edge of `from` meets an edge of b.
Corner crossing(const Corner& from, const Corner& to, double d_from, double d_to, const Corner& edge, const Corner& before_edge) {
  Corner made = from;
  made.at = mix(from.at, to.at, d_from / (d_from - d_to));
  if (!from.edge_of_b) made.tag = crossing_tag(from.edge, edge.edge);
  // Two edges of b meet at a corner of b: at the start of the one that comes later, except at the last one's end.
  else made.tag = corner_tag(true, from.edge == before_edge.edge ? edge.edge : from.edge);
  return made;
}

// An edge of an outline and how far points are to its left.
struct Cut {
  Flat from, inward;
  Cut(const Corner& start, const Corner& end) : from(start.at), inward{start.at.y - end.at.y, end.at.x - start.at.x} {
    const double size = length(inward);
    if (size > 0) inward = {inward.x / size, inward.y / size};
  }
  double left(Flat p) const { return dot(p - from, inward); }
};

// What of the outline lies left of b's edge (Sutherland and Hodgman).
void cut(const Outline& outline, const Outline& b, int edge, double near, Outline& kept) {
  const Corner &start = b.corners[edge], &end = b.corners[(edge + 1) % b.count], &before = b.corners[(edge + b.count - 1) % b.count];
  const Cut along(start, end);
  kept.count = 0;
  double d_to = along.left(outline.corners[0].at);
  const double d_first = d_to;
  for (int i = 0; i < outline.count; ++i) {
    const bool last = i + 1 == outline.count;
    const Corner &from = outline.corners[i], &to = outline.corners[last ? 0 : i + 1];
    const double d_from = d_to;
    d_to = last ? d_first : along.left(to.at);
    const bool in_from = d_from >= -near, in_to = d_to >= -near;
    if (in_from) kept.add(from);
    if (in_from == in_to) continue;
    Corner corner = crossing(from, to, d_from, d_to, start, before);
    if (in_from) corner.edge = start.edge, corner.edge_of_b = true;
    kept.add(corner);
  }
}

double extent(const Outline& outline) {
  double most = 0;
  for (int i = 1; i < outline.count; ++i) most = std::max(most, length(outline.corners[i].at - outline.corners[0].at));
  return most;
}

void add(const View& view, Flat at, double height_a, double height_b, std::uint32_t tag, double margin, Candidates& found) {
  const double separation = height_a - height_b;
  if (separation <= margin) found.add({view.point(at, height_a), view.point(at, height_b), separation, tag});
}

void polygon_polygon(const View& view, const Feature& a, const Feature& b, double margin, Candidates& found) {
  Outline first = draw(view, a, false), second;
  const Outline other = draw(view, b, true);
  const double near = 1e-9 * std::max(extent(first), extent(other));
  Outline *now = &first, *next = &second;
  for (int i = 0; i < other.count && now->count > 0; ++i) {
    cut(*now, other, i, near, *next);
    std::swap(now, next);
  }
  const Outline& outline = *now;
  const Slope slope_a(view, a), slope_b(view, b);
  for (int i = 0; i < outline.count; ++i) {
    const Corner& corner = outline.corners[i];
    add(view, corner.at, slope_a.at(corner.at), slope_b.at(corner.at), corner.tag, margin, found);
  }
}

// A segment, or a point as a segment of no length, over a polygon.
void segment_polygon(const View& view, const Feature& segment, const Feature& polygon, bool polygon_is_b, double margin,
                     Candidates& found) {
  const Outline outline = draw(view, polygon, polygon_is_b);
  const Vec3 p = segment.points[0], q = segment.points[segment.count - 1];
  const Flat from = view.flat(p), to = view.flat(q);
  const double near = 1e-9 * std::max(extent(outline), length(to - from));
  double enter = 0, leave = 1;
  std::uint32_t tag_enter = corner_tag(!polygon_is_b, segment.ids[0]);
  std::uint32_t tag_leave = corner_tag(!polygon_is_b, segment.ids[segment.count - 1]);
  for (int i = 0; i < outline.count; ++i) {
    const Corner &start = outline.corners[i], &end = outline.corners[i + 1 == outline.count ? 0 : i + 1];
    const Cut along(start, end);
    const double d_from = along.left(from), d_to = along.left(to);
    if (d_from < -near && d_to < -near) return;
    if (d_from >= -near && d_to >= -near) continue;
    const double t = std::clamp(d_from / (d_from - d_to), 0.0, 1.0);
    if (d_from < d_to && t > enter) enter = t, tag_enter = crossing_tag(segment.ids[0], start.edge);
    if (d_from > d_to && t < leave) leave = t, tag_leave = crossing_tag(segment.ids[1], start.edge);
  }
  if (enter > leave) return;

  const Slope slope(view, polygon);
  const auto put = [&](double t, std::uint32_t tag) {
    const Flat at = mix(from, to, t);
    const double own = view.height(lerp(p, q, t)), other = slope.at(at);
    add(view, at, polygon_is_b ? own : other, polygon_is_b ? other : own, tag, margin, found);
  };
  put(enter, tag_enter);
  if (leave > enter) put(leave, tag_leave);
}

struct Span {
  Flat from, along;
  double low = 0, rise = 0;  // height at the start, and gained over the length
  Span(const View& view, const Feature& segment)
      : from(view.flat(segment.points[0])),
        along(view.flat(segment.points[1]) - from),
        low(view.height(segment.points[0])),
        rise(view.height(segment.points[1]) - low) {}
  Flat at(double t) const { return mix(from, {from.x + along.x, from.y + along.y}, t); }
};

void segment_segment(const View& view, const Feature& a, const Feature& b, double margin, double beside, Candidates& found) {
  const Span s(view, a), t(view, b);
  const double ss = dot(s.along, s.along), tt = dot(t.along, t.along), turn = cross(s.along, t.along);
  if (ss <= 0 || tt <= 0) return;
  const Flat between = t.from - s.from;
  if (std::abs(turn) > kAlong * std::sqrt(ss * tt)) {
    const double p = cross(between, t.along) / turn, q = cross(between, s.along) / turn;
    if (p < -1e-9 || p > 1 + 1e-9 || q < -1e-9 || q > 1 + 1e-9) return;
    return add(view, s.at(p), s.low + s.rise * p, t.low + t.rise * q, crossing_tag(a.ids[0], b.ids[0]), margin, found);
  }

  // Along each other: the two ends of what both cover, each halfway between the two lines.
  if (std::abs(cross(between, s.along)) > beside * std::sqrt(ss)) return;
  const double first = dot(between, s.along) / ss, second = first + dot(t.along, s.along) / ss;
  const double enter = std::max(0.0, std::min(first, second)), leave = std::min(1.0, std::max(first, second));
  if (enter > leave) return;
  const auto put = [&](double p, std::uint32_t tag) {
    const double q = std::clamp((p - first) / (second - first), 0.0, 1.0);
    add(view, mix(s.at(p), t.at(q), 0.5), s.low + s.rise * p, t.low + t.rise * q, tag, margin, found);
  };
  put(enter, crossing_tag(a.ids[0], b.ids[0]));
  if (leave > enter) put(leave, crossing_tag(a.ids[1], b.ids[1]));
}

}  // namespace

bool edge_on(const Feature& feature, Vec3 normal) { return feature.count > 2 && std::abs(dot(feature.normal, normal)) < kEdgeOn; }

void overlap(const Feature& a, const Feature& b, Vec3 normal, double margin, double beside, Candidates& found) {
  if (edge_on(a, normal) || edge_on(b, normal)) return;
  const View view(b.points[0], normal);
  if (a.count > 2 && b.count > 2) polygon_polygon(view, a, b, margin, found);
  else if (b.count > 2) segment_polygon(view, a, b, true, margin, found);
  else if (a.count > 2) segment_polygon(view, b, a, false, margin, found);
  else if (a.count == 2 && b.count == 2) segment_segment(view, a, b, margin, beside, found);
}

}  // namespace tumble::pairs
