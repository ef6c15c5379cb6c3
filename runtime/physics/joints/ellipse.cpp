#include "physics/joints/ellipse.h"

#include <cmath>
#include <utility>

namespace tumble {

namespace {

struct Point {
  double u, v;
};

// The nearest point of an ellipse with half axes p >= q to one with u, v >= 0. It is (p^2 u / (d + s), q^2 v / s) with
// d = p^2 - q^2 and the s above 0 that puts it on the ellipse (D. Eberly, Distance from a Point to an Ellipse).
Point nearest(double p, double q, Point at) {
  const double d = p * p - q * q;
  if (at.v <= 0) {  // on the long axis; near the middle two points are as near, and one is taken
    const double u = at.u * p < d ? p * p * at.u / d : p;
    return {u, q * std::sqrt(std::fmax(0, 1 - u * u / (p * p)))};
  }
  // Newton's method from where one of the two squares is 1: their sum falls and is convex, so that it cannot overshoot.
  double s = std::fmax(q * at.v, p * at.u - d);
  for (int i = 0; i < 60; ++i) {
    const double x = p * at.u / (d + s), y = q * at.v / s;
    const double step = (x * x + y * y - 1) / (2 * (x * x / (d + s) + y * y / s));
    s += step;
    if (std::abs(step) <= 1e-15 * s) break;
  }
  return {p * p * at.u / (d + s), q * q * at.v / s};
}

}  // namespace

Boundary ellipse_boundary(double half_a, double half_b, double a, double b) {
  const bool swap = half_a < half_b;
  const double p = swap ? half_b : half_a, q = swap ? half_a : half_b;
  Point at{std::abs(a), std::abs(b)};
  if (swap) std::swap(at.u, at.v);

  const Point on = nearest(p, q, at);
  Point normal{on.u / (p * p), on.v / (q * q)};
  const double length = std::hypot(normal.u, normal.v);
  normal = {normal.u / length, normal.v / length};
  const double inside = (on.u - at.u) * normal.u + (on.v - at.v) * normal.v;

  if (swap) std::swap(normal.u, normal.v);
  return {inside, std::copysign(normal.u, a), std::copysign(normal.v, b)};
}

}  // namespace tumble
