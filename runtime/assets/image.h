// Pictures read from memory or disk: PNG and whatever else the reader knows (JPEG, BMP, TGA).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tumble {

struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> pixels;  // RGBA, rows from the top
};

// Games come from anybody: a larger picture is refused before memory is taken for it.
constexpr int kLargestImageSide = 8192;

// `name` is what errors call the picture. Throws Error where the bytes are no picture or a too large one.
Image read_image(std::string_view bytes, const std::string& name);
// The same from a file; throws Error where it cannot be read.
Image load_image(const std::string& file);

}  // namespace tumble
