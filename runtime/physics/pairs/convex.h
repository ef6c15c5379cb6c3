// A convex shape as the contact search sees it, and its furthest points.
#pragma once

#include "physics/pairs/polyhedron.h"

namespace tumble::pairs {

// Centred as in base/shape.h: axis y, a cone's apex at +half_height. Each kind reads only its own fields.
struct Convex {
  enum Kind { sphere, capsule, box, cylinder, cone, polyhedron, triangle };
  Kind kind = sphere;
  double radius = 0;                  // sphere, capsule, cylinder, cone
  double half_height = 0;             // cylinder, cone; of a capsule its segment's, without the caps
  Vec3 half;                          // box
  const Polyhedron* solid = nullptr;  // polyhedron; whoever makes the Convex keeps it alive
  Vec3 corners[3];                    // triangle; both its sides are outside
};
Convex make_sphere(double radius);
Convex make_capsule(double radius, double half_height);
Convex make_box(Vec3 half);
Convex make_cylinder(double radius, double half_height);
Convex make_cone(double radius, double half_height);
Convex make_solid(const Polyhedron& solid);
Convex make_triangle(Vec3 a, Vec3 b, Vec3 c);

// A shape at its place, with the rotation spelled out: turning a vector then costs 9 products instead of 18.
struct Placed {
  Placed(const Convex& shape, const Pose& pose);
  Vec3 turned(Vec3 v) const { return axis[0] * v.x + axis[1] * v.y + axis[2] * v.z; }
  Vec3 turned_back(Vec3 v) const { return {dot(axis[0], v), dot(axis[1], v), dot(axis[2], v)}; }
  Vec3 world(Vec3 local) const { return position + turned(local); }

  const Convex& shape;
  Vec3 position;
  Vec3 axis[3];
};

// The point of the shape that lies furthest in a direction (world, of any length but zero).
Vec3 furthest(const Placed& placed, Vec3 direction);
// The same of its core: a sphere's centre, a capsule's segment; other shapes are their own core. The shape is all that
// is within `rounding` of its core.
Vec3 furthest_of_core(const Placed& placed, Vec3 direction);
double rounding(const Convex& shape);
// A point well within it, in the world.
Vec3 middle(const Placed& placed);
// Half of about its largest extent, m: what tolerances are relative to.
double size_of(const Convex& shape);
// How far a stands off b along a direction of length 1 from b to a; the largest over all directions is their distance,
// or the negative of how deep they are in one another.
double separation_along(const Placed& a, const Placed& b, Vec3 normal);

}  // namespace tumble::pairs
