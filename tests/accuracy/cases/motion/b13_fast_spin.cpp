// Fast spin: what a body says of its spin and how far it turns must agree, at any rate. An engine that cuts the angle of
// a step in silence loses here.
#include <algorithm>

#include "accuracy/cases/motion/rotation.h"

namespace tumble::accuracy {

namespace {

constexpr double kAllowed = 0.01;  // of the angle, and of energy

// Turned over reported; where the report itself fell from what was set, the spin was clamped and the pose must be too.
Outcome free_spin(Trial& trial, const Shape& shape, double spin) {
  Simulation& scene = trial.scene({{0, 0, 0}});
  BodyDef def = dynamic(shape, 1);
  def.angular_velocity = {0, 0, spin};
  const BodyIndex body = scene.add(def, {});

  TurnWatch watch(scene, body);
  run(scene, 1, kFrame, [&](double) {
    watch.after_step(kFrame);
    return true;
  });

  Outcome outcome;
  outcome.error = std::abs(watch.turned() - trial.reference(watch.reported())) / (kAllowed * watch.reported());
  if (!finite(scene, body)) outcome.failed = "not finite";
  return outcome;
}

// It falls 0.3 m onto a rough floor, where its spin becomes way and heat, never more.
Outcome landing(Trial& trial, const Shape& shape, double rest_height) {
  Simulation& scene = trial.scene();
  add_floor(scene, 200);
  BodyDef def = with(dynamic(shape, 1), 0.5);
  def.angular_velocity = {0, 0, -200};
  const BodyIndex body = scene.add(def, {{0, rest_height + 0.3, 0}, {}});
  const double start = energy(scene, body);

  Outcome outcome;
  TurnWatch watch(scene, body);
  run(scene, 1, kFrame, [&](double) {
    watch.after_step(kFrame);
    outcome.energy_drift = std::max(outcome.energy_drift.value_or(-1), energy(scene, body) / start - 1);
    return true;
  });
  const double off = std::abs(watch.turned() - trial.reference(watch.reported()));
  outcome.error = std::max(off / (kAllowed * watch.reported()), *outcome.energy_drift / kAllowed);
  if (!finite(scene, body)) outcome.failed = "not finite";
  return outcome;
}

}  // namespace

Case b13_fast_spin() {
  Case c{"B13", "Fast spin", "a ball or a long box (4 x 0.2 x 0.2 m, across its length) spins freely for 1 s; a ball of 0.5 m and a stub land spinning at 200 rad/s",
         "C: the angle turned is the reported velocity through time", "(turned - reported) / reported over 1 %; energy gained over 1 %", {}};
  for (const int spin : {30, 60, 200, 1000}) {
    const std::string name = std::to_string(spin) + " rad/s";
    c.parts.push_back({"ball " + name, 1, [spin](Trial& t) { return free_spin(t, ball(0.5), spin); }});
    c.parts.push_back({"long box " + name, 1, [spin](Trial& t) { return free_spin(t, box({4, 0.2, 0.2}), spin); }});
  }
  c.parts.push_back({"ball lands", 1, [](Trial& t) { return landing(t, ball(0.5), 0.5); }});
  c.parts.push_back({"stub lands", 1, [](Trial& t) { return landing(t, box({0.2, 0.2, 0.2}), 0.15); }});
  return c;
}

}  // namespace tumble::accuracy
