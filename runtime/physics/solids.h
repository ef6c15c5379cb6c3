// Volume, centre and inertia of each shape as a solid, by exact formulas.
#pragma once

#include <array>
#include <vector>

#include "base/shape.h"

namespace tumble {

// Of unit density, so that volume is also the mass.
struct Solid {
  double volume = 0;                             // m^3; 0 of mesh and height_field
  Vec3 center;                                   // in the shape's frame
  std::array<std::array<double, 3>, 3> inertia{};  // about the centre, axes of the shape
};
Solid solid_of(const Shape& shape);

// A plane collider is a box of this thickness below its surface, m.
double plane_thickness(const Shape& plane);
// Corners of the base first, then the apex.
std::vector<Vec3> pyramid_points(const Shape& pyramid);

struct Triangle {
  Vec3 a, b, c;  // counter-clockwise seen from outside
};
// Triangles of the smallest convex shape around the points; none where they lie in one plane.
std::vector<Triangle> convex_hull(const std::vector<Vec3>& points);

}  // namespace tumble
