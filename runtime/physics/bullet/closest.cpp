#include "physics/bullet/closest.h"

#include "physics/bullet/convex_pair.h"

namespace tumble {

std::optional<Closest> closest(const btConvexShape& a, const btTransform& at_a, const btConvexShape& b, const btTransform& at_b,
                               double within) {
  pairs::Convex convex_a, convex_b;
  if (!convex_of(a, convex_a) || !convex_of(b, convex_b)) return {};
  pairs::Nearest found;
  if (!pairs::closest(convex_a, from_bullet(at_a), convex_b, from_bullet(at_b), within, found)) return {};
  return Closest{found.on_b, found.normal, found.separation};
}

std::optional<Meeting> meet(const btConvexShape& a, const btTransform& from, Vec3 direction, double length, const btConvexShape& b,
                            const btTransform& at_b) {
  // Conservative advancement: along the direction, the shapes cannot meet before the gap is used up at the speed at
  // which the gap's normal sees it shrink.
  constexpr double kTouch = 1e-10;  // m
  double done = 0;
  std::optional<Closest> gap;
  for (int i = 0; i < 64; ++i) {
    btTransform at = from;
    at.getOrigin() += to_bullet(direction * done);
    gap = closest(a, at, b, at_b, BT_LARGE_FLOAT);
    if (!gap) return {};
    if (i == 0 && gap->distance <= 0) return Meeting{0, gap->point, gap->normal, true};
    const double approach = -dot(gap->normal, direction);
    if (gap->distance <= kTouch) {
      if (approach <= 0) return {};  // slides along or leaves
      break;
    }
    if (approach <= 1e-12) return {};
    done += gap->distance / approach;
    if (done > length) return {};
  }
  return Meeting{done, gap->point, gap->normal, false};
}

}  // namespace tumble
