// How a body turns in the time between two solutions: no torque acts, its angular momentum stays.
#pragma once

#include "base/math.h"

namespace tumble::dynamics {

// q turned further by a rotation vector (axis times angle, radians), both in the world.
Quat turned_by(Quat q, Vec3 rotation);

// Takes rotation (from the principal axes to the world) and spin (world, rad/s) through `seconds` of free rotation with
// these principal moments (kg m^2, all above 0). Spins of any size turn in full.
//
// The angular momentum L is kept in the world to rounding; the step is the midpoint rule on the rotation group,
//   q' = exp(h w) q,  w = I(exp(h w / 2) q)^-1 L,
// solved by fixed point iteration. It is symmetric in time, so that energy does not drift but swings by O(h^2)
// (E. Hairer, C. Lubich, G. Wanner, Geometric Numerical Integration, chapters IV and V).
void turn(Quat& rotation, Vec3& spin, Vec3 inertia, double seconds);

}  // namespace tumble::dynamics
