// A damped oscillator taken through a step exactly, whatever its stiffness.
#pragma once

namespace tumble::dynamics {

struct Swing {
  double position = 0, velocity = 0;
};

// Solves x'' + 2 z w x' + w^2 x = 0 for `seconds` from a state; w (rad/s) above 0, z at least 0.
Swing swung(Swing from, double w, double z, double seconds);

}  // namespace tumble::dynamics
