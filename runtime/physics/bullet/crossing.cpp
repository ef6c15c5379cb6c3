#include "physics/bullet/crossing.h"

#include "physics/bullet/closest.h"
#include "physics/bullet/each_convex.h"
#include "physics/bullet/way.h"

namespace tumble {

namespace {

// The search ends where the gap is less than this, m, or where so little of a step is left.
constexpr double kTouch = 1e-11, kInstant = 1e-10;

// How far the triggers of one and the solids of the other stand apart on their ways; negative where they overlap.
class Gap {
 public:
  Gap(const BodyState& a, const BodyState& b, double seconds)
      : a_(a), b_(b), way_a_(a, seconds), way_b_(b, seconds), reach_(length(straight_way(a)) + length(straight_way(b)) + a.extent + b.extent) {}

  double at(double part) const {
    const btTransform at_a = way_a_.at(part), at_b = way_b_.at(part);
    double least = BT_LARGE_FLOAT;
    narrow(*a_.triggers, at_a, *b_.solids, at_b, least);
    narrow(*b_.triggers, at_b, *a_.solids, at_a, least);
    return least;
  }

 private:
  void narrow(const ShapeSet& triggers, const btTransform& at_triggers, const ShapeSet& solids, const btTransform& at_solids, double& least) const {
    const btVector3 reach(reach_, reach_, reach_);
    for (const Piece& trigger : triggers.pieces()) {
      const btTransform at = at_triggers * trigger.local;
      btVector3 low, high;
      trigger.shape->getAabb(at, low, high);
      for (const Piece& solid : solids.pieces())
        each_convex(solid, at_solids * solid.local, low - reach, high + reach, [&](const btConvexShape& shape, const btTransform& at_shape) {
          btVector3 near_low, near_high;
          shape.getAabb(at_shape, near_low, near_high);
          each_convex(trigger, at, near_low - reach, near_high + reach, [&](const btConvexShape& other, const btTransform& at_other) {
            if (const auto found = closest(shape, at_shape, other, at_other, std::max(least, 0.0))) least = std::min(least, found->distance);
          });
        });
    }
  }

  const BodyState &a_, &b_;
  Way way_a_, way_b_;
  double reach_;  // triangles farther away play no part
};

// Where between two parts of the step they begin or cease to touch, by Ridders' method: each round halves what is left, then
// looks where the three gaps known by then say that it is closed.
double edge(const Gap& gap, double outside, double inside) {
  double out = gap.at(outside), in = gap.at(inside);
  if (out <= 0) return outside;
  if (in > 0) return inside;
  const auto look = [&](double part) {
    const double apart = gap.at(part);
    (apart > 0 ? outside : inside) = part;
    (apart > 0 ? out : in) = apart;
    return apart;
  };
  double best = inside;
  while (std::abs(outside - inside) > kInstant) {
    const double half = (inside - outside) / 2, product = out * in;
    best = outside + half;
    const double apart = look(best);
    if (std::abs(apart) < kTouch) break;
    best += half * apart / std::sqrt(apart * apart - product);
    if (std::abs(look(best)) < kTouch) break;
  }
  return best;
}

}  // namespace

double first_touch(const BodyState& a, const BodyState& b, double seconds, double inside) {
  return edge(Gap(a, b, seconds), 0, inside) * seconds;
}

double last_touch(const BodyState& a, const BodyState& b, double seconds, double inside) {
  return edge(Gap(a, b, seconds), 1, inside) * seconds;
}

}  // namespace tumble
