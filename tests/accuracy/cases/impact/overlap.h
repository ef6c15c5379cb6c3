// How far bodies are inside each other, from their poses alone: what an engine says of its contacts is not asked.
#pragma once

#include <functional>
#include <vector>

#include "base/math.h"

namespace tumble::accuracy {

// Of two boxes with these edges, m: the least way that parts them, by separating axes; negative where they are apart.
double box_overlap(const Pose& a, Vec3 edges_a, const Pose& b, Vec3 edges_b);

// Calls f(i, k), i < k, for the points that are nearer than `within` along x, and for few others.
void each_near_pair(const std::vector<Vec3>& points, double within, const std::function<void(std::size_t, std::size_t)>& f);

}  // namespace tumble::accuracy
