// The friction of a contact.
#include <algorithm>

#include "physics/dynamics/contact.h"

namespace tumble::dynamics {

namespace {

// A square that presses evenly resists twist by 0.7652 of its half side (the mean distance of its points from its
// centre), four corners alone by 1.4142 of it.
constexpr double kEvenPressure = 0.765196 / 1.414214;
// So many times what friction can do would bring it to rest: it slides. And from what part of one motion the other counts.
constexpr double kFarFromRest = 6, kBoth = 0.05;
// Gauss's places and weights for a mean from 0 to 1.
constexpr int kGrid = 4;
constexpr double kPlaces[kGrid] = {0.0694318442, 0.3300094782, 0.6699905218, 0.9305681558};
constexpr double kWeights[kGrid] = {0.1739274226, 0.3260725774, 0.3260725774, 0.1739274226};

}  // namespace

// One friction for all points, at the middle of what presses: two tangents and the twist, together in one ellipsoid. A
// friction at each point would let a box that slides turn as on four nails.
Contact::Place Contact::friction_place(double TouchPoint::*pressing) const {
  double whole = 0, weights[kMostPoints];
  for (int i = 0; i < count; ++i) whole += points[i].*pressing;
  for (int i = 0; i < count; ++i) weights[i] = whole > 0 ? points[i].*pressing / whole : 1.0 / count;
  Vec3 place, middle;  // one place for both, or friction across a gap would turn them
  for (int i = 0; i < count; ++i) {
    place += (a->position + points[i].arm_a + b->position + points[i].arm_b) * (weights[i] / 2);
    middle += points[i].arm_a * weights[i];
  }
  double spread = 0;
  for (int i = 0; i < count && count > 1; ++i) spread += weights[i] * length(points[i].arm_a - middle);
  return {place - a->position, place - b->position, kEvenPressure * spread};
}

void Contact::place_friction() {
  placed_ = true;
  const Place place = friction_place(&TouchPoint::last);
  arm_a_ = place.arm_a;
  arm_b_ = place.arm_b;
  lever_ = place.lever;
  // What rides on a turning carrier goes round with it: its way in a substep is that of the middle of it, or it would
  // spiral outwards.
  const auto ride = [this](const Mover& rider, Vec3 hub, Vec3& arm, const Mover& carrier, Vec3& on_carrier) {
    if (carrier.pushable || carrier.spin == Vec3{}) return;
    on_carrier += (rider.velocity_at(hub) - carrier.velocity) * ahead_;
    arm += cross(rider.spin, hub) * ahead_;
  };
  ride(*a, points[0].corner_a ? arm_a_ : points[0].hub_a, arm_a_, *b, arm_b_);
  ride(*b, points[0].corner_b ? arm_b_ : points[0].hub_b, arm_b_, *a, arm_a_);

  const Vec3 linear[3] = {tangent_1, tangent_2, {}};
  const Vec3 angular_a[3] = {cross(arm_a_, tangent_1), cross(arm_a_, tangent_2), normal * lever_};
  const Vec3 angular_b[3] = {cross(arm_b_, tangent_1), cross(arm_b_, tangent_2), normal * lever_};
  const auto speed = [&](int i, int j) {
    return dot(scaled(a->inverse_mass + b->inverse_mass, linear[i]), linear[j]) + dot(a->inverse_inertia * angular_a[i], angular_a[j]) +
           dot(b->inverse_inertia * angular_b[i], angular_b[j]);
  };
  slip_ = {speed(0, 0), speed(1, 1), speed(2, 2), speed(0, 1), speed(0, 2), speed(1, 2)};
  if (slip_.zz < 1e-9 * std::max(slip_.xx, slip_.yy)) {  // a single point, or no way to twist
    lever_ = 0;
    slip_.xz = slip_.yz = 0;
    slip_.zz = std::max(slip_.xx, slip_.yy);
  }
  stop_ = inverse(slip_);
  stiffest_ = std::max({slip_.xx + std::abs(slip_.xy) + std::abs(slip_.xz), slip_.yy + std::abs(slip_.xy) + std::abs(slip_.yz),
                        slip_.zz + std::abs(slip_.xz) + std::abs(slip_.yz)});
}

Vec3 Contact::slip() const {
  const Vec3 v = a->velocity_at(arm_a_) - b->velocity_at(arm_b_) - belt;
  return {dot(v, tangent_1), dot(v, tangent_2), lever_ * dot(normal, a->spin - b->spin)};
}

void Contact::drag(Vec3 change) {
  grip += change;
  const Vec3 along = tangent_1 * change.x + tangent_2 * change.y, about = normal * change.z;
  a->push(along, cross(arm_a_, along) + about);
  b->push(-along, -cross(arm_b_, along) - about);
}

// The friction f of all within mu N that takes most power from the slip s: f = project(f - s / L) for any L above the
// largest eigenvalue (projected gradient). Where sticking is within reach, at once.
void Contact::solve_friction() {
  const double most = friction * pressing();
  if (most <= 0 && grip == Vec3{}) return;
  if (!placed_) place_friction();
  if (lever_ <= 0 && grip.z != 0) drag({0, 0, -grip.z});  // of the first half, with which one point is left now
  const auto within = [most](Vec3 f) {
    const double size = length(f);
    return size > most ? f * (most / size) : f;
  };
  const Vec3 now{grip.x, grip.y, lever_ > 0 ? grip.z / lever_ : 0}, moving = slip();
  Vec3 next = now - stop_ * moving;
  const double wanted = length(next);
  if (wanted > most) {
    next = within(next);
    for (int round = 0; round < 2 && stiffest_ > 0; ++round) next = within(next - (moving + slip_ * (next - now)) / stiffest_);
    // Far from coming to rest, and both sliding and twisting: each part of the area brakes against its own motion.
    const double along = std::sqrt(moving.x * moving.x + moving.y * moving.y), about = std::abs(moving.z);
    if (lever_ > 0 && wanted > kFarFromRest * most && about > kBoth * along && along > kBoth * about) next = evenly(moving) * most;
  }
  const Vec3 change = next - now;
  drag({change.x, change.y, lever_ > 0 ? change.z * lever_ : 0});
}

void Contact::twist(Vec3 change) {
  roll += change;
  const Vec3 moment = tangent_1 * change.x + tangent_2 * change.y + normal * change.z;
  a->push({}, moment);
  b->push({}, -moment);
}

// Moments against the turn of one body over the other, each up to a lever times what presses: rolling by both tangents
// together, spinning on the spot about the normal.
void Contact::solve_rolling() {
  const double presses = pressing();
  const Vec3 turning = a->spin - b->spin, axes[3] = {tangent_1, tangent_2, normal};
  double wanted[3] = {roll.x, roll.y, roll.z};
  for (int i = 0; i < 3; ++i) {
    const double ease = dot(a->inverse_inertia * axes[i] + b->inverse_inertia * axes[i], axes[i]);
    if (ease > 0) wanted[i] -= dot(turning, axes[i]) / ease;
  }
  const double most = rolling * presses, size = std::hypot(wanted[0], wanted[1]), part = size > most ? most / size : 1;
  const double spin = std::clamp(wanted[2], -spinning * presses, spinning * presses);
  twist(Vec3{wanted[0] * part, wanted[1] * part, spin} - roll);
}

// The friction of an area that presses evenly, over mu N, against a slip along both tangents and, times the lever, about
// the normal: the mean of what its parts do, over the quadrilateral of the points. (The limit surface of
// S. Goyal, A. Ruina and J. Papadopoulos, Wear 143, 1991; the ellipsoid is it only where one of both motions is small.)
Vec3 Contact::evenly(Vec3 moving) const {
  double x[kMostPoints], y[kMostPoints], angle[kMostPoints];
  int order[kMostPoints];
  Vec3 middle;
  for (int i = 0; i < count; ++i) middle += points[i].arm_a / count;
  for (int i = 0; i < count; ++i) {
    const Vec3 off = points[i].arm_a - middle;
    x[i] = dot(off, tangent_1);
    y[i] = dot(off, tangent_2);
    angle[i] = std::atan2(y[i], x[i]);
    int at = i;  // round the middle, by insertion
    for (; at > 0 && angle[order[at - 1]] > angle[i]; --at) order[at] = order[at - 1];
    order[at] = i;
  }
  const auto corner = [&](const double* of, int k) { return of[order[std::min(k, count - 1)]]; };
  const double turning = moving.z / lever_;
  Vec3 sum;
  for (int i = 0; i < kGrid; ++i)
    for (int k = 0; k < kGrid; ++k) {
      const double u = kPlaces[i], v = kPlaces[k], weight = kWeights[i] * kWeights[k];
      const auto at = [&](const double* of) {
        return (1 - v) * ((1 - u) * corner(of, 0) + u * corner(of, 1)) + v * ((1 - u) * corner(of, 3) + u * corner(of, 2));
      };
      // The normal turns the first tangent towards the second.
      const double px = at(x), py = at(y), vx = moving.x - turning * py, vy = moving.y + turning * px, speed = std::sqrt(vx * vx + vy * vy);
      if (speed <= 0) continue;
      sum += Vec3{-vx, -vy, -(px * vy - py * vx) / lever_} * (weight / speed);
    }
  return sum;
}

}  // namespace tumble::dynamics
