// The hits of a contact: when it meets, and what that gives. Between kick and drift, velocities are the means over the
// substep; a point's gap at a time t in it is gap - (c - p h / 2) t - p t^2 / 2, where c is how fast it closes by those
// velocities and p what forces add.
#include <algorithm>

#include "physics/dynamics/contact.h"

namespace tumble::dynamics {

namespace {

// Slower hits do not bounce, m/s.
constexpr double kSlowestBounce = 0.1;
// Points of a body that meet within this of each other meet together, m; and so near they are met.
constexpr double kTogether = 1e-4, kTouching = 1e-9;
constexpr int kHitRounds = 30;
constexpr double kHitSettled = 1e-6;

}  // namespace

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

bool Contact::hits_next(const TouchPoint& point) const {
  return point.restitution > 0 && point.impulse == 0 && point.hit == 0 && std::abs(point.separation) <= kTouching && closing(point) >= kSlowestBounce;
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

}  // namespace tumble::dynamics
