#include "physics/joints/rows.h"

namespace tumble {

void hold_point(const JointFrame& frame, JointRows& out) {
  const Vec3 apart = frame.a.position - frame.b.position;
  const Vec3 arm_a = frame.a.position - frame.center_a, arm_b = frame.b.position - frame.center_b;
  for (const Vec3 e : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}})
    out.held.push_back({e, cross(arm_a, e), -e, -cross(arm_b, e), dot(apart, e), -1});
}

void hold_axis(const JointFrame& frame, JointRows& out) {
  // The axes' cross product has two parts across b's axis.
  const Vec3 tilt = cross(frame.b.rotation * Vec3{1, 0, 0}, frame.a.rotation * Vec3{1, 0, 0});
  for (const Vec3 side : {frame.b.rotation * Vec3{0, 1, 0}, frame.b.rotation * Vec3{0, 0, 1}})
    out.held.push_back(about(side, dot(tilt, side)));
}

JointRow along(const JointFrame& frame, Vec3 direction) {
  // The direction turns with b, so b's lever reaches to a's anchor.
  const Vec3 arm_a = frame.a.position - frame.center_a, arm_b = frame.a.position - frame.center_b;
  const double apart = dot(frame.a.position - frame.b.position, direction);
  return {direction, cross(arm_a, direction), -direction, -cross(arm_b, direction), apart, -1};
}

JointRow about(Vec3 direction, double error) { return {{}, direction, {}, -direction, error, -1}; }

Vec3 turned(const JointFrame& frame) {
  Quat q = frame.a.rotation * conjugate(frame.b.rotation);
  if (q.w < 0) q = {-q.x, -q.y, -q.z, -q.w};
  const Vec3 v{q.x, q.y, q.z};
  const double sine = length(v);
  return sine < 1e-12 ? v * 2.0 : v * (2 * std::atan2(sine, q.w) / sine);
}

double twisted(const JointFrame& frame) {
  // atan2 keeps its sign and its range at half turns.
  const Quat relative = conjugate(frame.b.rotation) * frame.a.rotation;
  return std::remainder(2 * std::atan2(relative.x, relative.w), 2 * kPi);
}

}  // namespace tumble
