// Two bodies stay together at one point and turn about two axes across each other, one carried by each: Hooke's joint.
#pragma once

#include <optional>

#include "physics/joints/rows.h"

namespace tumble {

// How a stands against b is a turn about the axis, then one about axis_b: R = R(axis_b, turn_b) R(axis, turn_a).
struct UniversalDef {
  std::optional<Vec3> axis_b;  // in a's frame as the joint is made; b carries it; none: some direction across the axis
  TurnDef turn_a;              // about the axis, which a carries
  TurnDef turn_b;              // about axis_b
};
void describe(UniversalDef& def, Schema& s);
void rows(const UniversalDef& def, const JointFrame& frame, JointRows& out);

}  // namespace tumble
