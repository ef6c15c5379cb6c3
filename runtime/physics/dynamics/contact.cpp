#include "physics/dynamics/contact.h"

#include <algorithm>

#include "physics/dynamics/rotation.h"

namespace tumble::dynamics {

namespace {

// Overlaps are taken back no faster than this, m/s: at 3 a wall of bricks bursts. Where that lifts a body against its
// weight it gives energy, so that among bodies it is done with this much less.
constexpr double kFastestPush = 1, kLessUpwards = 0.6;
// Slower hits do not bounce, m/s.
constexpr double kSlowestBounce = 0.1;
// Points of a body that meet within this of each other meet together, m; and so near they are met.
constexpr double kTogether = 1e-4, kTouching = 1e-9;
constexpr int kHitRounds = 30;
constexpr double kHitSettled = 1e-6;
// A square that presses evenly resists twist by 0.7652 of its half side (the mean distance of its points from its
// centre), four corners alone by 1.4142 of it.
constexpr double kEvenPressure = 0.765196 / 1.414214;
// So many times what friction can do would bring it to rest: it slides. And from what part of one motion the other counts.
constexpr double kFarFromRest = 6, kBoth = 0.05;
// Gauss's places and weights for a mean from 0 to 1.
constexpr int kGrid = 4;
constexpr double kPlaces[kGrid] = {0.0694318442, 0.3300094782, 0.6699905218, 0.9305681558};
constexpr double kWeights[kGrid] = {0.1739274226, 0.3260725774, 0.3260725774, 0.1739274226};

double mobility_along(const Mover& mover, Vec3 linear, Vec3 angular) {
  return dot(scaled(mover.inverse_mass, linear), linear) + dot(mover.inverse_inertia * angular, angular);
}

// How far a point at an arm goes as it is turned: of small turns to the third order, which leaves its distance as it was.
Vec3 turned_off(Vec3 turn, Vec3 arm) {
  const Vec3 first = cross(turn, arm);
  if (dot(turn, turn) < 0.01) {
    const Vec3 second = cross(turn, first);
    return first + second / 2 + cross(turn, second) / 6;
  }
  return turned_by({}, turn) * arm - arm;
}

}  // namespace

Softness softness(double frequency, double damping_ratio, double h) {
  const double omega = 2 * kPi * frequency, a1 = 2 * damping_ratio + h * omega, a2 = h * omega * a1, a3 = 1 / (1 + a2);
  return {omega / a1, a2 * a3, a3};
}

void Contact::set_normal(Vec3 n) {
  normal = n;
  // Crossed with the axis that it is farthest from: never near zero, and the same from step to step.
  const Vec3 axis = std::abs(n.x) < 0.577 ? Vec3{1, 0, 0} : std::abs(n.y) < 0.577 ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
  tangent_1 = normalized(cross(n, axis));
  tangent_2 = cross(n, tangent_1);
}

void Contact::limit_push() {
  const Vec3 pull = a->acceleration;
  const double size = a->pushable && b->pushable ? length(pull) : 0;
  fastest_push = kFastestPush * (size > 0 ? 1 - kLessUpwards * std::abs(dot(normal, pull)) / size : 1);
}

double Contact::closing(const TouchPoint& point) const {
  return -dot(normal, a->velocity_at(point.arm_a + slid_a_) - b->velocity_at(point.arm_b + slid_b_));
}

void Contact::push(const TouchPoint& point, double impulse) {
  const Vec3 along = normal * impulse;
  a->push(along, cross(point.arm_a + slid_a_, along));
  b->push(-along, -cross(point.arm_b + slid_b_, along));
}

double Contact::pressing() const {
  double sum = 0;
  for (int i = 0; i < count; ++i) sum += points[i].impulse + points[i].hit;
  return sum;
}

void Contact::scale(double factor) {
  for (int i = 0; i < count; ++i) points[i].impulse *= factor;
  grip = grip * factor;
}

void Contact::begin(double h) {
  for (int i = 0; i < count; ++i) {
    points[i].last = points[i].impulse;
    points[i].impulse = 0;
    points[i].hit = 0;
  }
  last_grip = grip;
  grip = {};
  placed_ = false;
  ahead_ = h / 2;
  if (radius_a > 0) return;  // see meet()
  note_mobility();
  note_closing();
}

void Contact::note_mobility() {
  for (int i = 0; i < count; ++i) {
    TouchPoint& point = points[i];
    point.mobility = mobility_along(*a, normal, cross(point.arm_a + slid_a_, normal)) + mobility_along(*b, normal, cross(point.arm_b + slid_b_, normal));
  }
}

// Two balls: from where they are and how they move now, the place where they meet within h, or the nearest now.
void Contact::meet(double h) {
  const Vec3 apart = (a->pushable ? a->position : fixed_a) - (b->pushable ? b->position : fixed_b);
  const Vec3 moving = a->velocity - b->velocity;
  const double reach = radius_a + radius_b, c = dot(apart, apart) - reach * reach, half_b = dot(apart, moving), v2 = dot(moving, moving);
  const double under = half_b * half_b - v2 * c;
  double time = 0;
  if (c > 0 && half_b < 0 && under > 0) time = std::min(h, c / (-half_b + std::sqrt(under)));
  const Vec3 there = apart + moving * time, grip_now = tangent_1 * last_grip.x + tangent_2 * last_grip.y;
  if (length(there) > 0) set_normal(normalized(there));
  last_grip = {dot(grip_now, tangent_1), dot(grip_now, tangent_2), 0};
  TouchPoint& point = points[0];
  point.arm_a = normal * -radius_a;
  point.arm_b = normal * radius_b;
  point.separation = dot(apart, normal) - reach;
  note_mobility();
  placed_ = false;
}

void Contact::foresee(double h) {
  if (radius_a > 0) {
    meet(h);
    const auto pull = [](const Mover& mover) { return mover.pushable ? mover.acceleration : Vec3{}; };
    points[0].pull = -dot(normal, pull(*a) - pull(*b));
    return;
  }
  for (int i = 0; i < count; ++i) points[i].pull = (closing(points[i]) - closing_[i]) / (h / 2);
}

// ---- hits. Between kick and drift, velocities are the means over the substep; a point's gap at a time in it is
// gap - (c - p h / 2) t - p t^2 / 2, where c is how fast it closes by those and p what forces add.

double Contact::closing_at(const TouchPoint& point, double time, double h) const { return closing(point) + point.pull * (time - h / 2); }

double Contact::gap_at(const TouchPoint& point, double time, double h) const {
  return point.separation - (closing_at(point, 0, h) + point.pull * time / 2) * time;
}

double Contact::next_hit(double from, double h) {
  double first = INFINITY;
  if (radius_a > 0) meet(h);
  for (int i = 0; i < count; ++i) {
    const TouchPoint& point = points[i];
    if (point.restitution <= 0 || point.mobility <= 0) continue;
    // From the gap at `from` on, so that what has met and is leaving is not met again.
    const double gap = gap_at(point, from, h), closing = closing_at(point, from, h), pull = point.pull;
    double after = INFINITY;
    if (gap <= 0) after = closing > 0 ? 0 : INFINITY;
    if (gap > 0 || (gap > -kTouching && closing <= 0 && pull > 0)) {
      const double under = closing * closing + 2 * pull * std::max(0.0, gap), root = std::sqrt(std::max(0.0, under));
      // The earlier time at which it is gone: gap = closing t + pull t^2 / 2.
      if (gap > 0 && under >= 0 && closing + root > 0) after = 2 * gap / (closing + root);
      else if (gap <= 0 && pull > 0) after = -2 * closing / pull;
    }
    if (from + after <= h && closing_at(point, from + after, h) >= kSlowestBounce) first = std::min(first, from + after);
  }
  return first;
}

bool Contact::bounces() const {
  return std::any_of(points, points + count, [](const TouchPoint& point) { return point.restitution > 0; });
}

bool Contact::meets(double time, double h) {
  if (radius_a > 0) meet(h);
  return std::any_of(points, points + count, [&](const TouchPoint& point) {
    return point.restitution > 0 && point.mobility > 0 && gap_at(point, time, h) <= kTogether && closing_at(point, time, h) >= kSlowestBounce;
  });
}

void Contact::aim_hit(double time, double h) {
  if (radius_a == 0) {
    // By then what slides has slid: both levers reach to the place where they meet.
    const Vec3 slid = (a->velocity - b->velocity) * time, aside = slid - normal * dot(slid, normal);
    const double part = carried_by_a(points[0]);
    slid_b_ = aside * part;
    slid_a_ = aside * (part - 1);
    note_mobility();
  }
  for (int i = 0; i < count; ++i) {
    const TouchPoint& point = points[i];
    const double closing = closing_at(point, time, h);
    const bool meets = point.mobility > 0 && gap_at(point, time, h) <= kTogether;
    leave_[i] = !meets ? -1 : closing >= kSlowestBounce ? point.restitution * closing : 0;
  }
}

double Contact::hit(double time, double h) {
  double given[kMostPoints] = {}, first = 0;
  for (int round = 0; round < kHitRounds; ++round) {
    double changed = 0, largest = 0;
    for (int i = 0; i < count; ++i) {
      TouchPoint& point = points[i];
      if (leave_[i] < 0) continue;
      const double change = std::max(-point.hit, (leave_[i] + closing_at(point, time, h)) / point.mobility);
      push(point, change);
      point.hit += change;
      given[i] += change;
      changed = std::max(changed, std::abs(change));
      largest = std::max(largest, std::abs(given[i]));
      if (round == 0) first = std::max(first, std::abs(change) * point.mobility);
    }
    if (count == 1 || changed <= kHitSettled * largest) break;
  }
  return first;
}

void Contact::note_closing() {
  for (int i = 0; i < count; ++i) closing_[i] = closing(points[i]);
}

void Contact::end_hit() {
  slid_a_ = slid_b_ = {};
  if (radius_a == 0) note_mobility();
}

// Its gap at that time is as it was, and from there on it closes differently: as if it had always done so, from another gap.
void Contact::hit_elsewhere(double time, double h) {
  if (radius_a > 0) return meet(h);
  for (int i = 0; i < count; ++i) {
    TouchPoint& point = points[i];
    point.separation += time * (closing(point) - closing_[i]);
    const double shown = dot((a->position + point.arm_a) - (b->position + point.arm_b), normal);
    point.arm_a += normal * (point.separation - shown);
  }
}

// ---- rest

void Contact::warm_start() {
  for (int i = 0; i < count; ++i) {
    const double part = points[i].last / 2;
    if (part == 0) continue;
    points[i].impulse += part;
    push(points[i], part);
  }
  if (friction <= 0 || last_grip == Vec3{}) return;
  if (!placed_) place_friction();
  drag(last_grip / 2);
}

double Contact::solve(double h, const Softness* soft) {
  // Twice, so that the four corners of a box share a blow before it is handed on.
  const double changed = solve_normals(h, soft);
  if (count > 1) solve_normals(h, soft);
  if (friction > 0) solve_friction();
  return changed;
}

double Contact::solve_normals(double h, const Softness* soft) {
  double changed = 0;
  for (int i = 0; i < count; ++i) {
    TouchPoint& point = points[i];
    if (point.mobility <= 0) continue;
    double bias = 0, mass_scale = 1, impulse_scale = 0;
    // What is still apart after the drift is the next substep's business.
    if (!soft && point.separation > 0 && point.impulse == 0) continue;
    if (soft && point.separation > 0) {
      bias = point.separation / h;
    } else if (soft) {
      bias = std::max(soft->rate * point.separation, -fastest_push);
      mass_scale = soft->mass_scale;
      impulse_scale = soft->impulse_scale;
    }
    const double wanted = mass_scale * (closing(point) - bias) / point.mobility - impulse_scale * point.impulse;
    const double total = std::max(0.0, point.impulse + wanted);
    push(point, total - point.impulse);
    changed = std::max(changed, std::abs(total - point.impulse) * point.mobility);
    point.impulse = total;
  }
  return changed;
}

// One friction for all points, at the middle of what presses: two tangents and the twist, together in one ellipsoid. A
// friction at each point would let a box that slides turn as on four nails.
void Contact::place_friction() {
  placed_ = true;
  double whole = 0, weights[kMostPoints];
  for (int i = 0; i < count; ++i) whole += points[i].last;
  for (int i = 0; i < count; ++i) weights[i] = whole > 0 ? points[i].last / whole : 1.0 / count;
  Vec3 place;  // one for both, or friction across a gap would turn them
  for (int i = 0; i < count; ++i) place += (a->position + points[i].arm_a + b->position + points[i].arm_b) * (weights[i] / 2);
  arm_a_ = place - a->position;
  arm_b_ = place - b->position;
  // What rides on a turning carrier goes round with it: its way in a substep is that of the middle of it, or it would
  // spiral outwards.
  if (!b->pushable && !(b->spin == Vec3{})) arm_b_ += (a->velocity_at(points[0].hub_a) - b->velocity) * ahead_;
  if (!a->pushable && !(a->spin == Vec3{})) arm_a_ += (b->velocity_at(points[0].hub_b) - a->velocity) * ahead_;
  Vec3 middle;
  for (int i = 0; i < count; ++i) middle += points[i].arm_a * weights[i];
  double spread = 0;
  for (int i = 0; i < count; ++i) spread += weights[i] * length(points[i].arm_a - middle);
  lever_ = kEvenPressure * spread;

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

// The points of both bodies come apart sideways as these slide and turn. Which of the two is the place of the contact?
// 1 is a's: of a corner against what has none, and else that of the body whose centre is nearer.
double Contact::carried_by_a(const TouchPoint& point) const {
  if (!a->pushable || !b->pushable) return a->pushable ? 1 : 0;
  if (point.corner_a != point.corner_b) return point.corner_a ? 1 : 0;
  const double far_a = dot(point.arm_a, point.arm_a), far_b = dot(point.arm_b, point.arm_b);
  return far_a + far_b > 0 ? far_b / (far_a + far_b) : 0.5;
}

void Contact::drifted(double h) {
  const auto carry = [&](const Mover& mover, Vec3& hub, Vec3& arm) {
    const Vec3 turn = mover.spin * h, along = turned_off(turn, hub);
    // Of what does not turn with it, only what lifts or lowers the point.
    arm += along + normal * dot(normal, cross(turn, arm - hub));
    hub += along;
  };
  for (int i = 0; i < count; ++i) {
    TouchPoint& point = points[i];
    if (a->pushable) carry(*a, point.hub_a, point.arm_a);
    if (b->pushable || !(b->spin == Vec3{})) carry(*b, point.hub_b, point.arm_b);
    const Vec3 apart = (a->position + point.arm_a) - (b->position + point.arm_b);
    point.separation = dot(apart, normal);
    const Vec3 aside = apart - normal * point.separation;
    const double part = carried_by_a(point);
    // What follows the other body's corner goes on from there.
    point.arm_b += aside * part;
    point.arm_a -= aside * (1 - part);
    if (point.corner_b) point.hub_b = point.arm_b;
    if (point.corner_a) point.hub_a = point.arm_a;
  }
  note_mobility();  // the bodies have turned: what was right before may be less than half of it for a thin one
  placed_ = false;
  ahead_ = 0;
}

void Contact::end() {
  for (int i = 0; i < count; ++i) {
    TouchPoint& point = points[i];
    point.sum += point.impulse + point.hit;
  }
}

}  // namespace tumble::dynamics
