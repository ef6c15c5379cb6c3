// A joint of the world: its description, its link in the solver, and what it did.
#pragma once

#include <vector>

#include "physics/bullet/body_state.h"
#include "physics/dynamics/link.h"

namespace tumble {

struct JointPart {
  JointDef def;
  std::uint64_t user = 0;
  JointId id;
  std::uint32_t serial = 0;
  BodyState *a = nullptr, *b = nullptr;  // nullptr is the world
  Pose local_a, local_b;                 // the joint's frame in each body's; x is the axis
  bool broken = false;
  bool live = false;                     // does it hold?
  bool has_motor = false;                // that runs
  dynamics::Link link;
  Vec3 force, torque;                    // means over the last step

  JointFrame frame() const;
  bool awake() const { return (a && a->active) || (b && b->active); }
};

// Which of its freedoms have one place only; the rest of what the solver knows of it holds as long as these stay.
std::vector<bool> locks_of(const JointPart& joint);
// After it was made, or a change of the description: does its motor run?
void note_drives(JointPart& joint);
JointState state_of(const JointPart& joint);

}  // namespace tumble
