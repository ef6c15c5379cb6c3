// The point and spot lights that a picture is lit with, as the shaders read them. No GL here.
#pragma once

#include <array>
#include <vector>

#include "render/bounds.h"

namespace tumble {

// What a surface that faces it gets from a lamp of brightness 1 at a distance, in clear days: by the inverse-square law,
// about 1 at a quarter of its range, and 0 from its range on.
double lamp_share(double distance, double range);

struct Lamps {
  std::vector<std::array<float, 4>> place;  // picture space; 1 / range
  std::vector<std::array<float, 4>> light;  // linear color times brightness and exposure; 1 / a spot's soft rim
  std::vector<std::array<float, 4>> axis;   // a spot's direction; the cosine at which it ends
};
// The `most` lamps that matter most to what the camera sees.
Lamps choose_lamps(const DrawList& list, const Frustum& frustum, std::size_t most);

}  // namespace tumble
