// What a World is inside. The parts are in world.cpp (bodies), world_motion.cpp (poses, velocities, forces),
// world_joints.cpp, world_step.cpp and world_queries.cpp.
#pragma once

#include "physics/bullet/collision.h"
#include "physics/bullet/contacts.h"
#include "physics/bullet/joint_part.h"
#include "physics/bullet/materials.h"
#include "physics/bullet/pair_configuration.h"
#include "physics/bullet/solver.h"

namespace tumble {

struct Body {
  std::unique_ptr<BodyState> state;
};
struct Joint {
  std::unique_ptr<JointPart> part;
};

struct World::Impl {
  explicit Impl(const WorldSettings& given);
  ~Impl();

  WorldSettings settings;
  Materials materials;

  PairConfiguration configuration;
  PairDispatcher dispatcher{&configuration};
  Overlaps overlaps{dispatcher};
  Awake awake{overlaps};
  Collision collision{dispatcher, overlaps, awake};
  Solver solver;

  Pool<Body> bodies;
  Pool<Joint> joints;
  std::uint32_t next_serial = 1, next_joint = 1;
  std::vector<BodyState*> carriers;   // kinematic or with triggers, and just now moved, added or stopped
  std::vector<JointPart*> live;       // joints that hold, by age
  std::vector<BodyId> moved;
  ContactBook book;
  Events events;
  std::unique_ptr<Team> team;         // as many as the settings say
  double step_ms = 0;

  BodyState& body(BodyId id) { return *bodies[id].state; }
  JointPart& joint(JointId id) { return *joints[id].part; }

  // ---- bodies (world.cpp)
  void apply_settings();
  std::optional<std::uint32_t> find_group(const std::string& name) const;
  [[noreturn]] void fail_group(const char* where, const std::string& name) const;
  void set_groups(BodyState& body, const char* where);
  void change_groups(const std::vector<std::string>& groups);
  void enter(BodyState& body);        // into the world
  void leave(BodyState& body);        // out of it: contacts end, neighbours wake
  void rebuild(BodyState& body, const Pose& pose);
  void refresh_pairs(BodyState& body);
  void wake(BodyState& body) { awake.wake(body); }
  void wake_around(BodyState& body);  // all whose boxes overlap its box
  void wake_touching(BodyState& body);
  void wake_heap(BodyState& body);    // all that sleep on it, and on those
  void stir(BodyState& body);         // a kinematic body or its triggers: looked at in the next step

  // ---- joints (world_joints.cpp)
  void update_live(JointPart& joint);
  void remove_joint(JointPart& joint);

  // ---- a step (world_step.cpp)
  void step(double seconds);
  void begin_step(double seconds);
  void end_step(double seconds);
  void lose_insane();
  void settle(double seconds);        // who is still, and which islands fall asleep
  void settle_carriers();
  bool keeps_still(BodyState& body) const;
  bool is_still(BodyState& body, double seconds) const;
  void note_joint_forces(double seconds, bool first);
  void break_joints();
  void quarantine(BodyState& body);
};

}  // namespace tumble
