// A draw list's meshes in the order and form in which a graphics card wants them. No GL here.
#pragma once

#include <cstdint>
#include <vector>

#include "render/draw_list.h"

namespace tumble {

// What is missing or broken is drawn in this colour.
inline constexpr Color kMissing{1, 0.2, 0.7, 1};

// As the shaders read it. Colours are linear.
struct Instance {
  std::array<float, 12> matrix;  // three rows of the model matrix
  std::array<float, 4> color;
  std::array<float, 4> material;  // roughness, metalness, glow, nothing
};

// Neighbouring instances of one shape.
struct Batch {
  std::uint64_t key = 0;
  const Shape* shape = nullptr;  // points into the draw list
  std::uint32_t first = 0, count = 0;
};

struct Batches {
  std::vector<Instance> instances;
  std::vector<Batch> opaque;       // in order of first appearance
  std::vector<Batch> transparent;  // one by one, from far to near
};
Batches make_batches(const DrawList& list);

// An sRGB colour's light, and its opacity as it is.
std::array<float, 4> linear(const Color& color);

}  // namespace tumble
