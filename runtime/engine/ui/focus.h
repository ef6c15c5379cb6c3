// From one widget to the next with the arrows: by where they stand, not by the order in which they were written.
#pragma once

#include <vector>

#include "engine/ui/element.h"

namespace tumble {

enum class UiDirection { left, right, up, down };

// The nearest of `others` that lies in that direction, those straight ahead first; -1 where there is none. With `wrap`
// the farthest on the other side then, so that a menu goes round.
int next_in_direction(const UiRect& from, const std::vector<UiRect>& others, UiDirection direction, bool wrap);

}  // namespace tumble
