#include "accuracy/case.h"

#include <algorithm>

#include "accuracy/cases/cases.h"

namespace tumble::accuracy {

Trial::Trial(const EngineKind& engine, Knobs knobs, Effort effort, double perturb) : engine_(engine), knobs_(knobs), effort_(effort), perturb_(perturb) {}

Simulation& Trial::scene(const SceneSettings& settings) { return scene(settings, knobs_); }

Simulation& Trial::scene(const SceneSettings& settings, const Knobs& knobs) {
  scenes_.push_back(std::make_unique<Recorder>(engine_.make(settings, knobs), settings));
  scenes_.back()->stop_after(count_for_);
  if (tracing_ && scenes_.size() == 1) scenes_.back()->trace();
  return *scenes_.back();
}

int Trial::phases() {
  shortened_ = shortened_ || !full();
  switch (effort_) {
    case Effort::test: return 4;
    case Effort::quick: return 8;
    default: return 32;
  }
}

double Trial::shortened(double seconds, double quick_seconds) {
  if (full() || quick_seconds >= seconds) return seconds;
  shortened_ = true;
  return quick_seconds;
}

const std::vector<Case>& all_cases() {
  static const std::vector<Case> cases = [] {
    std::vector<Case> all;
    for (const auto& group : {motion_cases(), impact_cases(), friction_cases(), joint_cases(), stacking_cases(), life_cases(), query_cases()})
      all.insert(all.end(), group.begin(), group.end());
    std::sort(all.begin(), all.end(), [](const Case& a, const Case& b) { return a.id < b.id; });
    return all;
  }();
  return cases;
}

}  // namespace tumble::accuracy
