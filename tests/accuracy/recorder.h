// A Simulation that passes everything on to an engine and remembers what changed it, so that the same scene can be
// played again with nothing read in between: that is how cost is measured.
#pragma once

#include <cmath>
#include <functional>

#include "accuracy/simulation.h"

namespace tumble::accuracy {

// A change of the scene, or a run of equal steps.
struct Operation {
  std::function<void(Simulation&)> change;  // empty: steps
  double seconds = 0;
  int steps = 0;
};
using Script = std::vector<Operation>;

// Energy and momenta of a whole scene at one time, for the report's traces.
struct Trace {
  double seconds = 0, energy = 0, momentum = 0, spin = 0;  // J, kg m/s and kg m^2/s about the origin
};

class Recorder final : public Simulation {
 public:
  struct Enough {};  // thrown by step() where the seconds of `stop_after` are over

  Recorder(std::unique_ptr<Simulation> engine, const SceneSettings& settings);
  void stop_after(double seconds) { stop_after_ = seconds; }
  void trace() { tracing_ = true; }
  const std::vector<Trace>& traces() const { return traces_; }

  const SceneSettings& settings() const { return settings_; }
  const Script& script() const { return script_; }
  int bodies() const { return bodies_; }        // ever added
  int steps() const { return steps_; }
  double simulated() const { return simulated_; }  // s
  double step_ms() const { return step_ms_; }   // thread CPU time of all steps
  double mean_contact_points() const { return contact_samples_ ? contact_points_ / contact_samples_ : 0; }

  BodyIndex add(const BodyDef& body, const Pose& pose) override;
  JointIndex add(const JointSpec& joint) override;
  void remove(BodyIndex body) override;
  void remove_joint(JointIndex joint) override;
  void configure(BodyIndex body, const BodyDef& def) override;
  void configure_joint(JointIndex joint, const JointDef& def) override;
  void set_enabled(BodyIndex body, bool enabled) override;
  void set_gravity(Vec3 gravity) override;
  void teleport(BodyIndex body, const Pose& pose) override;
  void move(BodyIndex body, const Pose& pose) override;
  void set_velocity(BodyIndex body, Vec3 velocity) override;
  void set_angular_velocity(BodyIndex body, Vec3 velocity) override;
  void apply_force(BodyIndex body, Vec3 force) override;
  void apply_torque(BodyIndex body, Vec3 torque) override;
  void apply_impulse(BodyIndex body, Vec3 impulse, std::optional<Vec3> point) override;
  void wake(BodyIndex body) override;
  void step(double seconds) override;
  Frame frame(double seconds) override;  // kept as the ticks that were run
  Pose pose(BodyIndex body) const override { return engine_->pose(body); }
  Vec3 velocity(BodyIndex body) const override { return engine_->velocity(body); }
  Vec3 angular_velocity(BodyIndex body) const override { return engine_->angular_velocity(body); }
  bool asleep(BodyIndex body) const override { return engine_->asleep(body); }
  bool enabled(BodyIndex body) const override { return engine_->enabled(body); }
  MassProperties mass_properties(BodyIndex body) const override { return engine_->mass_properties(body); }
  JointState joint_state(JointIndex joint) const override { return engine_->joint_state(joint); }
  std::vector<Touch> touches() const override { return engine_->touches(); }
  std::vector<Crossing> take_crossings() override { return engine_->take_crossings(); }
  std::optional<RayHit> raycast(Vec3 origin, Vec3 direction, double length) const override { return engine_->raycast(origin, direction, length); }
  std::optional<RayHit> cast(const Shape& shape, const Pose& from, Vec3 direction, double length) const override { return engine_->cast(shape, from, direction, length); }
  int contact_points() const override { return engine_->contact_points(); }

 private:
  // Keeps it for later, and does it now.
  template <class Change>
  auto change(Change change);
  void keep_steps(double seconds, int count);
  template <class Run>
  void time(const Run& run);
  void count_steps(double seconds, int count);
  void add_trace();

  std::unique_ptr<Simulation> engine_;
  SceneSettings settings_;
  Script script_;
  int bodies_ = 0, steps_ = 0, contact_samples_ = 0;
  double simulated_ = 0, step_ms_ = 0, contact_points_ = 0, stop_after_ = INFINITY;
  bool tracing_ = false;
  std::vector<BodyIndex> movers_;  // dynamic bodies, where traced
  std::vector<Trace> traces_;
};

// CPU time of this thread, ms.
double thread_ms();

}  // namespace tumble::accuracy
