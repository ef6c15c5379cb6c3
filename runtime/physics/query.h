// Rays, casts and overlaps.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "physics/body.h"

namespace tumble {

struct QueryFilter {
  std::uint32_t groups = 0xffffffff;         // a body answers if the bit of its group is set
  bool triggers = false;                     // do triggers answer?
  std::function<bool(BodyId)> accept;        // empty: every body
};

struct QueryHit {
  BodyId body;
  int collider = 0;
  Vec3 point;
  Vec3 normal;          // of the surface, towards the origin of the ray
  double distance = 0;  // m
  bool inside = false;  // the ray began inside: distance 0, normal against the direction
};

}  // namespace tumble
