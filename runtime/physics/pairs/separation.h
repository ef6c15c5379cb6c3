// The direction along which two shapes with flat faces are furthest apart, or least deep in one another, by the
// separating axis theorem: it is a face's normal or stands across an edge of each.
#pragma once

#include <cstdint>

#include "physics/pairs/convex.h"

namespace tumble::pairs {

struct Separation {
  enum Kind : std::uint8_t { none, face_a, face_b, edges };
  Kind kind = none;           // none: apart by more than the margin
  Vec3 normal;                // from b to a
  double distance = 0;        // along it, negative where they overlap; at most their true distance
  Vec3 edge_a[2], edge_b[2];  // the ends of the two edges, for kind edges
};

// Boxes, polyhedra and triangles. An edge direction is taken only if it is better than every face by 5 % and a
// hundred-thousandth of the size, and not nearly a face's: since faces give more points, and two planks that cross with a
// little tilt would lie on one; `before`, the kind that was found in the pass before,
// is kept while it is no worse than that, so that noise does not let the normal jump.
//
// Where the shapes are apart and nearest at two vertices, or a vertex and an edge, their distance is larger than what is
// found here: collide() sees it by no point of the found features lying that near and asks nearest() instead.
Separation separation(const Placed& a, const Placed& b, double margin, Separation::Kind before);
// The same for two boxes, by the closed form of 15 axes.
Separation box_separation(const Placed& a, const Placed& b, double margin, Separation::Kind before);

// Of face and edge candidates the one to take; a distance of -1e300 is no candidate.
Separation::Kind preferred(double face_a, double face_b, double edges, double size, Separation::Kind before);

// Is an edge direction so near to a face's, and so little better, that the face tells more?
bool nearly_same(Vec3 edges, double edges_distance, Vec3 face, double face_distance, double size);

bool has_flat_faces(const Convex& shape);

}  // namespace tumble::pairs
