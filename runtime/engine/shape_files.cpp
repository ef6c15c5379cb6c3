#include "engine/shape_files.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/error.h"
#include "physics/solids.h"

namespace tumble {

namespace {

constexpr double kThin = 0.01;  // m, of a flat model's hull

void keep_each_once(std::vector<Vec3>& points) {
  const auto order = [](Vec3 a, Vec3 b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); };
  std::sort(points.begin(), points.end(), order);
  points.erase(std::unique(points.begin(), points.end()), points.end());
}

// Those that lie farthest out in directions spread evenly over all sides (a spiral by the golden angle).
std::vector<Vec3> outermost(const std::vector<Vec3>& points, std::size_t count) {
  std::vector<Vec3> corners;
  for (std::size_t i = 0; i < count; ++i) {
    const double y = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(count), r = std::sqrt(1 - y * y);
    const double angle = static_cast<double>(i) * kPi * (3 - std::sqrt(5.0));
    const Vec3 out{r * std::cos(angle), y, r * std::sin(angle)};
    corners.push_back(*std::max_element(points.begin(), points.end(), [&](Vec3 a, Vec3 b) { return dot(a, out) < dot(b, out); }));
  }
  keep_each_once(corners);
  return corners;
}

// Of a flat model: the corners of the box around it, made thick enough to be solid.
std::vector<Vec3> slab(const std::vector<Vec3>& points) {
  Vec3 low = points[0], high = points[0];
  for (const Vec3 p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const auto thicken = [](double& a, double& b) {
    if (b - a >= kThin) return;
    const double middle = (a + b) / 2;
    a = middle - kThin / 2;
    b = middle + kThin / 2;
  };
  thicken(low.x, high.x);
  thicken(low.y, high.y);
  thicken(low.z, high.z);
  std::vector<Vec3> corners;
  for (const double x : {low.x, high.x})
    for (const double y : {low.y, high.y})
      for (const double z : {low.z, high.z}) corners.push_back({x, y, z});
  return corners;
}

std::vector<Vec3> hull_corners(std::vector<Vec3> points) {
  keep_each_once(points);
  std::vector<Vec3> corners;
  for (const Triangle& face : convex_hull(points)) corners.insert(corners.end(), {face.a, face.b, face.c});
  if (corners.empty()) return slab(points);
  keep_each_once(corners);
  return corners.size() > kMostHullCorners ? outermost(corners, kMostHullCorners) : corners;
}

}  // namespace

Shape settled(Shape shape) {
  if (!shape.file.empty() && shape.shape == ShapeKind::box) shape.shape = ShapeKind::mesh;
  return shape;
}

Shape ShapeFiles::with_points(const Shape& given, AssetLibrary* assets) {
  Shape shape = settled(given);
  if (shape.file.empty()) return shape;
  const Model* model = assets ? assets->model(shape.file) : nullptr;
  if (!model || model->parts.empty()) {
    Shape box;
    box.size = shape.size;
    return box;
  }
  const bool hull = shape.shape == ShapeKind::hull;
  const std::uint64_t version = assets->version(shape.file);
  Kept& kept = kept_[{shape.file, hull}];
  if (kept.points.empty() || kept.version != version) {
    kept = {version, triangles_of(*model)};
    if (hull) kept.points = hull_corners(std::move(kept.points));
  }
  if (!hull && kept.points.size() / 3 > kMostColliderTriangles)
    fail("collider: '", shape.file, "' has ", kept.points.size() / 3, " triangles; a collider takes at most ", kMostColliderTriangles,
         ": give it a simpler model, or shape = \"hull\"");
  shape.points = kept.points;
  if (shape.shape == ShapeKind::height_field)
    for (Vec3& point : shape.points) point = scaled(point, shape.size);
  shape.file.clear();
  return shape;
}

}  // namespace tumble
