#include "accuracy/recorder.h"

#include <valgrind/callgrind.h>

#include <ctime>

#include "accuracy/scenes.h"

namespace tumble::accuracy {

namespace {

// Cost is measured over the first minutes of a scene at most; what comes later need not be kept.
constexpr std::size_t kLongestScript = 100000;
constexpr int kContactsEvery = 16;  // ticks between two counts of contact points

}  // namespace

double thread_ms() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
}

Recorder::Recorder(std::unique_ptr<Simulation> engine, const SceneSettings& settings) : engine_(std::move(engine)), settings_(settings) {}

template <class Change>
auto Recorder::change(Change change) {
  const auto keep = [&] {  // once the engine has taken it: what it refuses is not to be played again
    if (script_.size() < kLongestScript) script_.push_back({[change](Simulation& s) { change(s); }, 0, 0});
  };
  if constexpr (std::is_void_v<decltype(change(*engine_))>) {
    change(*engine_);
    keep();
  } else {
    const auto result = change(*engine_);
    keep();
    return result;
  }
}

BodyIndex Recorder::add(const BodyDef& body, const Pose& pose) {
  if (body.type == BodyType::dynamic) movers_.push_back(bodies_);
  ++bodies_;
  return change([=](Simulation& s) { return s.add(body, pose); });
}
JointIndex Recorder::add(const JointSpec& joint) {
  return change([=](Simulation& s) { return s.add(joint); });
}
void Recorder::remove(BodyIndex body) {
  std::erase(movers_, body);
  change([=](Simulation& s) { s.remove(body); });
}
void Recorder::remove_joint(JointIndex joint) {
  change([=](Simulation& s) { s.remove_joint(joint); });
}
void Recorder::configure(BodyIndex body, const BodyDef& def) {
  change([=](Simulation& s) { s.configure(body, def); });
}
void Recorder::configure_joint(JointIndex joint, const JointDef& def) {
  change([=](Simulation& s) { s.configure_joint(joint, def); });
}
void Recorder::set_enabled(BodyIndex body, bool enabled) {
  change([=](Simulation& s) { s.set_enabled(body, enabled); });
}
void Recorder::set_gravity(Vec3 gravity) {
  change([=](Simulation& s) { s.set_gravity(gravity); });
}
void Recorder::teleport(BodyIndex body, const Pose& pose) {
  change([=](Simulation& s) { s.teleport(body, pose); });
}
void Recorder::move(BodyIndex body, const Pose& pose) {
  change([=](Simulation& s) { s.move(body, pose); });
}
void Recorder::set_velocity(BodyIndex body, Vec3 velocity) {
  change([=](Simulation& s) { s.set_velocity(body, velocity); });
}
void Recorder::set_angular_velocity(BodyIndex body, Vec3 velocity) {
  change([=](Simulation& s) { s.set_angular_velocity(body, velocity); });
}
void Recorder::apply_force(BodyIndex body, Vec3 force) {
  change([=](Simulation& s) { s.apply_force(body, force); });
}
void Recorder::apply_torque(BodyIndex body, Vec3 torque) {
  change([=](Simulation& s) { s.apply_torque(body, torque); });
}
void Recorder::apply_impulse(BodyIndex body, Vec3 impulse, std::optional<Vec3> point) {
  change([=](Simulation& s) { s.apply_impulse(body, impulse, point); });
}
void Recorder::wake(BodyIndex body) {
  change([=](Simulation& s) { s.wake(body); });
}

void Recorder::keep_steps(double seconds, int count) {
  const bool again = !script_.empty() && !script_.back().change && script_.back().seconds == seconds;
  if (again) script_.back().steps += count;
  else if (script_.size() < kLongestScript && count > 0) script_.push_back({{}, seconds, count});
}

template <class Run>
void Recorder::time(const Run& run) {
  if (simulated_ >= stop_after_) throw Enough{};
  const double begin = thread_ms();
  CALLGRIND_TOGGLE_COLLECT;  // off before; nothing outside valgrind
  run();
  CALLGRIND_TOGGLE_COLLECT;
  step_ms_ += thread_ms() - begin;
}

void Recorder::count_steps(double seconds, int count) {
  const int samples = (steps_ + count) / kContactsEvery - steps_ / kContactsEvery;
  steps_ += count;
  simulated_ += seconds * count;
  if (samples > 0) {
    contact_points_ += engine_->contact_points();
    ++contact_samples_;
  }
  if (tracing_ && count > 0) add_trace();
}

void Recorder::step(double seconds) {
  keep_steps(seconds, 1);
  time([&] { engine_->step(seconds); });
  count_steps(seconds, 1);
}

Frame Recorder::frame(double seconds) {
  Frame frame;
  time([&] { frame = engine_->frame(seconds); });
  keep_steps(kFrame, frame.ticks);
  count_steps(kFrame, frame.ticks);
  return frame;
}

void Recorder::add_trace() {
  Trace now;
  now.seconds = simulated_;
  Vec3 momenta, spins;
  for (const BodyIndex body : movers_) {
    now.energy += energy(*this, body, settings_.gravity);
    momenta += momentum(*this, body);
    spins += angular_momentum(*this, body);
  }
  now.momentum = length(momenta);
  now.spin = length(spins);
  traces_.push_back(now);
}

}  // namespace tumble::accuracy
