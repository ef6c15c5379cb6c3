// Two bodies stay together at one point and turn freely.
#pragma once

#include "physics/joints/rows.h"

namespace tumble {

struct BallDef {
  double friction = 0;  // N m, about each axis
};
void describe(BallDef& def, Schema& s);
void rows(const BallDef& def, const JointFrame& frame, JointRows& out);

}  // namespace tumble
