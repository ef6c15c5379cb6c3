// A case of the suite: scenes, a reference, and an error without a unit.
//
// A case lives in a file of its own under cases/, which says scene, reference and metric and nothing of engines. Its
// parts are its variants (restitution 0.3, 0.5 ...). A part builds its scenes through its Trial, steps them and says how
// far they are from the truth: a formula, a conserved quantity, an integrator of the harness, or the engine's own limit.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "accuracy/recorder.h"

namespace tumble::accuracy {

constexpr double kGravity = 9.81;   // m/s^2
constexpr double kFrame = 1.0 / 60; // s, a step of a game

// How long one run may take. `test` is for the tests: the shortest form that can still fail.
enum class Effort { test, quick, full, soak };

struct Outcome {
  double error = 0;                        // 0 is perfect; of a stability case measured over allowed, so that 1 is the limit
  std::optional<double> bias, worst;       // over the phases, where an event may fall anywhere in a step
  std::optional<double> energy_drift;      // of the whole scene over its scale; above 0 is gain
  std::optional<double> max_penetration, max_joint_gap;  // m
  std::string failed;                      // not empty: what went wrong, whatever the error: "fell over at 4.2 s"
};

class Trial {
 public:
  Trial(const EngineKind& engine, Knobs knobs, Effort effort, double perturb = 0);

  // A new scene at the trial's knobs. It stays alive as long as the trial.
  Simulation& scene(const SceneSettings& settings = {});
  // The same at other knobs, for a reference of kind S: the engine against its own limit.
  Simulation& scene(const SceneSettings& settings, const Knobs& knobs);
  // Every reference number that a result is compared with goes through here: a test spoils it by a part `perturb` to
  // see that the case notices.
  double reference(double value) const { return value * (1 + perturb_); }
  Vec3 reference(Vec3 value) const { return value * (1 + perturb_); }

  const Knobs& knobs() const { return knobs_; }
  const std::string& engine() const { return engine_.name; }
  Effort effort() const { return effort_; }
  bool full() const { return effort_ >= Effort::full; }
  // How many shifted starts: 32 in the full run, 8 in the quick one (which then says "quick"), 4 in a test.
  int phases();
  // `seconds` in the full run, less in the quick one; the row then says "quick".
  double shortened(double seconds, double quick_seconds);

  // What is left to the runner: every scene that was made, in order.
  const std::vector<std::unique_ptr<Recorder>>& scenes() const { return scenes_; }
  bool was_shortened() const { return shortened_; }
  // Before the first scene: every scene throws Recorder::Enough after so many simulated seconds.
  void count_for(double seconds) { count_for_ = seconds; }
  // Before the first scene: the first one keeps its energy and momenta.
  void trace() { tracing_ = true; }

 private:
  const EngineKind& engine_;
  Knobs knobs_;
  Effort effort_;
  double perturb_;
  bool shortened_ = false, tracing_ = false;
  double count_for_ = INFINITY;
  std::vector<std::unique_ptr<Recorder>> scenes_;
};

struct Part {
  std::string name;       // "e 0.8"; empty where a case has only one
  double goal = 0;        // the largest error that passes
  std::function<Outcome(Trial&)> run;
};

struct Case {
  std::string id;         // "A03"
  std::string title;      // "Bounce height and count"
  std::string scene;      // what there is, in a sentence
  std::string reference;  // where the truth comes from: "F: h1 / h0 = e^2"
  std::string error;      // what the error is: "|h1/h0 - e^2|, worst of the phases"
  std::vector<Part> parts;
  bool accuracy() const { return id[0] == 'A'; }
  bool stability() const { return id[0] == 'B'; }
};

// By id: A01 .. A32, B01 .. B35, and S01 .. for the scenes that separate engines (physics.md).
const std::vector<Case>& all_cases();

}  // namespace tumble::accuracy
