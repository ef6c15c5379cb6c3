// The parts of B10 that are not shots at a wall.
#pragma once

#include "accuracy/scenes.h"

namespace tumble::accuracy {

BodyDef swept(BodyDef body);
// The error of those that count is how many went through; one is one too many.
Outcome count_through(int through, int tries);

// ---- b10_motion.cpp: what is left of the motion
Outcome lost_time(Trial& trial);
Outcome glancing(Trial& trial);
Outcome long_steps(Trial& trial);

// ---- b10_thin.cpp
Outcome plank(Trial& trial);
Outcome rod(Trial& trial);
Outcome head_on(Trial& trial, double speed);
Outcome stick(Trial& trial);

}  // namespace tumble::accuracy
