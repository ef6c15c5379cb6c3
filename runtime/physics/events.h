// What happened in a step, as records in the order in which handlers hear of it.
#pragma once

#include <cstdint>
#include <vector>

#include "physics/body.h"

namespace tumble {

struct ContactPoint {
  Vec3 point;          // world, m
  double impulse = 0;  // along the normal in this step, N s
};

enum class EventKind { exit, enter, stay, joint_break, sleep, wake };

// Two bodies touching, or a body in a trigger. Each pair of bodies has one record a step, by its colliders that touch.
struct ContactEvent {
  EventKind kind = EventKind::enter;
  bool trigger = false;
  BodyId a, b;                     // a is the older body; of an exit they may be gone already
  std::uint64_t user_a = 0, user_b = 0;  // what World::add got with them
  int collider_a = 0, collider_b = 0;
  Vec3 point;                      // deepest point, world; of an exit, the last one
  Vec3 normal;                     // from a towards b
  // When, in seconds since the last step began, which ends where the next begins. Of a trigger, when the shapes first or last
  // touched: below 0 of an exit whose body had gone in and out in the step before, and was told to have come in after it.
  // Of solids, and of what goes on, the end of the step; of an exit between two steps, by a removal or a teleport, 0.
  double time = 0;
  double speed = 0;                // approach at the point before the step, m/s, never negative
  double impulse = 0;              // sum along the normal in this step, N s
  Vec3 velocity;                   // of b against a, m/s
  std::vector<ContactPoint> points;
};

struct JointEvent { JointId joint; };
struct SleepEvent { BodyId body; bool asleep = false; };

// Order: exits, enters, stays; within a kind by the age of the older body, then of the younger.
struct Events {
  std::vector<ContactEvent> contacts;
  std::vector<JointEvent> breaks;
  std::vector<SleepEvent> sleeps;
  std::vector<BodyId> lost;   // bodies whose state became NaN or infinite: put back to their last finite pose and switched off
};

}  // namespace tumble
