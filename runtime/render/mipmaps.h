// The smaller copies of a picture that far things are painted with. No GL here: not every driver makes them fast, and those
// that draw with the processor compile a shader for each size first.
#pragma once

#include <vector>

#include "assets/image.h"

namespace tumble {

// From half its size down to one pixel. Colours are mixed as light, opacity as it is.
std::vector<Image> smaller_copies(const Image& image);

}  // namespace tumble
