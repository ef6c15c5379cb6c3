// Fast bodies against thin walls, one lane each, from distances that spread the hit over a step.
#pragma once

#include "accuracy/scenes.h"

namespace tumble::accuracy {

struct Shot {
  BodyDef body;            // its velocity is the volley's
  double angle = 0;        // rad against the wall's normal
  double phase = 0;        // of a step, 0 to 1
};

struct Hits {
  int through = 0;
  double rebound = 0;      // the largest speed away from the wall over the speed of the shot
  std::string failed;
};

// Walls of 1 cm, shots at `speed` m/s from a metre or a little more, no gravity.
Hits fire(Trial& trial, const std::vector<Shot>& shots, double speed, BodyType wall = BodyType::fixed);

}  // namespace tumble::accuracy
