// What of a shape may touch something that lies in a direction: a polygon, a segment or a point of its surface.
#pragma once

#include <cstdint>

#include "physics/pairs/convex.h"

namespace tumble::pairs {

struct Feature {
  static constexpr int kMost = 16;  // a face with more corners gives every second, third ... of them
  int count = 0;                    // 1 a point, 2 a segment, more a polygon, counter-clockwise seen from outside
  Vec3 points[kMost];               // world
  std::uint32_t ids[kMost];         // of each, the same from pass to pass
  Vec3 normal;                      // of a polygon, outward
};

// The flat part that faces the direction (of length 1) best, where the shape has one: a box's or polyhedron's face; a
// triangle from the side that faces it; a cylinder's cap or a cone's base as an octagon of points of their rims, if they
// face it within 45 degrees, with a corner at the rim's furthest point. Else the segment of a side, or a point. The
// furthest point in the direction always is a corner.
Feature supporting_feature(const Placed& placed, Vec3 direction);

// The edge or side that contains the furthest point if it is nearly across the direction, else that point alone: for
// directions that are no face's normal.
Feature supporting_edge(const Placed& placed, Vec3 direction);

}  // namespace tumble::pairs
