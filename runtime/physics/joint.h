// Joints as plain data: one struct a kind, gathered in one variant.
//
// A new kind is a header and a .cpp in joints/ (its struct, describe() and rows()) and one word in the variant.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "physics/body.h"
#include "physics/joints/ball.h"
#include "physics/joints/cylindrical.h"
#include "physics/joints/fixed.h"
#include "physics/joints/hinge.h"
#include "physics/joints/ragdoll.h"
#include "physics/joints/slider.h"
#include "physics/joints/universal.h"

namespace tumble {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

using JointKind = std::variant<FixedDef, HingeDef, SliderDef, CylindricalDef, BallDef, UniversalDef, RagdollDef>;

struct JointDef {
  BodyId a, b;                   // the default handle is the world
  Vec3 anchor;                   // in a's frame, m; in the world's where a is the world
  Vec3 axis{0, 1, 0};            // in a's frame, not zero
  double break_force = kInfinity, break_torque = kInfinity;  // N, N m: means over a step
  bool collide_connected = false;
  bool enabled = true;
  JointKind kind;
};
// What every kind has, but its bodies and the kind: those have names of their own in scripts and files.
void describe(JointDef& joint, Schema& s);

// "fixed", "hinge", ...: the names by which scripts and files call the kinds, in the variant's order.
const std::vector<std::string>& joint_kind_names();
std::string joint_kind_name(const JointKind& kind);
// A default one; throws Error with the nearest name where there is no such kind.
JointKind joint_kind(std::string_view name);
// The description of the kind that it holds, and the object that the description describes.
const Type& joint_kind_type(const JointKind& kind);
void* joint_kind_object(JointKind& kind);
const void* joint_kind_object(const JointKind& kind);

// The frame of a joint in a's: x is the axis, y the second one where the kind has one. The same axes give the same frame.
Quat joint_frame(const JointDef& joint);
// Throws Error, beginning with the call, where an axis is zero or the second lies along the first.
void check_axes(const JointDef& joint, const std::string& call);

// Where one freedom of a joint is.
struct FreedomState {
  std::string_view name;           // "angle", "slide", "turn_a", ...: as the kind's description calls it
  double position = 0, speed = 0;  // m, m/s or rad, rad/s; whole turns counted
};

// What a joint did in the last step.
struct JointState {
  Vec3 force, torque;              // on a, at the anchor, world, mean over the step
  double position = 0, speed = 0;  // of the first freedom: all there is to a hinge or slider
  bool broken = false;
  std::vector<FreedomState> freedoms;
};

}  // namespace tumble
