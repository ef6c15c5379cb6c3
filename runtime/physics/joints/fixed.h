// Welds two bodies together.
#pragma once

#include "physics/joints/rows.h"

namespace tumble {

struct FixedDef {};
void describe(FixedDef& def, Schema& s);
void rows(const FixedDef& def, const JointFrame& frame, JointRows& out);

}  // namespace tumble
