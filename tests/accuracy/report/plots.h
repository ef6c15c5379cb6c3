// The report's plots, drawn by gnuplot as SVG.
#pragma once

#include "accuracy/case.h"
#include "accuracy/runner/row.h"

namespace tumble::accuracy {

// One setting of one engine in one case, where it ran on every part that is not missing: the middle one of the parts'
// errors and costs. A mean would hide a bad part behind one that is right to the last digit.
struct CasePoint {
  std::string setting;
  Knobs knobs;
  double error = 1;
  std::optional<double> cost;
};
std::vector<CasePoint> case_points(const std::vector<Row>& rows, const std::string& engine, const std::string& id);

struct Plot {
  std::string file;    // "a03-cost.svg"
  std::string script;  // gnuplot's, without terminal and output
};

// Error against cost: a line for each number of iterations with substeps as its parameter, the lower left envelope
// bold, the default as a big dot, stock Bullet grey. Nothing where no setting has a cost.
std::optional<Plot> cost_plot(const Case& c, const std::vector<Row>& rows);
// Error against the length of a substep at ten iterations, with slopes 1 and 2. Nothing with fewer than three lengths.
std::optional<Plot> order_plot(const Case& c, const std::vector<Row>& rows);
// Energy or momenta over time on both engines at their defaults, of the cases where they are to stay; runs them.
std::vector<Plot> trace_plots(const Case& c);

// Throws Error with gnuplot's words where it fails or is missing.
void draw(const std::string& folder, const std::vector<Plot>& plots);

}  // namespace tumble::accuracy
