#include "physics/bullet/chase.h"

#include <algorithm>

#include "physics/bullet/convex_pair.h"
#include "physics/pairs/hub.h"

namespace tumble {

namespace {

// From this part of the smaller one's size on a step's way is far.
constexpr double kFar = 0.25;
constexpr double kAhead = 2, kNear = 2e-3;  // of the way in a substep; m

}  // namespace

bool Chase::find_part(const Where& where, Part& out) {
  const BodyState& body = where.body;
  const btCollisionShape* shape = body.rigid->getCollisionShape();
  if (where.part >= 0) return false;
  if (shape->isCompound()) {
    if (where.index < 0 || where.index >= static_cast<int>(body.solids->pieces().size())) return false;
    const Piece& piece = body.solids->pieces()[static_cast<std::size_t>(where.index)];
    shape = piece.shape;
    out.local = from_bullet(piece.local);
  }
  out.fixed = body.center;
  return convex_of(*shape, out.shape);
}

std::optional<Chase> Chase::of(const Where& a, const Where& b, double apart, double seconds) {
  if (apart <= 0) return {};
  const btRigidBody &rigid_a = *a.body.rigid, &rigid_b = *b.body.rigid;
  const double speed = (rigid_a.getLinearVelocity() - rigid_b.getLinearVelocity()).length() +
                       rigid_a.getAngularVelocity().length() * a.body.extent + rigid_b.getAngularVelocity().length() * b.body.extent;
  double size = INFINITY;
  for (const BodyState* body : {&a.body, &b.body})
    if (body->dynamic()) size = std::min(size, body->extent);
  if (speed * seconds < kFar * size) return {};
  Chase chase;
  if (!find_part(a, chase.a_) || !find_part(b, chase.b_)) return {};
  return chase;
}

Pose Chase::Part::pose(const dynamics::Mover& mover) const {
  const bool moves = mover.pushable || !(mover.velocity == Vec3{}) || !(mover.spin == Vec3{});
  return (moves ? Pose{mover.position, mover.rotation} : fixed) * local;
}

void Chase::look(dynamics::Contact& contact, double h) {
  dynamics::Mover &a = *contact.a, &b = *contact.b;
  const Pose pose_a = a_.pose(a), pose_b = b_.pose(b);
  const auto whirl = [](const dynamics::Mover& mover, const Pose& pose, const pairs::Convex& shape) {
    return length(mover.spin) * (distance(pose.position, mover.position) * (mover.pushable ? 1 : 0) + 2 * pairs::size_of(shape));
  };
  const double speed = length(a.velocity - b.velocity) + whirl(a, pose_a, a_.shape) + whirl(b, pose_b, b_.shape);
  pairs::Manifold found;
  const bool any = pairs::collide(a_.shape, pose_a, b_.shape, pose_b, kAhead * speed * h + kNear, cache_, found);
  contact.count = any ? found.count : 0;
  if (!any) return;
  contact.set_normal(found.normal);
  for (int i = 0; i < found.count; ++i) {
    dynamics::TouchPoint& point = contact.points[i];
    point.restitution = contact.points[0].restitution;
    point.arm_a = found.points[i].on_a - a.position;
    point.arm_b = found.points[i].on_b - b.position;
    const pairs::Hub hub_a = pairs::hub_of(a_.shape, pose_a, a.position, point.arm_a), hub_b = pairs::hub_of(b_.shape, pose_b, b.position, point.arm_b);
    point.corner_a = hub_a.corner;
    point.corner_b = hub_b.corner;
    point.hub_a = hub_a.arm;
    point.hub_b = hub_b.arm;
    contact.axis_a = hub_a.axis;
    contact.axis_b = hub_b.axis;
    point.separation = found.points[i].separation;
  }
}

}  // namespace tumble
