#include "physics/joints/slider.h"

namespace tumble {

void describe(SliderDef& def, Schema& s) {
  describe(def.position, s);  // the freedom's fields are the joint's own
  s.name("slider", "Lets two bodies slide along one axis, as a drawer (a prismatic joint).");
  s.check<SliderDef>([](const SliderDef& slider) { check_limits(slider.position); });
}

void rows(const SliderDef& def, const JointFrame& frame, JointRows& out) {
  out.held.push_back(along(frame, frame.b.rotation * Vec3{0, 1, 0}));
  out.held.push_back(along(frame, frame.b.rotation * Vec3{0, 0, 1}));
  const Vec3 error = turned(frame);
  out.held.push_back(about({1, 0, 0}, error.x));
  out.held.push_back(about({0, 1, 0}, error.y));
  out.held.push_back(about({0, 0, 1}, error.z));
  const JointRow row = along(frame, frame.b.rotation * Vec3{1, 0, 0});
  out.free.push_back({row, row.error, false, freedom(def.position), false, "position"});
}

}  // namespace tumble
