#include "render/view.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tumble {
namespace {

using Eigen::Matrix4d;

// Rows are the axes of a rotated frame: takes picture space to that frame.
Matrix4d rotation_to_frame(Quat rotation) {
  const Vec3 x = rotation * Vec3{1, 0, 0}, y = rotation * Vec3{0, 1, 0}, z = rotation * Vec3{0, 0, 1};
  Matrix4d m = Matrix4d::Identity();
  m.topLeftCorner<3, 3>() << x.x, x.y, x.z, y.x, y.y, y.z, z.x, z.y, z.z;
  return m;
}

WideMatrix plain(const Matrix4d& m) {
  WideMatrix result;
  std::copy_n(m.data(), result.size(), result.begin());  // Eigen's columns come first too
  return result;
}

struct Box {
  static constexpr double kHuge = std::numeric_limits<double>::max();
  Vec3 low{kHuge, kHuge, kHuge}, high{-kHuge, -kHuge, -kHuge};

  void add(Vec3 p, Vec3 half = {}) {
    low = {std::min(low.x, p.x - half.x), std::min(low.y, p.y - half.y), std::min(low.z, p.z - half.z)};
    high = {std::max(high.x, p.x + half.x), std::max(high.y, p.y + half.y), std::max(high.z, p.z + half.z)};
  }
  void add(const Box& box) {
    add(box.low);
    add(box.high);
  }
  bool is_empty() const { return low.x > high.x; }
};

// A mesh's bounds along the axes of a frame that picture space is turned into by `to_frame`.
Box bounds(const DrawMesh& mesh, Quat to_frame) {
  const Vec3 half = half_extents(mesh.shape);
  const Matrix& m = mesh.matrix;
  const double sizes[3] = {half.x, half.y, half.z};
  Vec3 reach;
  for (int i = 0; i < 3; ++i) {
    const Vec3 axis = to_frame * (Vec3{m[4 * i], m[4 * i + 1], m[4 * i + 2]} * sizes[i]);
    reach += {std::abs(axis.x), std::abs(axis.y), std::abs(axis.z)};
  }
  Box box;
  box.add(to_frame * Vec3{m[12], m[13], m[14]}, reach);
  return box;
}

// Wide things with nothing below them are ground: they are shadowed but their own shadow falls nowhere.
constexpr double kGroundWidth = 8;  // m
constexpr double kSunkIn = 0.5;     // what reaches less far below a thing's own bottom only stands in it, m

bool is_below(const Box& other, const Box& box) {
  const bool beside = other.high.x < box.low.x || other.low.x > box.high.x || other.high.z < box.low.z ||
                      other.low.z > box.high.z;
  return !beside && other.low.y < box.low.y - kSunkIn;
}

Box shadows_of_casters(const DrawList& list, Quat to_light) {
  std::vector<Box> upright;
  for (const DrawMesh& mesh : list.meshes) upright.push_back(bounds(mesh, Quat{}));
  const auto is_ground = [&](const Box& box) {
    if (std::min(box.high.x - box.low.x, box.high.z - box.low.z) < kGroundWidth) return false;
    return std::none_of(upright.begin(), upright.end(), [&](const Box& other) { return is_below(other, box); });
  };
  Box result;
  for (std::size_t i = 0; i < upright.size(); ++i)
    if (list.meshes[i].color.a >= 1 && !is_ground(upright[i])) result.add(bounds(list.meshes[i], to_light));
  return result;
}

// What the camera sees within the shadow distance.
Box sight(const DrawList& list, double aspect, Quat to_light) {
  const ViewRays rays = view_rays(list, aspect);
  const double distance = std::min(kShadowDistance, list.far);
  Box box;
  box.add(Vec3{});
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0}) box.add(to_light * ((rays.forward + rays.right * x + rays.up * y) * distance));
  return box;
}

// Four steps per doubling: seldom a jump, seldom much wasted.
double stepped_up(double size) { return std::exp2(std::ceil(std::log2(size) * 4) / 4); }

}  // namespace

ViewRays view_rays(const DrawList& list, double aspect) {
  const double height = std::tan(list.field_of_view / 2);
  return {list.camera_rotation * Vec3{0, 0, -1}, list.camera_rotation * Vec3{height * aspect, 0, 0},
          list.camera_rotation * Vec3{0, height, 0}};
}

WideMatrix camera_matrix(const DrawList& list, double aspect) {
  const double f = 1 / std::tan(list.field_of_view / 2), near = list.near, far = list.far;
  Matrix4d projection = Matrix4d::Zero();
  projection(0, 0) = f / aspect;
  projection(1, 1) = f;
  projection(2, 2) = (far + near) / (near - far);
  projection(2, 3) = 2 * far * near / (near - far);
  projection(3, 2) = -1;
  return plain(projection * rotation_to_frame(list.camera_rotation));
}

ShadowFit fit_shadow(const DrawList& list, double aspect, int map_size) {
  const bool is_noon = std::abs(list.sun_direction.y) > 0.99;
  const Quat light = look_rotation(list.sun_direction, is_noon ? Vec3{0, 0, 1} : Vec3{0, 1, 0});
  const Quat to_light = conjugate(light);
  const Box casters = shadows_of_casters(list, to_light), seen = sight(list, aspect, to_light);
  const double left = std::max(casters.low.x, seen.low.x), right = std::min(casters.high.x, seen.high.x);
  const double down = std::max(casters.low.y, seen.low.y), up = std::min(casters.high.y, seen.high.y);
  ShadowFit fit;
  if (casters.is_empty() || left >= right || down >= up) return fit;

  // Along the light everything counts: casters stand before the sight, receivers behind them.
  Box all;
  for (const DrawMesh& mesh : list.meshes) all.add(bounds(mesh, to_light));
  const double nearest = all.high.z + 1, farthest = all.low.z - 1;

  constexpr double kFilterMargin = 8;  // texels
  const double side = stepped_up(std::max(right - left, up - down) * (1 + 2 * kFilterMargin / map_size));
  fit.any = true;
  fit.texel = side / map_size;
  fit.depth = nearest - farthest;
  const Vec3 origin = to_light * list.origin;
  const auto snapped = [&](double place, double world) {
    return std::round((place + world) / fit.texel) * fit.texel - world;
  };
  const double x = snapped((left + right) / 2, origin.x), y = snapped((down + up) / 2, origin.y);

  Matrix4d box = Matrix4d::Identity();
  box(0, 0) = box(1, 1) = 2 / side;
  box(0, 3) = -x * 2 / side;
  box(1, 3) = -y * 2 / side;
  box(2, 2) = -2 / fit.depth;
  box(2, 3) = (nearest + farthest) / fit.depth;
  fit.matrix = plain(box * rotation_to_frame(light));
  return fit;
}

}  // namespace tumble
