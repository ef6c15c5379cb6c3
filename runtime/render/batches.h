// A draw list's meshes in the order and form in which a graphics card wants them. No GL here.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "render/bounds.h"

namespace tumble {

// What is missing or broken is drawn in this colour.
inline constexpr Color kMissing{1, 0.2, 0.7, 1};

// As the shaders read it. Colours are linear.
struct Instance {
  std::array<float, 12> matrix;  // three rows of the model matrix
  std::array<float, 4> color;
  std::array<float, 4> material;  // roughness, metalness, nothing, texture size
  std::array<float, 4> glow;      // light of its own
};

// Neighbouring instances of one shape with one texture.
struct Batch {
  std::uint32_t shape = 0, texture = 0;  // of the draw list
  bool two_sided = false;
  bool again = false;                    // the texture comes again beyond its edges
  int coarseness = 0;                    // of the shape's mesh
  std::uint32_t first = 0, count = 0;
};

struct Batches {
  std::vector<Instance> instances;
  std::vector<Batch> opaque;       // the nearest first, and so within each: what is hidden need not be lit
  std::vector<Batch> transparent;  // one by one, from far to near
};

using Wanted = std::function<bool(const Ball&)>;
// What `wanted` keeps of the list's meshes; `around` holds their balls. What is round is as coarse as is right within
// `angle`, rad, as the eye sees it.
Batches make_batches(const DrawList& list, const std::vector<Ball>& around, double angle, const Wanted& wanted);
// Opaque meshes only, whatever they look like: for shadows. What is round is as coarse as is right within `distance`, m.
Batches make_casters(const DrawList& list, const std::vector<Ball>& around, double distance, const Wanted& wanted);

// An sRGB colour's light, and its opacity as it is.
std::array<float, 4> linear(const Color& color);

}  // namespace tumble
