// Closed forms for shapes that are a point or a segment with a rounding.
#pragma once

#include "physics/pairs/nearest.h"

namespace tumble::pairs {

// True where there is a closed form for a and b in this order: spheres with spheres, capsules, boxes and triangles, and
// capsules with capsules. `out` is then the nearest points, however far.
bool nearest_of_round(const Placed& a, const Placed& b, Nearest& out);

// Of two segments, as parts of their lengths. Of parallel ones the middle of where they lie beside each other.
struct Parameters {
  double first = 0, second = 0;
};
Parameters nearest_of_segments(Vec3 a0, Vec3 a1, Vec3 b0, Vec3 b1);

}  // namespace tumble::pairs
