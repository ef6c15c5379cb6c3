#include "physics/joints/ball.h"

namespace tumble {

void describe(BallDef& def, Schema& s) {
  s.name("ball", "Keeps two bodies together at one point; they turn freely (a spherical joint).");
  s.add("friction", def.friction, "Brakes the turning with up to this torque about each axis, N m.").at_least(0);
}

void rows(const BallDef& def, const JointFrame& frame, JointRows& out) {
  hold_point(frame, out);
  if (def.friction <= 0) return;
  for (const Vec3 e : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
    JointRow brake = about(e, 0);
    brake.friction = def.friction;
    out.held.push_back(brake);
  }
}

}  // namespace tumble
