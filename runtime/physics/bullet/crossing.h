// When, within the step that is over, a body came into a trigger or left it: by a search along their ways. A look costs
// a dozen distances of the shapes, and is taken only at those that came or went.
#pragma once

#include "physics/bullet/body_state.h"

namespace tumble {

// Of two that touch at the part `inside` (0 to 1) of a step of so many seconds, one of them with triggers: when they first
// touched, in seconds since it began. 0 where they did so already when it began.
double first_touch(const BodyState& a, const BodyState& b, double seconds, double inside);
// Likewise when they last touched: `seconds` where they still do, and the time of `inside` where they do not even there.
double last_touch(const BodyState& a, const BodyState& b, double seconds, double inside);

}  // namespace tumble
