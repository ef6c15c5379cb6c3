// A bone at its joint: it swings within a cone and twists about itself.
#pragma once

#include <optional>

#include "physics/joints/rows.h"

namespace tumble {

// Swinging off the axis to any side alike.
struct SwingDef {
  std::optional<double> max;  // rad, to both sides; none: free
  std::optional<TurnMotorDef> motor;
  std::optional<TurnSpringDef> spring;
  double friction = 0;        // N m
};
void describe(SwingDef& swing, Schema& s);

// How a stands against b is a twist about the axis, then a swing about a direction across it. The swing's rotation vector
// has two parts: swing_a about swing_axis and swing_b about the direction across both, axis x swing_axis.
struct RagdollDef {
  std::optional<Vec3> swing_axis;  // in a's frame as the joint is made; none: some direction across the axis
  SwingDef swing_a, swing_b;
  TurnDef twist;
};
void describe(RagdollDef& def, Schema& s);
void rows(const RagdollDef& def, const JointFrame& frame, JointRows& out);

}  // namespace tumble
