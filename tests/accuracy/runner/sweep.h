// A case on one engine: which settings are tried, in which order, and the row that one try gives.
#pragma once

#include "accuracy/runner/row.h"

namespace tumble::accuracy {

struct Options {
  Effort effort = Effort::quick;
  std::vector<std::string> cases;    // ids; empty: all
  std::vector<std::string> engines;  // empty: all
  std::optional<Knobs> knobs;        // spoils the default setting of our engine
  double perturb = 0;                // spoils every reference by so much of itself
  bool sweep = true;                 // else the default setting only
  bool instructions = false;         // count them by callgrind
  int jobs = 2;
  double seconds = 0;                // CPU time for one case on one engine; 0: as the effort has it
};

// CPU seconds for one case on one engine.
double budget(const Options& options);

struct Try {
  const Part* part = nullptr;
  Knobs knobs;
  bool is_default = false;
};
// The default setting for every part first, then the others, from what tells most to what tells least: substeps at ten
// iterations, iterations at few substeps, the rest; substeps times iterations is at most 640.
std::vector<Try> plan(const Case& c, const EngineKind& engine, const Options& options);

// Runs it once for the error and once for the cost.
Row run_try(const Case& c, const EngineKind& engine, const Try& attempt, const Options& options, const std::string& version);

// The tries of the plan from `first` on that the budget allows. `begin` is told each index, `row` its row.
void sweep(const Case& c, const EngineKind& engine, const Options& options, const std::string& version, std::size_t first,
           const std::function<void(std::size_t)>& begin, const std::function<void(const Row&)>& row);

}  // namespace tumble::accuracy
