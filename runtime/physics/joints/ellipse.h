// Where a point in a plane is nearest to the boundary of an ellipse around the origin.
#pragma once

namespace tumble {

struct Boundary {
  double inside = 0;                  // distance to the boundary, negative outside of it
  double normal_a = 0, normal_b = 0;  // outwards, of length 1
};
// Half axes above 0.
Boundary ellipse_boundary(double half_a, double half_b, double a, double b);

}  // namespace tumble
