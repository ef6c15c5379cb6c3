#include "accuracy/cases/queries/grounds.h"

namespace tumble::accuracy {

namespace {

void add_quad(Shape& shape, Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  for (const Vec3& p : {a, b, c, a, c, d}) shape.points.push_back(p);
}

}  // namespace

Shape tiled(ShapeKind kind, int half, const std::function<double(double, double)>& height) {
  Shape shape;
  shape.shape = kind;
  const auto point = [&](double x, double z) { return Vec3{x, height(x, z), z}; };
  for (int x = -half; x < half; ++x)
    for (int z = -half; z < half; ++z) add_quad(shape, point(x, z), point(x, z + 1), point(x + 1, z + 1), point(x + 1, z));
  return shape;
}

Shape tiled(ShapeKind kind, int half) {
  return tiled(kind, half, [](double, double) { return 0.0; });
}

Shape tiled_with_t_junctions(int half) {
  Shape shape;
  shape.shape = ShapeKind::mesh;
  for (int z = -half; z < half; ++z)
    for (int i = -half; i < half; ++i) {
      const double x = i + (z % 2 == 0 ? 0.0 : 0.5);
      add_quad(shape, {x, 0, double(z)}, {x, 0, z + 1.0}, {x + 1, 0, z + 1.0}, {x + 1, 0, double(z)});
    }
  return shape;
}

}  // namespace tumble::accuracy
