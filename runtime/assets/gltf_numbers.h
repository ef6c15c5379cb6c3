// The numbers of a glTF file's accessors, every index, offset and size checked.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "assets/gltf_file.h"

namespace tumble {

// `count` rows of `width` numbers each; whole numbers that stand for fractions (normalized) are fractions.
struct GltfNumbers {
  std::size_t count = 0, width = 0;
  std::vector<float> values;
  const float* row(std::size_t i) const { return &values[i * width]; }
};

// All of them finite. Throws Error where the accessor is faulty, has another width or more than kMostModelVertices rows;
// `what` is what the sentence calls it.
GltfNumbers read_numbers(const GltfFile& file, int accessor, std::size_t width, const char* what);
// Whole numbers, each below `limit`.
std::vector<std::uint32_t> read_indices(const GltfFile& file, int accessor, std::size_t limit);
// The bytes of a buffer view.
std::string_view view_bytes(const GltfFile& file, int view, const char* what);

}  // namespace tumble
