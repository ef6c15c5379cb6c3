// The world as coloured lines, for the debug view.
#pragma once

#include <vector>

#include "base/color.h"
#include "base/math.h"

namespace tumble {

struct DebugLine {
  Vec3 from, to;
  Color color;
};
struct DebugOptions {
  bool colliders = false, joints = false, boxes = false, contacts = false;
};

}  // namespace tumble
