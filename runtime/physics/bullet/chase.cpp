#include "physics/bullet/chase.h"

#include <algorithm>

#include "physics/bullet/convex_pair.h"
#include "physics/bullet/same_points.h"
#include "physics/pairs/hub.h"

namespace tumble {

namespace {

// From this part of the smaller one's size on a step's way is far.
constexpr double kFar = 0.25;
constexpr double kAhead = 2, kNear = 2e-3;  // of the way in a substep; m

// The points of the look before: what pressed there goes on at the same ones, and is not forgotten of others.
struct Before {
  explicit Before(const dynamics::Contact& contact) : count(contact.count), normal(contact.normal), restitution(contact.points[0].restitution) {
    std::copy(contact.points, contact.points + count, touch);
  }

  void hand_on(dynamics::Contact& contact, double near) const {
    bool known[dynamics::Contact::kMostPoints] = {};
    const auto moved = [&](int i, int k) {
      return std::min(distance(touch[i].arm_a, contact.points[k].arm_a), distance(touch[i].arm_b, contact.points[k].arm_b));
    };
    match_points(count, contact.count, near, moved, [&](int i, int k) {
      contact.points[k].impulse = touch[i].impulse;
      contact.points[k].sum = touch[i].sum;
      known[i] = true;
    });
    for (int i = 0; i < count; ++i) {
      if (known[i] || touch[i].sum <= 0) continue;
      const double sum = contact.lost.sum + touch[i].sum;
      contact.lost = {sum, contact.a->position + touch[i].arm_a, contact.b->position + touch[i].arm_b, normal};
    }
  }

  int count;
  Vec3 normal;
  double restitution;
  dynamics::TouchPoint touch[dynamics::Contact::kMostPoints];
};

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
  const Before before(contact);
  contact.count = any ? found.count : 0;
  if (any) contact.set_normal(found.normal);
  for (int i = 0; i < contact.count; ++i) {
    dynamics::TouchPoint& point = contact.points[i] = {};
    point.restitution = before.restitution;
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
  before.hand_on(contact, kSamePoint * std::min(pairs::size_of(a_.shape), pairs::size_of(b_.shape)));
}

}  // namespace tumble
