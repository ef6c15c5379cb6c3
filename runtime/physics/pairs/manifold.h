// Where two convex shapes touch along a known normal: up to four points.
#pragma once

#include "physics/pairs/feature.h"

namespace tumble::pairs {

struct Point {
  Vec3 on_a, on_b;             // world, on the two surfaces, one behind the other along the normal
  double separation = 0;       // dot(on_a - on_b, normal), m: negative where they overlap
  std::uint32_t feature = 0;   // of which corners or edges it came: the same from pass to pass
};
struct Manifold {
  Vec3 normal;                 // of length 1, world, from b to a
  int count = 0;
  Point points[4];
};

// All points before the choice of four.
struct Candidates {
  static constexpr int kMost = 2 * Feature::kMost + 1;
  int count = 0;
  Point points[kMost];
  void add(const Point& point) {
    if (count < kMost) points[count++] = point;
  }
};

constexpr double kAnyhow = 1e300;  // m
// The corners of what both features cover, seen along the normal, that are no further apart than the margin. The features
// are treated alike, so that swapping a and b changes nothing. A polygon seen too much from its edge gives nothing, nor do
// two segments along each other that lie, seen so, further `beside` each other than that, m.
void overlap(const Feature& a, const Feature& b, Vec3 normal, double margin, double beside, Candidates& found);

bool edge_on(const Feature& feature, Vec3 normal);

// The deepest point, the furthest from it, the one of the largest triangle, the one that adds most to that. Ties fall to
// the first, so that noise does not change the choice.
void choose_four(const Candidates& found, Vec3 normal, Manifold& out);

// Both for the supporting features; false where nothing is within the margin.
bool clip(const Convex& a, const Pose& pose_a, const Convex& b, const Pose& pose_b, Vec3 normal, double margin, Manifold& out);

}  // namespace tumble::pairs
