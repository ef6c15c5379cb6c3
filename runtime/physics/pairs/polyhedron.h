// A convex solid with flat faces, with what is asked of it for contacts: its polygons and its edges.
#pragma once

#include <vector>

#include "physics/solids.h"

namespace tumble::pairs {

struct Polyhedron {
  struct Face {
    Vec3 normal;            // outward, of length 1
    double offset = 0;      // the solid is where dot(normal, p) <= offset
    int first = 0, count = 0;  // in loops: its vertices, counter-clockwise seen from outside
  };
  struct Edge {
    int from = 0, to = 0;     // vertices, in the order in which `left` goes round
    int left = 0, right = 0;  // faces
  };
  std::vector<Vec3> vertices;
  std::vector<Face> faces;
  std::vector<int> loops;
  std::vector<Edge> edges;
  Vec3 center;                // within it: the mean of the vertices
};

// From the triangles of a convex hull, counter-clockwise seen from outside. Triangles in one plane, within 1e-6 of its
// size, become one polygon; corners within a straight edge go.
Polyhedron make_polyhedron(const std::vector<Triangle>& hull);
// Centred on the origin.
Polyhedron make_box_polyhedron(Vec3 half);

}  // namespace tumble::pairs
