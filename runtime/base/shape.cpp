#include "base/shape.h"

#include <algorithm>

namespace tumble {

const EnumNames& enum_names(ShapeKind) {
  static const EnumNames names = {"box",   "sphere", "capsule", "cylinder", "cone",        "pyramid",
                                  "plane", "torus",  "hull",    "mesh",     "height_field"};
  return names;
}

void describe(Shape& shape, Schema& s) {
  s.name("shape", "A shape for a mesh, a collider, a cast or a drawing; axis y, centred, 1 m by default.");
  s.main("shape");
  s.add("shape", shape.shape, "Which shape; it reads only the fields that are its own.");
  s.add("size", shape.size, "Edge lengths of a box, a pyramid, a plane (x and z) or a height field, m; a model has its own.").above(0);
  s.add("radius", shape.radius, "Of a sphere, capsule, cylinder, cone; of a torus, from the centre to the middle of its tube, m.").above(0);
  s.add("height", shape.height, "Of a capsule, cylinder or cone over all, rounded ends included, m.").above(0);
  s.add("thickness", shape.thickness, "Of a torus: the diameter of its tube, m.").above(0);
  s.add("file", shape.file, "The glTF model of a mesh or hull (.glb, .gltf), or the picture whose brightness is a height field; with nothing but a file the shape is a mesh.");
  s.add("points", shape.points, "Corner points of a hull, m.");
  s.check<Shape>([](const Shape& given) {
    const ShapeKind kind = given.shape;
    if (given.file.empty() || kind == ShapeKind::box || kind == ShapeKind::hull || kind == ShapeKind::mesh || kind == ShapeKind::height_field) return;
    fail("file belongs to a mesh, a hull or a height_field (got shape '", enum_names(kind)[static_cast<std::size_t>(kind)], "'); leave one of the two out");
  });
}

Shape scaled(const Shape& shape, Vec3 scale) {
  Shape result = shape;
  const double across = std::max(scale.x, scale.z);
  result.size = scaled(shape.size, scale);
  switch (shape.shape) {
    case ShapeKind::sphere: result.radius *= std::max(across, scale.y); break;
    case ShapeKind::torus: result.radius *= across; result.thickness *= std::max(across, scale.y); break;
    case ShapeKind::capsule:
    case ShapeKind::cylinder:
    case ShapeKind::cone: result.radius *= across; result.height *= scale.y; break;
    default: break;
  }
  if (shape.shape == ShapeKind::capsule) result.height = std::max(result.height, 2 * result.radius);
  for (Vec3& point : result.points) point = scaled(point, scale);
  return result;
}

Vec3 half_extents(const Shape& shape) {
  switch (shape.shape) {
    case ShapeKind::sphere: return {shape.radius, shape.radius, shape.radius};
    case ShapeKind::capsule:
    case ShapeKind::cylinder:
    case ShapeKind::cone: return {shape.radius, shape.height / 2, shape.radius};
    case ShapeKind::torus: {
      const double out = shape.radius + shape.thickness / 2;
      return {out, shape.thickness / 2, out};
    }
    case ShapeKind::plane: return {shape.size.x / 2, 0, shape.size.z / 2};
    case ShapeKind::mesh:
    case ShapeKind::height_field:
      if (shape.points.empty()) return shape.size / 2;
      [[fallthrough]];
    case ShapeKind::hull: {
      Vec3 half;
      for (const Vec3& p : shape.points)
        half = {std::max(half.x, std::abs(p.x)), std::max(half.y, std::abs(p.y)), std::max(half.z, std::abs(p.z))};
      return half;
    }
    default: return shape.size / 2;
  }
}

}  // namespace tumble
