// A picture's light as the shaders read it: colours made linear and brought to the exposure. No GL here.
#pragma once

#include "render/draw_list.h"

namespace tumble {

struct Air {
  Vec3 sky_top, sky_horizon, ground;
  Vec3 to_sun, sun;        // sun: what a surface that faces it gets
  Vec3 above, below;       // from all around, on what faces up and on what faces down
  Vec3 fog_color;
  Vec3 fog;                // where it begins, m; 1 / its depth, 1/m; 1 where it looks like the sky behind it
  bool has_fog = false;
  double fog_height = 0;   // in which it hides the sky above the horizon, in sines of the elevation
  double haze = 0;         // 1/m^2
};
Air air_of(const DrawList& list);

// The share of a thing's light that fog takes at a distance, 0..1.
double fog_share(double distance, double fog_start, double fog_end);

}  // namespace tumble
