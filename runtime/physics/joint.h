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
#include "physics/joints/fixed.h"
#include "physics/joints/hinge.h"
#include "physics/joints/slider.h"

namespace tumble {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// cylindrical, universal and ragdoll join this variant with their own files.
using JointKind = std::variant<FixedDef, HingeDef, SliderDef, BallDef>;

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

// What a joint did in the last step.
struct JointState {
  Vec3 force, torque;              // on a, at the anchor, world, mean over the step
  double position = 0, speed = 0;  // of the freedom of a hinge (rad, rad/s; whole turns counted) or slider (m, m/s)
  bool broken = false;
};

}  // namespace tumble
