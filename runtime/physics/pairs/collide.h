// The contact points of two convex shapes, made anew at every look: all at once, also while they are still apart.
//
// Boxes, polyhedra and triangles go by separating axes, spheres and capsules by closed forms where there are, all else by
// the nearest points, whose direction is then set right to that of a face, cap or side within a thousandth of a radian.
#pragma once

#include "physics/pairs/manifold.h"
#include "physics/pairs/nearest.h"
#include "physics/pairs/separation.h"

namespace tumble::pairs {

// What one look at a pair leaves for the next; whoever keeps the pair keeps it.
struct Cache {
  Separation::Kind kind = Separation::none;
  Vec3 normal;  // zero: none known
};

// False, and no points, where the shapes are apart by more than the margin. Swapping a and b turns the normal and swaps
// the points' sides, nothing else. The margin only adds points: it changes neither normals nor distances.
//
// Triangles are taken for parts of a mesh: while apart, one gives no points towards a shape that it meets with its rim
// rather than its face (by more than 60 degrees), since its neighbour lies there and would stop what slides along both.
bool collide(const Convex& a, const Pose& pose_a, const Convex& b, const Pose& pose_b, double margin, Cache& cache, Manifold& out);

// The nearest points of both, or the shortest way out of an overlap; false where they are apart by more than `within`.
bool closest(const Convex& a, const Pose& pose_a, const Convex& b, const Pose& pose_b, double within, Nearest& out);

}  // namespace tumble::pairs
