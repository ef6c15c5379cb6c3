// One run of one part on one engine at one setting, as a line of the report's CSV.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "accuracy/case.h"

namespace tumble::accuracy {

struct Row {
  std::string version;         // of the project, as git describes it
  std::string engine, id, part;
  std::string effort;          // "full", "quick", "test", "soak": a quick row may be a shortened run
  bool shortened = false;
  std::string setting;         // "default", or "4x10": substeps x iterations
  Knobs knobs;
  double error = 1, goal = 0;
  bool passed = false;
  std::string failed;          // why it counts as failed; "missing: ..." where the engine lacks something
  std::optional<double> bias, worst, energy_drift, max_penetration, max_joint_gap;
  double simulated = 0;        // s of the scene whose cost was measured
  int bodies = 0;
  double contact_points = 0;   // mean
  std::optional<double> us_per_tick;                   // CPU time of a step
  std::optional<double> cost, cost_low, cost_high;     // over stock Bullet's at its defaults, median and 95 % interval
  std::optional<double> instructions;                  // a simulated second, by callgrind

  bool missing() const { return failed.starts_with("missing"); }
  // What makes two rows the same measurement.
  std::string key() const { return engine + "/" + id + "/" + part + "/" + setting + "/" + effort; }
};

std::string effort_name(Effort effort);
std::string setting_name(const Knobs& knobs);

std::string csv_header();
std::string csv_line(const Row& row);
// A line in the order of csv_header(); throws Error where columns are missing.
Row parse_csv_line(const std::string& line);
// Throws Error with the file and line where it is no such file.
std::vector<Row> read_csv(const std::string& file);
void write_csv(const std::string& file, const std::vector<Row>& rows);

}  // namespace tumble::accuracy
