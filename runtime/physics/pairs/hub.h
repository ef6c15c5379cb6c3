// How the place of a contact goes on as a body turns, until it is looked for anew.
#pragma once

#include "physics/pairs/convex.h"

namespace tumble::pairs {

struct Hub {
  Vec3 arm;             // from the body's centre of mass to what turns with the body: a corner itself, or what is round about it
  bool corner = false;
  Vec3 axis;            // of a cylinder or cone, of length 1: its rim and side touch where it comes lowest. Else zero.
};
// Of a contact of the shape, which is at a pose, with `arm` from the body's centre of mass.
Hub hub_of(const Convex& shape, const Pose& at, Vec3 center, Vec3 arm);

}  // namespace tumble::pairs
