// Distance, and the way out of an overlap, between two convex shapes.
#pragma once

#include <optional>

#include "physics/bullet/convert.h"

namespace tumble {

struct Closest {
  Vec3 point;           // on b's surface
  Vec3 normal;          // from b towards a
  double distance = 0;  // negative where they overlap
};
// Nothing where they are further apart than `within`.
std::optional<Closest> closest(const btConvexShape& a, const btTransform& at_a, const btConvexShape& b, const btTransform& at_b,
                               double within);
// How far a can go along `direction` (of length 1) until it touches b, at most `length`.
struct Meeting {
  double distance = 0;
  Vec3 point, normal;
  bool inside = false;  // they overlapped at the start
};
std::optional<Meeting> meet(const btConvexShape& a, const btTransform& from, Vec3 direction, double length, const btConvexShape& b,
                            const btTransform& at_b);

}  // namespace tumble
