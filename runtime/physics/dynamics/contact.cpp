#include "physics/dynamics/contact.h"

#include <algorithm>

#include "physics/dynamics/rotation.h"

namespace tumble::dynamics {

namespace {

// A rim rolls where its axis is this far from upright (sine), and where it touched near there before (cosine).
constexpr double kLeastTilt = 0.02, kSameSide = 0.7;

// A contact swings this many times in a substep, so that its stiffness grows with the number of substeps.
constexpr double kContactFrequency = 0.25;
constexpr double kContactDamping = 10;
// Overlaps are taken back no faster than this, m/s: at 3 a wall of bricks bursts. Where that lifts a body against its
// weight it gives energy, so that among bodies it is done with this much less.
constexpr double kFastestPush = 1, kLessUpwards = 0.6;

// How fast a contact's spring is moved on to where its bodies just touch, s: by far slower than it gives way itself, so that
// the two do not swing against each other (20 h / (2 pi 0.25) = 0.05 s at 4 substeps); how fast it is moved back, and given
// up where nothing presses. Up to how far, and to what is left to touch by, m; and for no deeper overlap than so, since
// what was put into another is pushed out anyway, and is not to be thrown out.
constexpr double kRaiseTime = 1, kLowerTime = 0.25, kForgetTime = 0.1, kMostLift = 5e-3, kLeastTouch = 5e-5, kDeepest = 2e-3;

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

Softness contact_softness(double h) { return softness(kContactFrequency / h, kContactDamping, h); }

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

double Contact::nearest() const {
  double least = INFINITY;
  for (int i = 0; i < count; ++i) least = std::min(least, points[i].separation);
  return least;
}

void Contact::scale(double factor) {
  for (int i = 0; i < count; ++i) points[i].impulse *= factor;
  grip = grip * factor;
  roll = roll * factor;
}

void Contact::begin(double h) {
  for (int i = 0; i < count; ++i) {
    points[i].last = points[i].impulse;
    points[i].impulse = 0;
    points[i].hit = 0;
  }
  last_grip = grip;
  last_roll = roll;
  grip = roll = {};
  placed_ = false;
  ahead_ = h / 2;
  if (radius_a > 0) return;  // see meet()
  note_mobility();
  note_closing();
}

void Contact::note_mobility() {
  for (int i = 0; i < count; ++i) {
    TouchPoint& point = points[i];
    point.mobility = mobility_along(*a, normal, cross(point.arm_a + slid_a_, normal)) +
                     mobility_along(*b, normal, cross(point.arm_b + slid_b_, normal));
  }
}

// Two balls: from where they are and how they move now, the place where they meet within h, or the nearest now.
void Contact::meet(double h) {
  const Vec3 apart = (a->position + center_a) - (b->position + center_b);
  const Vec3 moving = a->velocity - b->velocity;
  const double reach = radius_a + radius_b, c = dot(apart, apart) - reach * reach, half_b = dot(apart, moving), v2 = dot(moving, moving);
  const double under = half_b * half_b - v2 * c;
  double time = 0;
  if (c > 0 && half_b < 0 && under > 0) time = std::min(h, c / (-half_b + std::sqrt(under)));
  const Vec3 there = apart + moving * time, grip_now = tangent_1 * last_grip.x + tangent_2 * last_grip.y;
  if (length(there) > 0) set_normal(normalized(there));
  last_grip = {dot(grip_now, tangent_1), dot(grip_now, tangent_2), 0};
  TouchPoint& point = points[0];
  point.arm_a = center_a - normal * radius_a;
  point.arm_b = center_b + normal * radius_b;
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

void Contact::warm_start() {
  if (count == 0) return;
  for (int i = 0; i < count; ++i) {
    const double part = points[i].last / 2;
    if (part == 0) continue;
    points[i].impulse += part;
    push(points[i], part);
  }
  if (!(last_roll == Vec3{}) && (rolling > 0 || spinning > 0)) twist(last_roll / 2);
  if (friction <= 0 || last_grip == Vec3{}) return;
  if (!placed_) place_friction();
  drag(Vec3{last_grip.x, last_grip.y, lever_ > 0 ? last_grip.z : 0} / 2);  // where one point is left, nothing holds a twist
}

double Contact::solve(double h, const Softness* soft) {
  // Twice, so that the four corners of a box share a blow before it is handed on.
  const double changed = solve_normals(h, soft);
  if (count > 1) solve_normals(h, soft);
  if (friction > 0) solve_friction();
  if (rolling > 0 || spinning > 0) solve_rolling();
  return changed;
}

double Contact::solve_normals(double h, const Softness* soft) {
  double changed = 0;
  for (int i = 0; i < count; ++i) {
    TouchPoint& point = points[i];
    if (point.mobility <= 0) continue;
    double bias = 0, mass_scale = 1, impulse_scale = 0;
    const double apart = point.separation - lift;
    // What is still apart after the drift is the next substep's business.
    if (!soft && ((apart > 0 && point.impulse == 0) || hits_next(point))) continue;
    if (soft && apart > 0) {
      bias = apart / h;
    } else if (soft) {
      bias = std::max(soft->rate * apart, -fastest_push);
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

// The points of both bodies come apart sideways as these slide and turn. Which of the two is the place of the contact?
// 1 is a's: of a corner against what has none, and else that of the body whose centre is nearer.
double Contact::carried_by_a(const TouchPoint& point) const {
  if (!a->pushable || !b->pushable) return a->pushable ? 1 : 0;
  if (point.corner_a != point.corner_b) return point.corner_a ? 1 : 0;
  const double far_a = dot(point.arm_a, point.arm_a), far_b = dot(point.arm_b, point.arm_b);
  return far_a + far_b > 0 ? far_b / (far_a + far_b) : 0.5;
}

std::optional<Vec3> rolled(Vec3 spoke, Vec3 axis, Vec3 out) {
  const Vec3 across = out - axis * dot(out, axis);
  const double most = length(across), radius = length(spoke);
  if (axis == Vec3{} || most <= kLeastTilt || dot(across, spoke) <= kSameSide * most * radius) return {};
  return across * (radius / most);
}

void Contact::drifted(double h) {
  const auto carry = [&](const Mover& mover, Vec3 axis, Vec3 out, Vec3& hub, Vec3& arm) {
    const Vec3 turn = mover.spin * h, spoke = arm - hub;
    hub += turned_off(turn, hub);
    // Of what does not turn with it, only what lifts or lowers the point.
    arm = hub + rolled(spoke, axis, out).value_or(spoke + out * dot(out, cross(turn, spoke)));
  };
  if (!(axis_a == Vec3{})) axis_a += turned_off(a->spin * h, axis_a);
  if (!(axis_b == Vec3{})) axis_b += turned_off(b->spin * h, axis_b);
  for (int i = 0; i < count; ++i) {
    TouchPoint& point = points[i];
    if (a->pushable || !(a->spin == Vec3{})) carry(*a, axis_a, -normal, point.hub_a, point.arm_a);
    if (b->pushable || !(b->spin == Vec3{})) carry(*b, axis_b, normal, point.hub_b, point.arm_b);
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

// All points alike: to move each on by its own depth would help a tower to sway.
void Contact::raise(double seconds) {
  double press = 0, moment = 0;
  for (int i = 0; i < count; ++i) {
    press += points[i].impulse;
    moment += points[i].impulse * points[i].separation;
  }
  if (press > 0) {
    const double deep = std::min(-moment / press, kDeepest) - kLeastTouch;
    lift = std::clamp(lift + deep * std::min(1.0, seconds / (deep > 0 ? kRaiseTime : kLowerTime)), 0.0, kMostLift);
  } else {
    lift *= std::max(0.0, 1 - seconds / kForgetTime);
  }
}

}  // namespace tumble::dynamics
