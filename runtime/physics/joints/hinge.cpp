#include "physics/joints/hinge.h"

namespace tumble {

void describe(HingeDef& def, Schema& s) {
  describe(def.angle, s);  // the freedom's fields are the joint's own
  s.name("hinge", "Lets two bodies turn about one axis, as a door on its frame (a revolute joint).");
  s.check<HingeDef>([](const HingeDef& hinge) { check_limits(hinge.angle); });
}

void rows(const HingeDef& def, const JointFrame& frame, JointRows& out) {
  hold_point(frame, out);
  hold_axis(frame, out);
  out.free.push_back({about(frame.b.rotation * Vec3{1, 0, 0}, 0), twisted(frame), true, freedom(def.angle), false, "angle"});
}

}  // namespace tumble
