// One physical scene in one engine: what the cases of the suite build, drive and read, whatever engine runs it.
//
// Scenes are described by the runtime's own plain data (physics/body.h, physics/joint.h). Combine rules differ between
// engines, so a case says what a pair has: every adapter takes friction and restitution of a pair as the product, and a
// case gives 1 to one of the partners (scenes.h does).
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "physics/body.h"
#include "physics/events.h"
#include "physics/joint.h"
#include "physics/query.h"

namespace tumble::accuracy {

// Bodies and joints are numbered by age from 0, so that a recorded scene can be played in another engine.
using BodyIndex = int;
using JointIndex = int;
constexpr BodyIndex kWorld = -1;  // as a joint's partner

// How hard an engine works. The suite varies both.
struct Knobs {
  int substeps = 4;
  int iterations = 10;
  bool operator==(const Knobs&) const = default;
};

// What a scene needs beside gravity.
struct SceneSettings {
  Vec3 gravity{0, -9.81, 0};
  bool sleeping = false;
  int most_ticks = 6;        // that a frame() catches up with
  int threads = 1;           // costs are told of one thread
};

// A joint whose partners are bodies of the scene; `def.a` and `def.b` are not read.
struct JointSpec {
  BodyIndex a = kWorld, b = kWorld;
  JointDef def;
};

struct Touch {            // a pair of bodies that touch, as seen after a step
  BodyIndex a = 0, b = 0; // a is the older
  Vec3 point, normal;     // world; the normal points from a to b
  double impulse = 0;     // along the normal during the whole step, N s
  int points = 0;
};

struct Crossing {         // a solid body and a trigger
  BodyIndex trigger = 0, visitor = 0;
  bool enter = true;
  std::optional<double> time;  // when the shapes first or last touched, s since the step began; nothing where an engine knows steps only
};

struct Frame {            // of a loop with a clock
  int ticks = 0;          // that were run
  double dropped = 0;     // s that were left out
};

struct RayHit {
  BodyIndex body = 0;
  Vec3 point, normal;
  double distance = 0;
};

// Thrown where an engine lacks what a case needs: the row then says "missing" and what.
struct __attribute__((visibility("default"))) Missing {
  std::string what;  // "universal joints"
};

class Simulation {
 public:
  virtual ~Simulation() = default;

  // ---- the scene
  virtual BodyIndex add(const BodyDef& body, const Pose& pose) = 0;
  virtual JointIndex add(const JointSpec& joint) = 0;
  virtual void remove(BodyIndex body) = 0;
  virtual void remove_joint(JointIndex joint) = 0;
  // The body anew with the same place and velocity: another size, mass or material.
  virtual void configure(BodyIndex body, const BodyDef& def) = 0;
  virtual void configure_joint(JointIndex joint, const JointDef& def) = 0;
  virtual void set_enabled(BodyIndex body, bool enabled) = 0;
  virtual void set_gravity(Vec3 gravity) = 0;

  // ---- driving it
  virtual void teleport(BodyIndex body, const Pose& pose) = 0;
  virtual void move(BodyIndex body, const Pose& pose) = 0;  // a kinematic body, during the next step
  virtual void set_velocity(BodyIndex body, Vec3 velocity) = 0;
  virtual void set_angular_velocity(BodyIndex body, Vec3 velocity) = 0;
  virtual void apply_force(BodyIndex body, Vec3 force) = 0;     // through the next step, at the centre of mass
  virtual void apply_torque(BodyIndex body, Vec3 torque) = 0;
  virtual void apply_impulse(BodyIndex body, Vec3 impulse, std::optional<Vec3> point = {}) = 0;
  virtual void wake(BodyIndex body) = 0;
  virtual void step(double seconds) = 0;
  // So many seconds of real time, by the engine's own clock: the ticks of a 60th of a second that are due by now, as many as
  // a frame may catch up with.
  virtual Frame frame(double seconds) = 0;

  // ---- reading it
  virtual Pose pose(BodyIndex body) const = 0;              // of the body's own frame
  virtual Vec3 velocity(BodyIndex body) const = 0;          // of the centre of mass
  virtual Vec3 angular_velocity(BodyIndex body) const = 0;
  virtual bool asleep(BodyIndex body) const = 0;
  virtual bool enabled(BodyIndex body) const = 0;           // an engine may switch off what is lost
  virtual MassProperties mass_properties(BodyIndex body) const = 0;
  virtual JointState joint_state(JointIndex joint) const = 0;
  virtual std::vector<Touch> touches() const = 0;           // of the last step
  virtual std::vector<Crossing> take_crossings() = 0;       // since the last call, in order
  virtual std::optional<RayHit> raycast(Vec3 origin, Vec3 direction, double length) const = 0;
  virtual std::optional<RayHit> cast(const Shape& shape, const Pose& from, Vec3 direction, double length) const = 0;
  virtual int contact_points() const = 0;                   // now
};

// The engines of the suite by name: "tumble" is our World, "stock" is Debian's Bullet in float with its own world and
// its defaults. Knobs: substeps of one step (of stock: fixed steps of stepSimulation) and solver iterations.
struct EngineKind {
  std::string name;
  Knobs defaults;
  std::unique_ptr<Simulation> (*make)(const SceneSettings& settings, const Knobs& knobs);
};
const std::vector<EngineKind>& engines();

}  // namespace tumble::accuracy
