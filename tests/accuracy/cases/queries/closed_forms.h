// Where a ray meets a shape, and a moving ball a box, written down once more and apart from any engine. Each shape is
// asked in its own frame: centred on the origin, axis y, as base/shape.h has it.
#pragma once

#include <functional>
#include <optional>

#include "base/math.h"
#include "base/shape.h"

namespace tumble::accuracy {

struct Line {
  Vec3 origin, direction;  // of length 1
};
struct Meeting {
  double distance = 0;
  Vec3 normal;  // outward
};
using Truth = std::function<std::optional<Meeting>(const Line&)>;

// Box, sphere, capsule, cylinder, cone, mesh and height_field, from outside.
std::optional<Meeting> meet(const Shape& shape, const Line& line);
// A box grown by a ball: what the centre of a moving ball of that radius meets.
std::optional<Meeting> meet_rounded_box(Vec3 size, double radius, const Line& line);

// The nearer of two.
std::optional<Meeting> nearer(std::optional<Meeting> a, std::optional<Meeting> b);
// A truth of what lies at a pose.
Truth at(const Pose& pose, Truth truth);

}  // namespace tumble::accuracy
