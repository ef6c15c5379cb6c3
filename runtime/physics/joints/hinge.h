// Two bodies turn about one axis.
#pragma once

#include "physics/joints/rows.h"

namespace tumble {

struct HingeDef {
  TurnDef angle;  // about the axis, right-handed: how far a has turned against b
};
void describe(HingeDef& def, Schema& s);
void rows(const HingeDef& def, const JointFrame& frame, JointRows& out);

}  // namespace tumble
