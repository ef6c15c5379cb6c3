// The physical world: bodies, joints, one fixed step, queries. No Bullet type shows here, and no node.
//
// Handles given out stay valid until the body or joint is removed; a removed one answers false to `has` and may not be
// used. Nothing may be added or removed inside step(). All arguments must be finite; who calls from a script checks.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "physics/body.h"
#include "physics/debug_view.h"
#include "physics/events.h"
#include "physics/joint.h"
#include "physics/query.h"

namespace tumble {

// How much is paid for accuracy: 2, 4 or 16 substeps at least; decision 0016 has what each is worth.
enum class Profile { fast, balanced, exact };
const EnumNames& enum_names(Profile);

struct WorldSettings {
  Vec3 gravity{0, -9.81, 0};          // m/s^2
  Profile profile = Profile::balanced;
  std::optional<int> substeps;        // of one step, at least, in place of the profile's: see docs/guide/dynamics.md
  int iterations = 2;                 // rounds over the contacts in each half of a substep, at least
  bool sleeping = true;
  double default_friction = 0.5;      // of a body that gives none
  double default_restitution = 0.0;
  Combine friction_combine = Combine::multiply;      // as Bullet; see docs/guide/meanings.md
  Combine restitution_combine = Combine::max;        // the livelier surface decides
  std::vector<std::string> groups;    // at most 31 names beside the default group
  int threads = 2;                    // of a step, at most: nothing but its time depends on them
  int least_substeps() const;
};
void describe(WorldSettings& settings, Schema& s);

struct WorldStats {
  int bodies = 0, awake = 0, joints = 0, contacts = 0;
  int islands = 0, substeps = 0;      // of the last step; the most that an island took
  double step_ms = 0;                 // thread CPU time of the last step
};

class World {
 public:
  explicit World(const WorldSettings& settings);
  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  const WorldSettings& settings() const;
  // Takes effect at the next step; a change of gravity wakes everything. Unknown group names are checked by who calls.
  void configure(const WorldSettings& settings);
  std::uint32_t group_bit(const std::string& group) const;  // throws Error with the nearest known group

  // ---- bodies. `user` is returned as given. A body that is added is solid at once and meets others from the next step.
  BodyId add(const BodyDef& def, const Pose& pose, std::uint64_t user);
  // Ends its contacts: their exits come with the next take_events(). Its joints go with it.
  void remove(BodyId body);
  bool has(BodyId body) const;
  std::uint64_t user(BodyId body) const;
  // The whole description as it is now, velocities included (of a kinematic body: those of its last motion; they are
  // not read back). configure() takes it back changed: cheap where only
  // numbers differ, contacts survive unless colliders or the type changed. Wakes the body.
  BodyDef def(BodyId body) const;
  void configure(BodyId body, const BodyDef& def);
  void set_enabled(BodyId body, bool enabled);  // off: not in the world, keeps its pose and velocity, contacts end
  bool enabled(BodyId body) const;

  Pose pose(BodyId body) const;
  // A jump: velocity stays, contacts end, neighbours wake.
  void teleport(BodyId body, const Pose& pose);
  // A kinematic body moves to `pose` during the next step, with the velocity that takes it there, and carries riders.
  void move(BodyId body, const Pose& pose);

  Vec3 velocity(BodyId body) const;             // of the centre of mass, m/s
  Vec3 angular_velocity(BodyId body) const;
  void set_velocity(BodyId body, Vec3 velocity);
  void set_angular_velocity(BodyId body, Vec3 velocity);
  Vec3 velocity_at(BodyId body, Vec3 point) const;
  // Setting a velocity, like what follows, is for dynamic bodies and does nothing to others: a kinematic one has that
  // of its motion. World vectors, at the centre of mass or at a world point. Forces and torques act through the next step, whatever
  // its substeps; impulses at once. All of them wake a dynamic body and do nothing to others.
  void apply_force(BodyId body, Vec3 force);
  void apply_force(BodyId body, Vec3 force, Vec3 point);
  void apply_torque(BodyId body, Vec3 torque);
  void apply_impulse(BodyId body, Vec3 impulse);
  void apply_impulse(BodyId body, Vec3 impulse, Vec3 point);
  void apply_angular_impulse(BodyId body, Vec3 impulse);
  bool asleep(BodyId body) const;
  void sleep(BodyId body);
  void wake(BodyId body);
  MassProperties mass_properties(BodyId body) const;
  Vec3 momentum(BodyId body) const;             // kg m/s
  double kinetic_energy(BodyId body) const;     // J
  // What touches it now (solid contacts), as if it were `a` in each: normal away from it. And what is in its triggers.
  std::vector<ContactEvent> contacts(BodyId body) const;
  std::vector<BodyId> overlapping(BodyId body) const;
  // Bodies that are awake and dynamic, in order of age; their poses changed in the last step.
  const std::vector<BodyId>& moved() const;

  // ---- joints. A joint works while both bodies are there and enabled. The pose at creation is 0 of every freedom.
  JointId add(const JointDef& def, std::uint64_t user);
  void remove(JointId joint);
  bool has(JointId joint) const;
  std::uint64_t user(JointId joint) const;
  const JointDef& def(JointId joint) const;
  void configure(JointId joint, const JointDef& def);   // limits, motor, spring, break force live; wakes both bodies
  JointState state(JointId joint) const;

  // ---- time
  void step(double seconds);
  Events take_events();                   // everything since the last call; stays only for bodies with want_stay
  void want_stay(BodyId body, bool on);

  // ---- queries; direction of any length but zero, length in metres (may be infinite)
  std::optional<QueryHit> raycast(Vec3 origin, Vec3 direction, double length, const QueryFilter& filter = {}) const;
  std::vector<QueryHit> raycast_all(Vec3 origin, Vec3 direction, double length, const QueryFilter& filter = {}) const;  // by distance
  bool raycast_any(Vec3 origin, Vec3 direction, double length, const QueryFilter& filter = {}) const;
  // A moving shape (sphere, box, capsule, cylinder), turned by `rotation`.
  std::optional<QueryHit> cast(const Shape& shape, const Pose& from, Vec3 direction, double length, const QueryFilter& filter = {}) const;
  std::vector<BodyId> overlap(const Shape& shape, const Pose& at, const QueryFilter& filter = {}) const;               // by age
  // The nearest surface point within `within` metres, of a shape touching or overlapping: how far to push it out.
  // distance is negative where they overlap, and point + normal * -distance is outside.
  std::vector<QueryHit> penetrations(const Shape& shape, const Pose& at, double within, const QueryFilter& filter = {}) const;

  // ---- for the debug view: bodies that are enabled, joints that hold, solids that touched in the last step
  void each_debug_body(const std::function<void(const DebugBody&)>& f) const;
  void each_debug_joint(const std::function<void(const DebugJoint&)>& f) const;
  void each_contact(const std::function<void(const ContactEvent&)>& f) const;
  WorldStats stats() const;
  std::uint64_t hash() const;             // poses and velocities of all bodies, in order of age

  struct Impl;  // the parts inside physics/bullet see it

 private:
  std::unique_ptr<Impl> impl_;
};

}  // namespace tumble
