// The few numbers that sum an engine up; accuracy.md, section 3, says why these and never one.
#pragma once

#include <map>

#include "accuracy/runner/row.h"

namespace tumble::accuracy {

struct CaseScalars {
  int parts = 0;                    // that ran on this engine
  double digits = 0;                // D: mean of -log10(error) over three decades of cost above stock's cheapest setting
  double error_at_budget = 1;       // the best error at no more than the cost of stock's default; geometric mean of the parts
  std::optional<double> cost_1, cost_01;  // cheapest setting within 1 % and 0.1 %, over stock's cheapest; geometric mean
  int unreached_1 = 0, unreached_01 = 0;  // parts where no setting got there
  bool passed = false;              // every part, at the default setting
};

struct EngineScalars {
  std::map<std::string, CaseScalars> cases;  // by id; those that run on it at least in part
  double median_digits = 0;                  // over the A cases
  double cost_1 = 1, cost_01 = 1;            // geometric means over the A cases, to stock
  int unreached_1 = 0, unreached_01 = 0;
  int stability_passed = 0, stability_cases = 0, accuracy_passed = 0, accuracy_cases = 0;
  int substeps_for_90 = 0;                   // substeps at which nine of ten stability cases pass; 0: none tried
};

std::map<std::string, EngineScalars> scalars(const std::vector<Row>& rows);

}  // namespace tumble::accuracy
