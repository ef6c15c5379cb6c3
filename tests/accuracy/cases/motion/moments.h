// Moments of solids up to the second, about the frame's origin, so that parts simply add: the reference of A28, apart
// from what the runtime computes.
#pragma once

#include <array>

#include "base/math.h"

namespace tumble::accuracy {

using Matrix = std::array<std::array<double, 3>, 3>;

struct Moments {
  double mass = 0;
  Vec3 first;        // integral of x dm
  Matrix second{};   // integral of x x^T dm

  Vec3 center() const { return first / mass; }
  Matrix inertia() const;  // about the centre
};
Moments operator+(const Moments& a, const Moments& b);
Moments operator*(const Moments& a, double density);
Moments placed(const Moments& part, const Pose& pose);

// ---- of density 1; axis y, centred as the runtime's shapes are
Moments solid_box(Vec3 size);
Moments solid_ball(double radius);
Moments solid_cylinder(double radius, double height);
Moments solid_capsule(double radius, double height);  // height over all
Moments solid_cone(double radius, double height);
Moments solid_pyramid(Vec3 size);
Moments solid_torus(double radius, double thickness);
Moments solid_tetrahedron(Vec3 a, Vec3 b, Vec3 c, Vec3 d);

Matrix turned(const Matrix& m, Quat rotation);
Matrix diagonal(Vec3 v);
double norm(const Matrix& m);                          // Frobenius
double distance(const Matrix& a, const Matrix& b);

}  // namespace tumble::accuracy
