// A joint of the world: its description, its rows as one of Bullet's constraints, and what it did.
#pragma once

#include <memory>
#include <vector>

#include "physics/bullet/body_state.h"

namespace tumble {

// One row as the solver takes it: bring the velocity along it to `velocity`, with an impulse between the limits.
struct SolverRow {
  JointRow row;
  double velocity = 0, lower = 0, upper = 0;
};

struct JointPart {
  JointDef def;
  std::uint64_t user = 0;
  JointId id;
  std::uint32_t serial = 0;
  BodyState *a = nullptr, *b = nullptr;  // nullptr is the world
  Pose local_a, local_b;                 // the joint's frame in each body's; x is the axis
  bool broken = false;
  bool live = false;                     // does it hold?
  bool has_spring = false, has_motor = false;
  std::unique_ptr<btTypedConstraint> constraint;
  btJointFeedback feedback;
  double seconds = 0;                    // of the substep
  std::vector<double> positions;         // of free rows, whole turns counted
  JointRows rows;
  std::vector<SolverRow> solver_rows;
  Vec3 impulse, twist;                   // on a in this step, N s; about the anchor, N m s
  Vec3 force, torque;                    // means over the last step

  JointFrame frame() const;
  bool awake() const { return (a && a->rigid->isActive()) || (b && b->rigid->isActive()); }
};

// Makes the constraint for the bodies as they are; `world` stands for a body that is not given.
void build(JointPart& joint, btRigidBody& world);
// After a change of the description: has it a spring, does its motor run?
void note_drives(JointPart& joint);
// Rows at the bodies' poses now.
void refresh_rows(JointPart& joint);
// Springs act once in each substep, before the solver.
void apply_springs(JointPart& joint);
// After the solver: what it held.
void collect(JointPart& joint);
JointState state_of(const JointPart& joint);

}  // namespace tumble
