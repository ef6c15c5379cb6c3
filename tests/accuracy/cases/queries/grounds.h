// Grounds that are flat, or ought to behave as if they were, made in the many ways of games.
#pragma once

#include "accuracy/scenes.h"

namespace tumble::accuracy {

// A square of tiles of 1 m, two triangles each, from -half to half in x and z, y by height(x, z).
Shape tiled(ShapeKind kind, int half, const std::function<double(double, double)>& height);
Shape tiled(ShapeKind kind, int half);
// Flat; every second row of tiles is shifted by half a tile, so that corners meet the middle of edges.
Shape tiled_with_t_junctions(int half);

}  // namespace tumble::accuracy
