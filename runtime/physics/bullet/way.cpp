#include "physics/bullet/way.h"

namespace tumble {

namespace {

// The velocities tell of the way where their mean leads to its end, up to this part of it and of what they differ by.
constexpr double kFits = 0.25;

btTransform start_of(const BodyState& body) {
  if (body.awake()) return body.last_good;
  return body.moving ? body.path.from : body.rigid->getWorldTransform();
}

}  // namespace

Vec3 straight_way(const BodyState& body) {
  return from_bullet(body.rigid->getWorldTransform().getOrigin() - start_of(body).getOrigin());
}

Way::Way(const BodyState& body, double seconds) {
  const Pose from = from_bullet(start_of(body)), to = from_bullet(body.rigid->getWorldTransform());
  from_ = from.position;
  along_ = to.position - from.position;
  turned_ = from.rotation;
  Vec3 mean, change;
  if (body.awake()) {
    const Vec3 end = from_bullet(body.rigid->getLinearVelocity());
    mean = (body.start_velocity + end) * (seconds / 2);
    change = (end - body.start_velocity) * seconds;
    spin_ = (body.start_turning + from_bullet(body.rigid->getAngularVelocity())) * (seconds / 2);
  } else if (body.moving) {
    mean = along_;
    change = from_bullet(body.path.ramp) * seconds;
    spin_ = from_bullet(body.path.turning) * seconds;
  }
  if (distance(along_, mean) <= kFits * (length(along_) + length(change))) {
    bend_ = change / 2;
    along_ = along_ - bend_;
  }
  rest_ = to.rotation * conjugate(from.rotation);
  if (!(spin_ == Vec3{})) rest_ = rest_ * conjugate(axis_angle(spin_, length(spin_)));
}

btTransform Way::at(double part) const {
  Quat turn = slerp({}, rest_, part);
  if (!(spin_ == Vec3{})) turn = turn * axis_angle(spin_, length(spin_) * part);
  return to_bullet(Pose{from_ + (along_ + bend_ * part) * part, normalized(turn * turned_)});
}

}  // namespace tumble
