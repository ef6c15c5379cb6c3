// What acts along a freedom of a joint: a motor, a spring, a limit, a brake. Each is one row with bounds on its impulse.
#pragma once

#include <Eigen/Core>

#include "physics/dynamics/link.h"

namespace tumble::dynamics {

struct Drive {
  enum Kind { spring, brake, motor, low, high };
  Kind kind = brake;
  Link* link = nullptr;
  int free_row = -1;          // of the link; -1 where `held_row` is braked
  int held_row = -1;
  Freedom freedom;
  double strength = 0;        // N or N m, of a brake or motor; may be infinite

  JointRow row;
  bool active = false;        // does it act now?
  double position = 0;        // m or rad
  double impulse = 0;         // in this substep, N s or N m s
  double lower = 0, upper = 0;  // bounds of it, for all of the substep
  double before = 0;          // speed along it when the substep began
  double aim = 0;             // of a limit before the drift: the room that is to be left after it, at least
  double target = 0;          // speed to be reached, at most or at least of a limit
  double target_after = 0;    // of a spring: at the end of the substep
  double yield = 0;           // of a spring: the part of a speed that others give to its freedom that is left at the target
  double yield_after = 0;     // likewise
  // With the mechanism's held rows: an impulse of 1 along it, with `helpers` along those, changes its speed by `mobility`.
  double mobility = 0;
  double own_mobility = 0;    // of its two bodies alone
  Eigen::VectorXd helpers;
};

// All that acts along the freedoms of a link, in the order in which it is solved.
std::vector<Drive> drives_of(Link& link);
// Takes row and position from the link, and says whether it acts within the next h.
void refresh(Drive& drive, double h);
// Bounds and targets of the first half of a substep, before the drift, and of the second, after it. A spring looks at the
// speed that all but springs have given: call it when held rows are solved.
void aim_before(Drive& drive, double speed, double h);
void aim_after(Drive& drive, double h);
// After the drift: how far a limit was passed beyond what was aimed at, m or rad; 0 of other kinds.
double passed(const Drive& drive);

}  // namespace tumble::dynamics
