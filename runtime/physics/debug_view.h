// What the debug view asks a world for. All of it is read; nothing here is a part of the simulation.
#pragma once

#include "physics/joint.h"
#include "physics/wire.h"

namespace tumble {

enum class DebugState { awake, asleep, kinematic, fixed };

struct DebugBody {
  BodyId body;
  DebugState state = DebugState::awake;
  const Wire *solids = nullptr, *triggers = nullptr;  // in the body's frame; kept with the body
  Vec3 low, high;              // corners of the world's box around it, after the last step
  Vec3 center;                 // of mass, in the body's frame
  Vec3 velocity, angular_velocity;
};

// A joint that holds. Its frames lie in its bodies' (the world's where there is none); x is the axis.
struct DebugJoint {
  BodyId a, b;                 // the default handle is the world
  Pose local_a, local_b;
  Vec3 center_a, center_b;     // of mass, in the bodies' frames; of the world, the anchor
  const JointKind* kind = nullptr;
};

}  // namespace tumble
