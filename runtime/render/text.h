// Where the letters of a text stand: the same for measuring and for drawing.
#pragma once

#include <functional>
#include <string_view>

#include "render/renderer.h"

namespace tumble {

struct PlacedLetter {
  char32_t letter;
  double x;      // of its pen, from the line's start
  int line;      // 0 is the first
  double width;  // how far the pen moves
};

// In order; `size` is the line height, and x and width are in its units.
void lay_out(std::string_view text, double size, bool mono, const std::function<void(const PlacedLetter&)>& each);

}  // namespace tumble
