// A body of the world: its description and what Bullet holds for it.
#pragma once

#include <memory>
#include <vector>

#include "physics/bullet/boxes.h"
#include "physics/bullet/shapes.h"
#include "physics/pairs/convex.h"
#include "physics/world.h"

namespace tumble {

namespace dynamics {
struct Mover;
}
struct JointPart;
struct Pair;
struct Materials;

// A kinematic body's way through the next step, of its centre.
struct Path {
  btTransform from, to;
  btVector3 velocity{0, 0, 0}, turning{0, 0, 0};  // means
  btVector3 change{0, 0, 0};   // of the velocity, against the step before
  btVector3 ramp{0, 0, 0};     // by how much the velocity grows within the step
};

// The colliders as lines, in the body's frame.
struct BodyWire {
  Wire solids, triggers;
};

// How a body was, and how long a step was to be, when its box was made.
struct Boxed {
  double travel = -1;
  unsigned placed = 0;
  Vec3 velocity, turning;
  double seconds = 0, fall = 0;
  bool operator==(const Boxed&) const = default;
};

struct BodyState {
  // What each look at a pair needs, side by side.
  double travel = 0;              // m, how far its surface has gone in all steps
  double ahead = 0;               // m, how far it goes in the next, as it moves now
  double fall = 0;                // m, how far what pulls it takes it in the next, from rest
  unsigned placed = 0;            // how often it was put somewhere other than by the solver
  Boxed boxed;
  bool active = false;            // dynamic and awake, or kinematic and just now moved: see awake.h
  bool stirred = false;           // not dynamic, and just now moved, added or stopped
  bool in_heap = false;           // the last step solved it in one; see dynamics/heap.h
  bool is_convex = false;         // its solids are the one shape `convex`
  bool has_belt = false;          // its surface runs
  dynamics::Mover* mover = nullptr;    // during a step
  double extent = 0;              // distance of its outermost point from its centre, m
  double trigger_extent = 0;      // the same of its triggers
  Pose center;                    // where its centre of mass and its principal axes are
  pairs::Convex convex;
  Pose convex_at;                 // in the frame of `center`

  BodyDef def;
  const Materials* materials = nullptr;  // the world's
  std::uint64_t user = 0;
  BodyId id;
  std::uint32_t serial = 0;       // age: later bodies have larger ones; never used again
  std::uint32_t group = 1, mask = ~0u;
  bool enabled = true;
  bool want_stay = false;
  MassProperties mass;
  Pose frame;                     // Bullet's frame (centre of mass, principal axes) in the body's

  std::unique_ptr<ShapeSet> solids, triggers;
  std::unique_ptr<btCollisionShape> nothing;  // stands in where there are no solids
  std::unique_ptr<btRigidBody> rigid;
  std::unique_ptr<btCollisionObject> ghost;   // its triggers; moves with it

  Vec3 force, torque;             // for the whole next step
  Vec3 start_velocity, start_turning;  // before the step
  btTransform last_good;          // before the step, finite
  Pose still_at;                  // where it began to be still
  double still_seconds = 0;       // how long it has hardly moved from there
  bool was_asleep = false;        // as it was last told
  bool changed = false;           // it woke or fell asleep since
  int island = -1;                // of the last step
  Occupant solid_box, trigger_box;
  bool moving = false;            // kinematic: `path` holds for the next step
  Path path;
  mutable std::unique_ptr<const BodyWire> wire;  // made when the debug view asks for it first

  std::vector<Pair*> pairs;       // what it touches
  std::vector<JointPart*> joints;

  bool dynamic() const { return def.type == BodyType::dynamic; }
  bool awake() const { return dynamic() && active; }
  Pose convex_pose() const { return center * convex_at; }
  Pose pose() const { return from_bullet(rigid->getWorldTransform()) * inverse(frame); }
  btTransform to_center(const Pose& pose) const { return to_bullet(pose * frame); }
  Vec3 velocity_at(Vec3 point) const;
  // Moves Bullet's object and the ghost there, no more.
  void place(const btTransform& center);
  void go(const Pose& center);    // the same, at the end of a step
};

// (Re)builds everything that follows from `def`, at a pose; not in any world yet.
void build(BodyState& body, const Pose& pose);
// What follows from numbers only: mass, damping, locks, continuous, group filters are not among it.
void apply_numbers(BodyState& body);
// Would the change need new shapes?
bool same_shapes(const BodyDef& a, const BodyDef& b);

inline BodyState* state_of(const btCollisionObject* object) { return static_cast<BodyState*>(object->getUserPointer()); }
// 1 marks the object that stands for a body's triggers.
inline bool is_ghost(const btCollisionObject* object) { return object->getUserIndex() == 1; }

}  // namespace tumble
