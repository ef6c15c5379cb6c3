// The colliders of a body as Bullet's shapes.
//
// Bullet wants a body's frame to be its centre of mass with principal axes; `frame` is that frame in the body's.
#pragma once

#include <memory>
#include <vector>

#include "physics/body.h"
#include "physics/bullet/convert.h"
#include "physics/pairs/polyhedron.h"
#include "physics/rays.h"

namespace tumble {

// One convex part, or a triangle mesh, of a collider.
struct Piece {
  const btCollisionShape* shape = nullptr;
  btTransform local;   // in Bullet's frame of the body
  int collider = 0;
  const std::vector<Plane>* planes = nullptr;  // of a hull
};

// A single convex shape by itself, for casts and overlaps; several for a torus.
struct ShapeParts {
  std::vector<std::unique_ptr<btCollisionShape>> shapes;
  std::vector<Pose> poses;                                // of each in the shape's frame
  std::unique_ptr<btTriangleIndexVertexArray> triangles;  // of a mesh
  std::vector<Plane> planes;                              // of a hull; Bullet's own are off by 1e-4 and welded
  pairs::Polyhedron solid;                                // of a hull, whose user pointer it is
  std::vector<btVector3> vertices;
  std::vector<int> indices;
};
// Throws Error where a shape has nothing to stand on: a hull without points, a mesh without triangles.
std::unique_ptr<ShapeParts> make_parts(const Shape& shape);

class ShapeSet {
 public:
  // The colliders that are triggers, or those that are not.
  ShapeSet(const BodyDef& def, bool triggers, const Pose& frame);
  bool empty() const { return pieces_.empty(); }
  btCollisionShape* root() { return root_; }
  const std::vector<Piece>& pieces() const { return pieces_; }
  // The collider of a contact point, from the identifiers that Bullet keeps in it.
  int collider_of(int part, int index) const;

 private:
  std::vector<std::unique_ptr<ShapeParts>> parts_;
  std::vector<Piece> pieces_;
  std::unique_ptr<btCompoundShape> compound_;
  btCollisionShape* root_ = nullptr;
};

// Of a ball about the centre of mass that lies in the body, or a lower bound of it, m: how far it may move in a step.
double inner_radius(const BodyDef& def);

}  // namespace tumble
