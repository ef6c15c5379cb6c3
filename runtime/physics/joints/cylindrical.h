// Two bodies slide along one axis and turn about it.
#pragma once

#include "physics/joints/rows.h"

namespace tumble {

struct CylindricalDef {
  SlideDef slide;  // along the axis: how far a has moved against b
  TurnDef turn;    // about the axis, right-handed: how far a has turned against b
};
void describe(CylindricalDef& def, Schema& s);
void rows(const CylindricalDef& def, const JointFrame& frame, JointRows& out);

}  // namespace tumble
