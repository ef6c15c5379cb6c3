// The mathematics of a picture: where the camera looks, what the sun's shadow map covers. No GL here.
#pragma once

#include <array>

#include "render/draw_list.h"

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

struct ShadowFit {
  bool any = false;               // false: nothing in sight casts a shadow
  WideMatrix matrix{};            // picture space to the map's clip space
  double texel = 0, depth = 0;    // one texel's edge, the whole depth range, m
};

// The smallest square that holds all shadows in sight. Its size moves in steps and its place by whole texels of the
// world, so that edges stand still while the camera moves.
ShadowFit fit_shadow(const DrawList& list, double aspect, int map_size);

}  // namespace tumble
