#include "render/view.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tumble {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix4d;
using Eigen::Vector3d;

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

// A mesh's bounds along the axes of a frame that picture space is turned into by `to_frame`.
Box bounds(const MeshBox& box, const Matrix& m, const Matrix3d& to_frame) {
  Matrix3d axes;
  axes << m[0], m[4], m[8], m[1], m[5], m[9], m[2], m[6], m[10];
  const Vector3d half(box.half.x, box.half.y, box.half.z), middle(box.middle.x, box.middle.y, box.middle.z);
  const Matrix3d turned = to_frame * axes;
  const Vector3d reach = turned.cwiseAbs() * half, place = turned * middle + to_frame * Vector3d(m[12], m[13], m[14]);
  Box result;
  result.add({place.x(), place.y(), place.z()}, {reach.x(), reach.y(), reach.z()});
  return result;
}

// Wide things with nothing below them are ground: they are shadowed but their own shadow falls nowhere.
constexpr double kGroundWidth = 8;  // m
// So far from a place the shaders look for its shadow, at most.
constexpr double kFilterMargin = 8;  // texels
constexpr double kSunkIn = 0.5;     // what reaches less far below a thing's own bottom only stands in it, m

bool is_below(const Box& other, const Box& box) {
  const bool beside = other.high.x < box.low.x || other.low.x > box.high.x || other.high.z < box.low.z ||
                      other.low.z > box.high.z;
  return !beside && other.low.y < box.low.y - kSunkIn;
}

// What the camera sees within the shadow distance.
Box sight(const DrawList& list, double aspect, double distance, Quat to_light) {
  const ViewRays rays = view_rays(list, aspect);
  distance = std::min(distance, list.far);
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

SunView::SunView(const DrawList& list, const std::vector<MeshBox>& boxes) : list_(list) {
  const bool is_noon = std::abs(list.sun_direction.y) > 0.99;
  light_ = look_rotation(list.sun_direction, is_noon ? Vec3{0, 0, 1} : Vec3{0, 1, 0});
  const Matrix3d upright = Matrix3d::Identity(), to_light = rotation_to_frame(light_).topLeftCorner<3, 3>();
  std::vector<Box> standing;
  standing.reserve(list.meshes.size());
  for (const DrawMesh& mesh : list.meshes) standing.push_back(bounds(boxes[mesh.shape], mesh.matrix, upright));
  const auto is_ground = [&](const Box& box) {
    if (std::min(box.high.x - box.low.x, box.high.z - box.low.z) < kGroundWidth) return false;
    return std::none_of(standing.begin(), standing.end(), [&](const Box& other) { return is_below(other, box); });
  };
  for (std::size_t i = 0; i < list.meshes.size(); ++i) {
    const Box box = bounds(boxes[list.meshes[i].shape], list.meshes[i].matrix, to_light);
    all_.add(box);
    if (list.meshes[i].color.a >= 1 && !is_ground(standing[i])) casters_.add(box);
  }
}

ShadowFit SunView::fit(double aspect, int map_size, double distance) const {
  const Box seen = sight(list_, aspect, distance, conjugate(light_));
  const double left = std::max(casters_.low.x, seen.low.x), right = std::min(casters_.high.x, seen.high.x);
  const double down = std::max(casters_.low.y, seen.low.y), up = std::min(casters_.high.y, seen.high.y);
  ShadowFit fit;
  if (casters_.is_empty() || left >= right || down >= up) return fit;

  // Along the light everything counts: casters stand before the sight, receivers behind them.
  const double nearest = all_.high.z + 1, farthest = all_.low.z - 1;
  constexpr double kLeastSide = 16;    // m; soft edges are some texels wide, and should be so for small things too
  fit.any = true;
  fit.side = stepped_up(std::max({right - left, up - down, kLeastSide}) * (1 + 2 * kFilterMargin / map_size));
  fit.texel = fit.side / map_size;
  const double depth = nearest - farthest;
  const Vec3 origin = conjugate(light_) * list_.origin;
  const auto snapped = [&](double place, double world) {
    return std::round((place + world) / fit.texel) * fit.texel - world;
  };
  fit.x = snapped((left + right) / 2, origin.x);
  fit.y = snapped((down + up) / 2, origin.y);
  fit.across = light_ * Vec3{1, 0, 0};
  fit.upward = light_ * Vec3{0, 1, 0};
  fit.light = light_ * Vec3{0, 0, -1};

  Matrix4d box = Matrix4d::Identity();
  box(0, 0) = box(1, 1) = 2 / fit.side;
  box(0, 3) = -fit.x * 2 / fit.side;
  box(1, 3) = -fit.y * 2 / fit.side;
  box(2, 2) = -2 / depth;
  box(2, 3) = (nearest + farthest) / depth;
  const Matrix4d to_clip = box * rotation_to_frame(light_);
  fit.matrix = plain(to_clip);
  Matrix4d to_map = Matrix4d::Identity() * 0.5;
  to_map.col(3) << 0.5, 0.5, 0.5, 1;
  fit.to_map = plain(to_map * to_clip);
  return fit;
}

bool ShadowFit::may_hold(const Ball& ball) const {
  const Vec3 place{ball.x, ball.y, ball.z};
  const double reach = side / 2 + ball.radius;
  return std::abs(dot(place, across) - x) <= reach && std::abs(dot(place, upward) - y) <= reach;
}

bool ShadowFit::may_shade(const Ball& ball, const Frustum& frustum) const {
  const Ball softened{ball.x, ball.y, ball.z, ball.radius + static_cast<float>(kFilterMargin * texel)};
  const std::array<float, 3> way{static_cast<float>(light.x), static_cast<float>(light.y), static_cast<float>(light.z)};
  return frustum.may_see_shadow(softened, way, static_cast<float>(kShadowDistance));
}

double near_shadow_distance(const std::vector<Ball>& around, const Frustum& frustum) {
  constexpr double kNearest = 10;
  double nearest = kShadowDistance;
  for (const Ball& ball : around)
    if (ball.radius < kGroundWidth && frustum.may_see(ball))
      nearest = std::min(nearest, std::sqrt(double{ball.x} * ball.x + double{ball.y} * ball.y + double{ball.z} * ball.z) - ball.radius);
  return std::min(kShadowDistance, stepped_up(std::max(kNearest, 2.5 * nearest)));
}

}  // namespace tumble
