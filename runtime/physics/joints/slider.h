// Two bodies slide along one axis without turning.
#pragma once

#include "physics/joints/rows.h"

namespace tumble {

struct SliderDef {
  SlideDef position;  // along the axis: how far a has moved against b
};
void describe(SliderDef& def, Schema& s);
void rows(const SliderDef& def, const JointFrame& frame, JointRows& out);

}  // namespace tumble
