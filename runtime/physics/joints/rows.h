// A joint as rows: each row is one relative motion of two bodies that is held, or left free and driven.
//
// A joint kind says which rows it has by `void rows(const KindDef&, const JointFrame&, JointRows&)`; whichever solver
// is used reads them. The velocity along a row is
//   linear_a . v_a + angular_a . w_a + linear_b . v_b + angular_b . w_b,  v of the centres of mass.
#pragma once

#include <vector>

#include "physics/joints/freedom.h"

namespace tumble {

// The joint's own frame as each body carries it, in the world; x is the joint's axis.
struct JointFrame {
  Pose a, b;
  Vec3 center_a, center_b;  // centres of mass
};

struct JointRow {
  Vec3 linear_a, angular_a, linear_b, angular_b;
  double error = 0;        // a held row's way from 0, m or rad
  double friction = -1;    // of a row that is only braked: N or N m; below 0 the row is held
};

struct FreeRow {
  JointRow row;
  double position = 0;     // m or rad; of a turn within +-pi, whole turns are counted elsewhere
  bool turn = false;
  Freedom freedom;
  bool bent = false;       // does its row turn as the bodies move along it, as a cone's boundary does?
  const char* name = "";   // by which its state is found; "" is not told
};

struct JointRows {
  std::vector<JointRow> held;
  std::vector<FreeRow> free;
  void clear() {
    held.clear();
    free.clear();
  }
};

// The two anchors stay at one point: three rows.
void hold_point(const JointFrame& frame, JointRows& out);
// The axes of both bodies stay parallel: two rows.
void hold_axis(const JointFrame& frame, JointRows& out);
// The anchors' way apart along a direction that body b carries.
JointRow along(const JointFrame& frame, Vec3 direction);
// Turning of a against b about a direction.
JointRow about(Vec3 direction, double error);
// How far a is turned against b, as a rotation vector (axis times angle), world.
Vec3 turned(const JointFrame& frame);
// The part of that about the axis, rad within +-pi: what is left when the axes are brought together the shortest way.
double twisted(const JointFrame& frame);

}  // namespace tumble
