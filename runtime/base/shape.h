// One vocabulary of shapes, for meshes, colliders, casts, overlaps and drawing. Axis y, centred on the origin.
#pragma once

#include <string>
#include <vector>

#include "base/describe.h"

namespace tumble {

enum class ShapeKind { box, sphere, capsule, cylinder, cone, pyramid, plane, torus, hull, mesh, height_field };
const EnumNames& enum_names(ShapeKind);

// A shape's size in metres. Each kind reads only its own fields: box, pyramid, plane and height_field `size`; sphere
// `radius`; capsule, cylinder and cone `radius` and `height` (over all, caps included); torus `radius` (centre to the
// middle of the tube) and `thickness` (the tube's diameter); hull `file` or `points`; mesh and height_field `file`.
struct Shape {
  ShapeKind shape = ShapeKind::box;
  Vec3 size{1, 1, 1};
  double radius = 0.5;
  double height = 1;
  double thickness = 0.1;
  std::string file;
  std::vector<Vec3> points;

  bool operator==(const Shape&) const = default;
};
void describe(Shape& shape, Schema& s);

// The shape stretched by a node's scale (each component above 0): a sphere takes the largest component, round shapes
// the larger of x and z across and y along, since they stay round. So no collider ever is smaller than what is seen.
Shape scaled(const Shape& shape, Vec3 scale);
// Half the size of the box around it.
Vec3 half_extents(const Shape& shape);

}  // namespace tumble
