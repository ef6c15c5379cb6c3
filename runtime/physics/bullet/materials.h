// Friction and restitution of two touching surfaces.
//
// Bullet asks for them through functions that are global to the process; ours hold no state and find the world's rules
// through the two objects, so that several worlds do not meet here.
#pragma once

#include "physics/bullet/body_state.h"

namespace tumble {

// The world's rules and defaults; every body of a world points to its world's.
struct Materials {
  double friction = 0.5, restitution = 0;
  Combine friction_combine = Combine::multiply, restitution_combine = Combine::max;
};

double combine(Combine rule, double a, double b);
// A body's own rule before the world's; of two different ones the later of multiply, average, min, max, as in Unity.
Combine rule_of(const std::optional<Combine>& a, const std::optional<Combine>& b, Combine world);

// Of two bodies of one collider each.
struct Surface {
  double friction = 0, restitution = 0;
};
Surface surface_between(const BodyState& a, const BodyState& b);
// How fast b's surface runs against a's, m/s; 0 but for belts.
Vec3 belt_between(const BodyState& a, const BodyState& b);

// Of a point between two solids; Bullet itself is told 0.
double contact_restitution(const btPersistentManifold& manifold, const btManifoldPoint& point);

void install_material_callbacks();

}  // namespace tumble
