// Runs cases in processes of their own: one that crashes or hangs costs its row and nothing else.
#pragma once

#include "accuracy/runner/sweep.h"

namespace tumble::accuracy {

// All rows, ordered by case, engine and plan. Progress and the time left go to standard error.
std::vector<Row> run_all(const Options& options, const std::string& version);

}  // namespace tumble::accuracy
