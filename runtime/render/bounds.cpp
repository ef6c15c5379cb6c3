#include "render/bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "assets/library.h"
#include "assets/mesh_detail.h"
#include "base/hash.h"

namespace tumble {
namespace {

// Shapes that change their size every tick would otherwise pile up.
constexpr std::size_t kMostKnown = 4096;

const Mesh* part_mesh(const DrawList& list, const DrawShape& shape) {
  if (shape.part < 0 || !list.assets) return nullptr;
  const Model* model = list.assets->model(shape.shape.file);
  const bool known = model && shape.part < static_cast<int>(model->parts.size());
  return known ? &model->parts[static_cast<std::size_t>(shape.part)].mesh : nullptr;
}

MeshBox box_around(const Mesh& mesh) {
  constexpr float huge = std::numeric_limits<float>::max();
  std::array<float, 3> low{huge, huge, huge}, high{-huge, -huge, -huge};
  for (const Vertex& vertex : mesh.vertices)
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], vertex.position[i]);
      high[i] = std::max(high[i], vertex.position[i]);
    }
  if (mesh.vertices.empty()) return {};
  const Vec3 a{low[0], low[1], low[2]}, b{high[0], high[1], high[2]};
  return {(a + b) / 2, (b - a) / 2};
}

MeshBox box_of(const DrawList& list, const DrawShape& shape) {
  if (const Mesh* mesh = part_mesh(list, shape)) return box_around(*mesh);
  if (shape.shape.shape == ShapeKind::hull) return box_around(make_mesh(shape.shape));
  return {{}, half_extents(shape.shape)};
}

std::array<float, 3> narrow(Vec3 v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

float along(const std::array<float, 3>& axis, const Ball& ball) {
  return axis[0] * ball.x + axis[1] * ball.y + axis[2] * ball.z;
}

}  // namespace

Mesh mesh_of(const DrawList& list, const DrawShape& shape, int coarseness) {
  const Mesh* mesh = part_mesh(list, shape);
  return mesh ? *mesh : make_mesh(shape.shape, coarseness);
}

std::uint64_t geometry_key(const DrawList& list, const DrawShape& shape, int coarseness) {
  const std::uint64_t version = list.assets && !shape.shape.file.empty() ? list.assets->version(shape.shape.file) : 0;
  const auto coarse = static_cast<std::uint64_t>(coarseness);
  return version == 0 && coarse == 0 ? shape.key : Hash().add(shape.key).add(version).add(coarse).value();
}

const std::vector<MeshBox>& MeshBoxes::find(const DrawList& list) {
  if (known_.size() > kMostKnown) known_.clear();
  found_.clear();
  for (const DrawShape& shape : list.shapes) {
    const auto [place, is_new] = known_.try_emplace(geometry_key(list, shape));
    if (is_new) place->second = box_of(list, shape);
    found_.push_back(place->second);
  }
  return found_;
}

std::vector<Ball> balls(const DrawList& list, const std::vector<MeshBox>& boxes) {
  std::vector<Ball> result;
  result.reserve(list.meshes.size());
  for (const DrawMesh& mesh : list.meshes) {
    const MeshBox& box = boxes[mesh.shape];
    const std::array<float, 3> c = narrow(box.middle), h = narrow(box.half);
    const Matrix& m = mesh.matrix;
    Ball ball{m[0] * c[0] + m[4] * c[1] + m[8] * c[2] + m[12], m[1] * c[0] + m[5] * c[1] + m[9] * c[2] + m[13],
              m[2] * c[0] + m[6] * c[1] + m[10] * c[2] + m[14], 0};
    // No corner is farther than the three half axes one after the other at right angles, unless the axes are sheared.
    float squared = 0;
    for (std::size_t i = 0; i < 3; ++i)
      squared += (m[4 * i] * m[4 * i] + m[4 * i + 1] * m[4 * i + 1] + m[4 * i + 2] * m[4 * i + 2]) * h[i] * h[i];
    ball.radius = std::sqrt(squared);
    result.push_back(ball);
  }
  return result;
}

Frustum::Frustum(const DrawList& list, double aspect) {
  const double height = std::tan(list.field_of_view / 2), width = height * aspect;
  forward_ = narrow(list.camera_rotation * Vec3{0, 0, -1});
  right_ = narrow(list.camera_rotation * Vec3{1, 0, 0});
  up_ = narrow(list.camera_rotation * Vec3{0, 1, 0});
  near_ = static_cast<float>(list.near);
  far_ = static_cast<float>(list.far);
  across_ = static_cast<float>(width);
  upward_ = static_cast<float>(height);
  across_slant_ = static_cast<float>(std::hypot(1, width));
  upward_slant_ = static_cast<float>(std::hypot(1, height));
}

bool Frustum::may_see(const Ball& ball) const {
  const float depth = along(forward_, ball);
  if (depth < near_ - ball.radius || depth > far_ + ball.radius) return false;
  if (std::abs(along(right_, ball)) > depth * across_ + ball.radius * across_slant_) return false;
  return std::abs(along(up_, ball)) <= depth * upward_ + ball.radius * upward_slant_;
}

// What starts outside one of the sight's planes and moves along it or away from it never comes in.
bool Frustum::may_see_shadow(const Ball& ball, const std::array<float, 3>& light, float reach) const {
  const Ball way{light[0], light[1], light[2], 0};
  const float depth = along(forward_, ball), deeper = along(forward_, way);
  if (depth < near_ - ball.radius && deeper <= 0) return false;
  if (depth > std::min(far_, reach) + ball.radius && deeper >= 0) return false;
  const auto stays_out = [&](const std::array<float, 3>& axis, float opening, float slant) {
    const float beside = along(axis, ball), aside = along(axis, way);
    for (const float side : {-1.0f, 1.0f})
      if (side * beside > depth * opening + ball.radius * slant && side * aside >= deeper * opening) return true;
    return false;
  };
  return !stays_out(right_, across_, across_slant_) && !stays_out(up_, upward_, upward_slant_);
}

}  // namespace tumble
