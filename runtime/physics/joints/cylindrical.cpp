#include "physics/joints/cylindrical.h"

namespace tumble {

void describe(CylindricalDef& def, Schema& s) {
  s.name("cylindrical", "Lets two bodies slide along one axis and turn about it, as a ring on a rod.");
  s.add("slide", def.slide, "Along the axis.");
  s.add("turn", def.turn, "About the axis.");
}

void rows(const CylindricalDef& def, const JointFrame& frame, JointRows& out) {
  out.held.push_back(along(frame, frame.b.rotation * Vec3{0, 1, 0}));
  out.held.push_back(along(frame, frame.b.rotation * Vec3{0, 0, 1}));
  hold_axis(frame, out);
  const Vec3 axis = frame.b.rotation * Vec3{1, 0, 0};
  const JointRow row = along(frame, axis);
  out.free.push_back({row, row.error, false, freedom(def.slide), false, "slide"});
  out.free.push_back({about(axis, 0), twisted(frame), true, freedom(def.turn), false, "turn"});
}

}  // namespace tumble
