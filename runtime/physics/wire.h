// Shapes as lines, for the debug view and for draw.shape.
#pragma once

#include <vector>

#include "base/shape.h"

namespace tumble {

struct WireLine {
  Vec3 from, to;
};
using Wire = std::vector<WireLine>;

// The shape's edges and the circles that round shapes are known by, in its own frame. Of a hull and a mesh each edge
// comes once, and none where two triangles lie in one plane; of one without points, none at all.
Wire wire_of(const Shape& shape);

// An arc about `center` from u towards v, both as long as its radius.
void add_arc(Wire& wire, Vec3 center, Vec3 u, Vec3 v, double angle);

}  // namespace tumble
