// The direction and the points at which two convex shapes of any kind are nearest, or least deep in one another.
#pragma once

#include "physics/pairs/convex.h"

namespace tumble::pairs {

struct Nearest {
  Vec3 normal;          // of length 1, from b to a
  Vec3 on_a, on_b;      // world
  double separation = 0;
};

// A point of the Minkowski difference a - b of the shapes' cores, and where it comes from.
struct Difference {
  Vec3 at, on_a, on_b;
};
// Up to four of them, and how the point nearest to the origin is mixed from them.
struct Simplex {
  int count = 0;
  Difference points[4];
  double weights[4] = {};
};
Difference difference(const Placed& a, const Placed& b, Vec3 direction);

// False where they are apart by more than the margin. `start` is a direction from b to a to begin with, the normal of
// the pass before or zero. Between cores the search is by Gilbert, Johnson and Keerthi; what it finds is within about
// 1e-10 of the size for flat faces, and of the normal's cosine for round ones.
bool nearest(const Placed& a, const Placed& b, double margin, Vec3 start, Nearest& out);

// For cores that overlap, by an expanding polytope: the least deep direction. False where the cores are flat and in one
// plane.
bool penetration(const Placed& a, const Placed& b, const Simplex& start, Nearest& out);

}  // namespace tumble::pairs
