// How deep solids overlap, by the harness's own geometry: it trusts no engine's contacts.
#pragma once

#include <vector>

#include "accuracy/simulation.h"

namespace tumble::accuracy {

// A convex shape somewhere in the world: sphere, box, capsule, cylinder, cone, pyramid or hull.
struct Solid {
  Shape shape;
  Pose pose;
};

// The shortest way that would part them, m; 0 where they do not overlap. Exact where each is a sphere, a capsule or a
// box; of other shapes a bound from above by a search over directions, mostly exact. Throws
// std::invalid_argument for shapes that are not convex.
double overlap_depth(const Solid& a, const Solid& b);
bool overlap_is_exact(const Shape& a, const Shape& b);

// The furthest point of a solid in a direction, world.
Vec3 support(const Solid& solid, Vec3 direction);
// Half the size of the world's box around it.
Vec3 reach(const Solid& solid);

// All pairs of a scene's bodies that overlap. The bodies have one collider each, without offset.
struct Placed {
  BodyIndex body = 0;
  Shape shape;
  bool moves = true;       // pairs of two that do not move are left out
};
struct Overlap {
  BodyIndex a = 0, b = 0;
  double depth = 0;        // m, above 0
};
std::vector<Overlap> overlaps(const Simulation& scene, const std::vector<Placed>& bodies);
double deepest(const std::vector<Overlap>& overlaps);    // 0 where there is none
double mean_depth(const std::vector<Overlap>& overlaps); // likewise

}  // namespace tumble::accuracy
