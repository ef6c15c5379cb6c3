#include "accuracy/runner/sweep.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "accuracy/runner/cost.h"

namespace tumble::accuracy {

namespace {

constexpr double kSmallest = 1e-8, kLargest = 1e6;  // what an error is clipped to
constexpr int kMostWork = 640;                      // substeps times iterations
constexpr double kHeavyTick = 2000;                 // us; a case above it sweeps five settings
constexpr std::size_t kHeavySettings = 5;

const int kSubsteps[] = {1, 4, 2, 8, 16, 32};
const int kIterations[] = {10, 4, 40, 1, 20, 2, 80};

std::vector<Knobs> all_knobs() {
  std::vector<Knobs> list = {{1, 10}, {4, 10}, {2, 10}, {8, 10}, {1, 1}, {4, 4}, {16, 10}, {1, 40}, {4, 40}, {32, 10}, {4, 1}, {1, 80}};
  for (const int iterations : kIterations)
    for (const int substeps : kSubsteps) {
      const Knobs knobs{substeps, iterations};
      if (substeps * iterations <= kMostWork && std::find(list.begin(), list.end(), knobs) == list.end()) list.push_back(knobs);
    }
  return list;
}

double clipped(const Case& c, const Outcome& outcome) {
  const bool may_exceed_one = !c.accuracy();  // measured over allowed
  if (!std::isfinite(outcome.error)) return may_exceed_one ? kLargest : 1;
  if (may_exceed_one) return std::clamp(outcome.error, outcome.failed.empty() ? kSmallest : 1.0, kLargest);
  return outcome.failed.empty() ? std::clamp(outcome.error, kSmallest, 1.0) : 1;
}

// The scene that tells most about what the part costs: the one that took longest.
const Recorder* costliest(const Trial& trial) {
  const Recorder* best = nullptr;
  for (const auto& scene : trial.scenes())
    if (!best || scene->step_ms() > best->step_ms()) best = scene.get();
  return best;
}

// In a full run at the default as much as both engines need for the whole scene, if they need alike: a pile's fall says
// nothing of the pile. Not of what takes half a minute.
double cost_budget_ms(Effort effort, bool at_default, double scene_ms) {
  switch (effort) {
    case Effort::test: return 0;
    case Effort::quick: return 40;
    default: return at_default && scene_ms < 30e3 ? std::clamp(2.5 * scene_ms, 400.0, 6000.0) : 400;
  }
}

// How much longer a tick takes at other knobs, roughly: a part of a substep does not depend on iterations.
double relative_work(const Knobs& knobs) { return knobs.substeps * (1 + knobs.iterations / 20.0); }

}  // namespace

double budget(const Options& options) {
  if (options.seconds > 0) return options.seconds;
  switch (options.effort) {
    case Effort::test: return 0.3;
    case Effort::quick: return 1.2;
    case Effort::full: return 40;
    case Effort::soak: return 3600;
  }
  return 0;
}

std::vector<Try> plan(const Case& c, const EngineKind& engine, const Options& options) {
  std::vector<Try> tries;
  const Knobs first = options.knobs && engine.name != "stock" ? *options.knobs : engine.defaults;
  for (const Part& part : c.parts) tries.push_back({&part, first, true});
  if (!options.sweep || options.knobs) return tries;
  for (const Knobs& knobs : all_knobs())
    if (!(knobs == engine.defaults))
      for (const Part& part : c.parts) tries.push_back({&part, knobs, false});
  return tries;
}

Row run_try(const Case& c, const EngineKind& engine, const Try& attempt, const Options& options, const std::string& version) {
  Row row;
  row.version = version;
  row.engine = engine.name;
  row.id = c.id;
  row.part = attempt.part->name;
  row.effort = effort_name(options.effort);
  row.setting = attempt.is_default ? "default" : setting_name(attempt.knobs);
  row.knobs = attempt.knobs;
  row.goal = attempt.part->goal;
  Trial trial(engine, attempt.knobs, options.effort, options.perturb);
  Outcome outcome;
  outcome.error = INFINITY;
  try {
    outcome = attempt.part->run(trial);
  } catch (const Missing& missing) {
    outcome.failed = "missing: " + missing.what;
  } catch (const std::exception& error) {
    outcome.failed = error.what();
  }
  row.error = clipped(c, outcome);
  row.failed = outcome.failed;
  row.passed = outcome.failed.empty() && outcome.error <= row.goal;
  row.bias = outcome.bias;
  row.worst = outcome.worst;
  row.energy_drift = outcome.energy_drift;
  row.max_penetration = outcome.max_penetration;
  row.max_joint_gap = outcome.max_joint_gap;
  row.shortened = trial.was_shortened();
  const Recorder* scene = costliest(trial);
  if (!scene || row.missing()) return row;
  row.simulated = scene->simulated();
  row.bodies = scene->bodies();
  row.contact_points = scene->mean_contact_points();
  const double budget_ms = cost_budget_ms(options.effort, attempt.is_default, scene->step_ms());
  if (budget_ms <= 0) return row;
  if (const auto cost = measure_cost(*scene, engine, attempt.knobs, budget_ms)) {
    row.us_per_tick = cost->us_per_tick;
    row.cost = cost->ratio;
    row.cost_low = cost->low;
    row.cost_high = cost->high;
  }
  return row;
}

void sweep(const Case& c, const EngineKind& engine, const Options& options, const std::string& version, std::size_t first,
           const std::function<void(std::size_t)>& begin, const std::function<void(const Row&)>& told) {
  const std::vector<Try> tries = plan(c, engine, options);
  std::map<const Part*, double> default_ms;  // what a part took at the default setting
  std::map<const Part*, std::size_t> heavy;  // how many settings a heavy part has had
  const double started = thread_ms(), whole = budget(options) * 1e3;
  for (std::size_t i = first; i < tries.size(); ++i) {
    const Try& attempt = tries[i];
    if (!attempt.is_default) {
      const auto known = default_ms.find(attempt.part);
      if (known == default_ms.end() && first == 0) continue;  // it is missing
      const double base = known == default_ms.end() ? 0 : known->second;  // a process after a crash does not know it
      const double expected = base * relative_work(attempt.knobs) / relative_work(engine.defaults);
      if (thread_ms() - started + expected > whole) continue;
      const auto count = heavy.find(attempt.part);
      if (count != heavy.end() && ++count->second > kHeavySettings) continue;
    }
    begin(i);
    const double from = thread_ms();
    const Row row = run_try(c, engine, attempt, options, version);
    told(row);
    if (!attempt.is_default || row.missing()) continue;
    default_ms[attempt.part] = thread_ms() - from;
    if (row.us_per_tick.value_or(0) > kHeavyTick) heavy[attempt.part] = 1;
  }
}

}  // namespace tumble::accuracy
