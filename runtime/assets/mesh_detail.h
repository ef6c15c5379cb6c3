// Coarser meshes of round shapes, for where nobody can see the difference.
#pragma once

#include "assets/mesh.h"

namespace tumble {

// Each step of coarseness halves the corners that go round. Coarser meshes lie within finer ones; 0 is make_mesh(shape).
constexpr int kCoarsest = 2;
Mesh make_mesh(const Shape& shape, int coarseness);
// The coarsest mesh whose faces lie nowhere deeper than this within the true shape, m; 0 where none does.
int coarseness_within(const Shape& shape, double distance);

}  // namespace tumble
