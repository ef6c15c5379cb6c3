// How much is done for a picture. A processor that draws has better things to do than what a graphics card does almost
// for nothing.
#pragma once

#include "render/gl/functions.h"
#include "render/renderer.h"

namespace tumble {

struct Quality {
  int edge_samples = 4;        // for each pixel; 0: edges are not smoothed
  int shadow_map_size = 2048;  // texels along a side
  int shadow_taps = 4;         // along a side of the square that a soft edge is taken from
  int lamps = 16;              // point and spot lights in one picture
};

// By the driver: Mesa's llvmpipe and the like get the software form.
Quality quality_for(const Gl& gl, DrawQuality wanted);

}  // namespace tumble
