#include "physics/bullet/closest.h"

#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

namespace tumble {

std::optional<Closest> closest(const btConvexShape& a, const btTransform& at_a, const btConvexShape& b, const btTransform& at_b,
                               double within) {
  // In b's frame, so that a far origin costs no digits.
  const btTransform relative = at_b.inverseTimes(at_a);
  btVoronoiSimplexSolver simplex;
  btGjkEpaPenetrationDepthSolver depth;
  btGjkPairDetector detector(&a, &b, &simplex, &depth);
  btGjkPairDetector::ClosestPointInput input;
  input.m_transformA = relative;
  input.m_transformB = btTransform::getIdentity();
  const double reach = within + a.getMargin() + b.getMargin();
  input.m_maximumDistanceSquared = reach < 1e15 ? reach * reach : BT_LARGE_FLOAT;
  btPointCollector result;
  detector.getClosestPoints(input, result, nullptr);
  if (!result.m_hasResult || result.m_distance > within) return {};
  return Closest{from_bullet(at_b * result.m_pointInWorld), from_bullet(at_b.getBasis() * result.m_normalOnBInWorld), result.m_distance};
}

std::optional<Meeting> meet(const btConvexShape& a, const btTransform& from, Vec3 direction, double length, const btConvexShape& b,
                            const btTransform& at_b) {
  // Conservative advancement: along the direction, the shapes cannot meet before the gap is used up at the speed at
  // which the gap's normal sees it shrink.
  constexpr double kTouch = 1e-7;  // m
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
