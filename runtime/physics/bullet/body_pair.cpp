#include "physics/bullet/body_pair.h"

#include <algorithm>

#include "physics/bullet/contacts.h"
#include "physics/bullet/materials.h"
#include "physics/bullet/same_points.h"

namespace tumble {

namespace {

using dynamics::Contact;
using dynamics::TouchPoint;

// A look holds until the bodies have gone this far, m, or this part of the smaller one.
constexpr double kMostTravel = 3e-3, kMostTravelPart = 0.01;

double smaller_extent(const BodyState& a, const BodyState& b) {
  if (!a.dynamic() || !b.dynamic()) return a.dynamic() ? a.extent : b.extent;
  return std::min(a.extent, b.extent);
}

bool stays(const BodyState& body) { return !body.dynamic() || body.in_heap; }

// A corner stays where it is on its own body, a crossing of edges on one of the two.
double moved(const TouchPoint& old, const TouchPoint& made) { return std::min(distance(old.arm_a, made.arm_a), distance(old.arm_b, made.arm_b)); }

}  // namespace

BodyPair::~BodyPair() {
  if (!kept_) return;
  if (kept_->pair) lose_contact(*kept_->pair);
  const std::size_t index = kept_->index;
  if (index >= found_.size() || found_[index] != kept_.get()) return;
  found_[index] = found_.back();
  found_[index]->index = index;
  found_.pop_back();
}

void BodyPair::add_to_found() {
  kept_->index = found_.size();
  found_.push_back(kept_.get());
}

bool BodyPair::still_holds(double fall) const {
  if (margin_ < 0 || placed_ != a_.placed + b_.placed) return false;
  const double travel = a_.travel + b_.travel - travel_;
  if (!(a_.ahead + b_.ahead + fall + travel <= margin_)) return false;
  // Normals and points stay as they are for what may be a little off.
  return !near_ || (stays(a_) && stays(b_) && travel <= std::min(kMostTravel, kMostTravelPart * smaller_extent(a_, b_)));
}

void BodyPair::look_anew(double margin) {
  pairs::Manifold found;
  pairs::collide(a_.convex, a_.convex_pose(), b_.convex, b_.convex_pose(), margin, cache_, found);
  margin_ = margin;
  travel_ = a_.travel + b_.travel;
  placed_ = a_.placed + b_.placed;
  near_ = found.count > 0;
  if (!near_ && !kept_) return;
  if (!kept_) {
    kept_ = std::make_unique<KeptContact>();
    kept_->a = &a_;
    kept_->b = &b_;
    kept_->margin = &margin_;
  }
  write(found);
}

void BodyPair::write(const pairs::Manifold& found) {
  Contact& contact = kept_->contact;
  if (found.count == 0) {
    if (kept_->pair) told(*kept_->pair);  // of the last touch, which its exit tells too
    contact.count = 0;
    contact.grip = contact.roll = {};
    contact.lift = 0;
    return;
  }
  TouchPoint old[Contact::kMostPoints];
  const int count = contact.count;
  std::copy(contact.points, contact.points + count, old);
  const Vec3 normal = contact.normal, roll = contact.tangent_1 * contact.roll.x + contact.tangent_2 * contact.roll.y, grip = contact.tangent_1 * contact.grip.x + contact.tangent_2 * contact.grip.y;
  const bool alike = count > 0 && dot(normal, found.normal) >= kSameNormal;

  contact.set_normal(found.normal);
  contact.grip = alike ? Vec3{dot(grip, contact.tangent_1), dot(grip, contact.tangent_2), contact.grip.z} : Vec3{};
  contact.roll = alike ? Vec3{dot(roll, contact.tangent_1), dot(roll, contact.tangent_2), contact.roll.z} : Vec3{};
  const Surface surface = surface_between(a_, b_);
  contact.friction = surface.friction;
  contact.count = found.count;
  for (int i = 0; i < found.count; ++i) {
    TouchPoint& point = contact.points[i];
    point.arm_a = found.points[i].on_a - a_.center.position;
    point.arm_b = found.points[i].on_b - b_.center.position;
    point.separation = found.points[i].separation;
    point.restitution = surface.restitution;
    point.impulse = 0;
  }
  if (!alike) {
    contact.lift = 0;
    return;
  }
  match_points(count, contact.count, kSamePoint * smaller_extent(a_, b_), [&](int i, int k) { return moved(old[i], contact.points[k]); },
               [&](int i, int k) { contact.points[k].impulse = old[i].impulse; });
}

}  // namespace tumble
