// Mixed bodies that are poured into a pit.
#pragma once

#include "accuracy/cases/stacking/build.h"

namespace tumble::accuracy {

enum class Mix { simple, convex };  // boxes, balls and capsules; or boxes, cylinders and hulls

// A pit with a floor and four walls, and above it `count` bodies of 1 kg and about 1 m in layers, turned and placed a
// little at random. The pit is half as wide as the bodies would be high if they stayed in their layers.
struct Pit {
  double half = 0;                   // m, inside
  bool holds(Vec3 place) const;
};
Pit pour(Build& build, int count, Mix mix, double lowest = 1);
Shape mixed_shape(Mix mix, int index);

}  // namespace tumble::accuracy
