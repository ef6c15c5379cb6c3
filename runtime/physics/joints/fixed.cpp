#include "physics/joints/fixed.h"

namespace tumble {

void describe(FixedDef&, Schema& s) { s.name("fixed", "Welds two bodies together (a weld)."); }

void rows(const FixedDef&, const JointFrame& frame, JointRows& out) {
  hold_point(frame, out);
  const Vec3 error = turned(frame);
  out.held.push_back(about({1, 0, 0}, error.x));
  out.held.push_back(about({0, 1, 0}, error.y));
  out.held.push_back(about({0, 0, 1}, error.z));
}

}  // namespace tumble
