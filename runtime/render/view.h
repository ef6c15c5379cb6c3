// The mathematics of a picture: where the camera looks, what the sun's shadow map covers. No GL here.
#pragma once

#include <algorithm>
#include <array>
#include <limits>

#include "render/bounds.h"

namespace tumble {

// Column-major 4x4. As wide as the scene's numbers; draws narrow it at the last moment.
using WideMatrix = std::array<double, 16>;

// Picture space to OpenGL's clip space.
WideMatrix camera_matrix(const DrawList& list, double aspect);

// The rays through the picture, for the sky: centre + x right + y up, with x and y from -1 to 1.
struct ViewRays {
  Vec3 forward, right, up;
};
ViewRays view_rays(const DrawList& list, double aspect);

// Beyond this distance from the camera nothing is shadowed, m.
constexpr double kShadowDistance = 60;

// A box along the axes of some frame, to be grown.
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

// What a shadow map covers: a square seen along the sun's light.
struct ShadowFit {
  bool any = false;               // false: nothing in sight casts a shadow
  WideMatrix matrix{};            // picture space to the map's clip space
  WideMatrix to_map{};            // picture space to the map's 0..1 and depth
  double texel = 0;               // one texel's edge, m
  double side = 0, x = 0, y = 0;  // the square and its middle along the next two, m
  Vec3 across, upward;            // unit, at right angles to the light
  Vec3 light;                     // unit, the way that it goes

  // May a shadow of it fall into the map?
  bool may_hold(const Ball& ball) const;
  // May it fall on what the camera sees?
  bool may_shade(const Ball& ball, const Frustum& frustum) const;
};

// The meshes as the sun sees them.
class SunView {
 public:
  SunView(const DrawList& list, const std::vector<MeshBox>& boxes);
  // The smallest square that holds all shadows in sight up to a distance from the camera. Its size moves in steps and
  // its place by whole texels of the world, so that edges stand still while the camera moves.
  ShadowFit fit(double aspect, int map_size, double distance = kShadowDistance) const;

 private:
  const DrawList& list_;
  Quat light_;
  Box all_, casters_;
};

// How far the sharper one of two shadow maps should reach: somewhat farther than the nearest thing in sight.
double near_shadow_distance(const std::vector<Ball>& around, const Frustum& frustum);

}  // namespace tumble
