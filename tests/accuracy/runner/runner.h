// Runs cases in processes of their own: one that crashes or hangs costs its row and nothing else.
#pragma once

#include "accuracy/runner/sweep.h"

namespace tumble::accuracy {

// All rows, ordered by case, engine and plan. Progress and the time left go to standard error. `so_far` is shown the rows
// each time a case ends on an engine, so that a long run that is broken off has not been in vain.
std::vector<Row> run_all(const Options& options, const std::string& version,
                         const std::function<void(const std::vector<Row>&)>& so_far = {});

}  // namespace tumble::accuracy
