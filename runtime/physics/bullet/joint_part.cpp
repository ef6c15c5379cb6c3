#include "physics/bullet/joint_part.h"

namespace tumble {

namespace {

JointRows rows_now(const JointPart& joint) {
  JointRows now;
  const JointFrame frame = joint.frame();
  std::visit([&](const auto& kind) { rows(kind, frame, now); }, joint.def.kind);
  return now;
}

double speed_along(const JointPart& joint, const JointRow& row) {
  double speed = 0;
  const auto add = [&speed](const BodyState* body, Vec3 linear, Vec3 angular) {
    if (!body) return;
    speed += dot(linear, from_bullet(body->rigid->getLinearVelocity())) + dot(angular, from_bullet(body->rigid->getAngularVelocity()));
  };
  add(joint.a, row.linear_a, row.angular_a);
  add(joint.b, row.linear_b, row.angular_b);
  return speed;
}

}  // namespace

JointFrame JointPart::frame() const {
  const auto center = [](const BodyState* body) { return body ? from_bullet(body->rigid->getWorldTransform().getOrigin()) : Vec3{}; };
  return {a ? a->pose() * local_a : local_a, b ? b->pose() * local_b : local_b, center(a), center(b)};
}

std::vector<bool> locks_of(const JointPart& joint) {
  std::vector<bool> locks;
  for (const FreeRow& free : rows_now(joint).free) {
    const Freedom& freedom = free.freedom;
    locks.push_back(freedom.min && freedom.max && *freedom.min == *freedom.max);
  }
  return locks;
}

void note_drives(JointPart& joint) {
  joint.has_motor = false;
  for (const FreeRow& free : rows_now(joint).free) joint.has_motor |= free.freedom.motor && free.freedom.motor->speed.value_or(0) != 0;
}

JointState state_of(const JointPart& joint) {
  JointState state{joint.force, joint.torque, 0, 0, joint.broken, {}};
  const JointRows now = rows_now(joint);
  for (std::size_t i = 0; i < now.free.size(); ++i) {
    const FreeRow& free = now.free[i];
    if (*free.name == 0) continue;
    const double known = i < joint.link.positions.size() ? joint.link.positions[i] : 0;
    const double position = free.turn ? known + std::remainder(free.position - known, 2 * kPi) : free.position;
    state.freedoms.push_back({free.name, position, speed_along(joint, free.row)});
  }
  if (state.freedoms.empty()) return state;
  state.position = state.freedoms[0].position;
  state.speed = state.freedoms[0].speed;
  return state;
}

}  // namespace tumble
