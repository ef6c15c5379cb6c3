#include "physics/joints/universal.h"

namespace tumble {

void describe(UniversalDef& def, Schema& s) {
  s.name("universal", "Lets two bodies turn about two axes across each other, as two shafts joined by a cross (Hooke's joint).");
  s.add("axis_b", def.axis_b,
        "The second axis, which b carries, in a's frame as the joint is made; the part of it across `axis` counts. Some "
        "direction across `axis` where it is not given.");
  s.add("turn_a", def.turn_a, "About `axis`, which a carries.");
  s.add("turn_b", def.turn_b, "About `axis_b`.");
}

void rows(const UniversalDef& def, const JointFrame& frame, JointRows& out) {
  hold_point(frame, out);

  // The cross: a carries one of its arms, b the other one, and they stay at right angles.
  const Vec3 arm_a = frame.a.rotation * Vec3{1, 0, 0}, arm_b = frame.b.rotation * Vec3{0, 1, 0};
  out.held.push_back(about(cross(arm_a, arm_b), dot(arm_a, arm_b)));

  // With R = Ry(turn_b) Rx(turn_a), R x = Ry(turn_b) x and R^-1 y = Rx(-turn_a) y. The spin of a against b is
  // turn_a' arm_a + turn_b' arm_b; as the arms are at right angles, each rate is the spin's part along its arm.
  const Vec3 a_in_b = conjugate(frame.b.rotation) * arm_a, b_in_a = conjugate(frame.a.rotation) * arm_b;
  out.free.push_back({about(arm_a, 0), std::atan2(-b_in_a.z, b_in_a.y), true, freedom(def.turn_a), false, "turn_a"});
  out.free.push_back({about(arm_b, 0), std::atan2(-a_in_b.z, a_in_b.x), true, freedom(def.turn_b), false, "turn_b"});
}

}  // namespace tumble
