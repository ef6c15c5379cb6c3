#include <LinearMath/btConvexHullComputer.h>

#include "physics/bullet/convert.h"
#include "physics/solids.h"

namespace tumble {

std::vector<Triangle> convex_hull(const std::vector<Vec3>& points) {
  std::vector<btVector3> input;
  for (const Vec3& p : points) input.push_back(to_bullet(p));
  if (input.size() < 4) return {};
  btConvexHullComputer hull;
  hull.compute(&input[0].m_floats[0], static_cast<int>(sizeof(btVector3)), static_cast<int>(input.size()), 0, 0);

  // Bullet computes on a grid of about 1e-4 of the size: only the choice of corners is taken from it.
  const auto corner = [&](int vertex) { return points[static_cast<std::size_t>(hull.original_vertex_index[vertex])]; };
  std::vector<Triangle> triangles;
  for (int f = 0; f < hull.faces.size(); ++f) {
    // A fan around each face's first corner.
    const btConvexHullComputer::Edge* first = &hull.edges[hull.faces[f]];
    const Vec3 a = corner(first->getSourceVertex());
    for (const auto* edge = first->getNextEdgeOfFace(); edge->getTargetVertex() != first->getSourceVertex();
         edge = edge->getNextEdgeOfFace())
      triangles.push_back({a, corner(edge->getSourceVertex()), corner(edge->getTargetVertex())});
  }
  double volume = 0;
  for (const Triangle& t : triangles) volume += dot(t.a - triangles[0].a, cross(t.b - triangles[0].a, t.c - triangles[0].a));
  if (volume < 0)
    for (Triangle& t : triangles) std::swap(t.b, t.c);
  return triangles;
}

}  // namespace tumble
