// A joint as the solver sees it: two movers, the joint's frame in each, and the rows at their poses now.
#pragma once

#include <vector>

#include "physics/dynamics/mover.h"
#include "physics/joint.h"
#include "physics/joints/rows.h"

namespace tumble::dynamics {

struct Link {
  const JointKind* kind = nullptr;
  Mover *a = nullptr, *b = nullptr;
  Pose local_a, local_b;          // in the movers' frames; x is the axis
  std::vector<double> positions;  // of the free rows, whole turns counted; m or rad
  JointRows rows;
  Vec3 impulse, twist;            // on a in this step, N s; about the anchor, N m s
};

JointFrame frame(const Link& link);
// Rows and positions at the poses now.
void refresh(Link& link);
// The velocity along a row.
double speed(const Link& link, const JointRow& row);

}  // namespace tumble::dynamics
