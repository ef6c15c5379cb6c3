// Four walls around the middle of a floor.
#pragma once

#include "accuracy/scenes.h"

namespace tumble::accuracy {

inline void add_walls(Simulation& scene, double side, double height) {
  for (const double sign : {-1.0, 1.0}) {
    scene.add(fixed(box({1, height, side + 2})), {{sign * (side + 1) / 2, height / 2, 0}, {}});
    scene.add(fixed(box({side + 2, height, 1})), {{0, height / 2, sign * (side + 1) / 2}, {}});
  }
}

}  // namespace tumble::accuracy
