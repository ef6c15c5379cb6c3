#include "physics/joints/hinge.h"

namespace tumble {

void describe(HingeDef& def, Schema& s) {
  describe(def.angle, s);  // the freedom's fields are the joint's own
  s.name("hinge", "Lets two bodies turn about one axis, as a door on its frame (a revolute joint).");
  s.check<HingeDef>([](const HingeDef& hinge) { check_limits(hinge.angle); });
}

void rows(const HingeDef& def, const JointFrame& frame, JointRows& out) {
  hold_point(frame, out);

  // The axes of both bodies stay parallel: their cross product has two parts across b's axis.
  const Vec3 axis_a = frame.a.rotation * Vec3{1, 0, 0}, axis_b = frame.b.rotation * Vec3{1, 0, 0};
  const Vec3 tilt = cross(axis_b, axis_a);
  for (const Vec3 side : {frame.b.rotation * Vec3{0, 1, 0}, frame.b.rotation * Vec3{0, 0, 1}})
    out.held.push_back(about(side, dot(tilt, side)));

  // The twist part of the relative rotation about x; atan2 keeps its sign and its range at half turns.
  const Quat relative = conjugate(frame.b.rotation) * frame.a.rotation;
  const double angle = 2 * std::atan2(relative.x, relative.w);
  out.free.push_back({about(axis_b, 0), std::remainder(angle, 2 * kPi), true, freedom(def.angle)});
}

}  // namespace tumble
