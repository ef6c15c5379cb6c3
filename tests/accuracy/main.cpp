// The program behind `tumble measure`: runs cases, prints a table, writes rows, compares, reports.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "accuracy/report/report.h"
#include "accuracy/runner/compare.h"
#include "accuracy/runner/instructions.h"
#include "accuracy/runner/runner.h"
#include "accuracy/runner/table.h"
#include "base/error.h"

namespace fs = std::filesystem;

namespace tumble::accuracy {

namespace {

struct Words {
  Options options;
  bool quick = false, full = false, test = false, soak = false, default_only = false, list = false, compare = false;
  std::string csv, report, knobs, baseline, version = "unknown";
  std::vector<std::string> count;  // engine, case, part, knobs
  std::vector<std::string> rows;   // CSV files to report or compare instead of running
};

Knobs parse_knobs(const std::string& text) {
  Knobs knobs;
  if (std::sscanf(text.c_str(), "%dx%d", &knobs.substeps, &knobs.iterations) != 2 || knobs.substeps < 1 || knobs.iterations < 1)
    fail("measure: --knobs: '", text, "' is no setting; give SUBSTEPSxITERATIONS, such as 4x10");
  return knobs;
}

void print_list() {
  for (const Case& c : all_cases()) {
    std::printf("%s  %s: %s\n     truth: %s\n     error: %s\n     parts:", c.id.c_str(), c.title.c_str(), c.scene.c_str(), c.reference.c_str(), c.error.c_str());
    for (const Part& part : c.parts) std::printf(" [%s]", part.name.c_str());
    std::printf("\n");
  }
}

std::vector<Row> read_all(const std::vector<std::string>& files) {
  std::vector<Row> rows;
  for (const std::string& file : files) {
    const std::vector<Row> more = read_csv(file);
    rows.insert(rows.end(), more.begin(), more.end());
  }
  return rows;
}

std::vector<Row> baseline(const std::string& folder) {
  std::vector<std::string> files;
  if (fs::is_directory(folder))
    for (const auto& entry : fs::directory_iterator(folder))
      if (entry.path().extension() == ".csv") files.push_back(entry.path().string());
  if (files.empty()) fail("measure: --compare: no baseline in '", folder, "'; a folder of CSV files that measure wrote was expected");
  std::sort(files.begin(), files.end());
  return read_all(files);
}

void add_instructions(std::vector<Row>& rows) {
  for (const Case& c : all_cases())
    for (std::size_t part = 0; part < c.parts.size() && part < 1; ++part)
      for (Row& row : rows)
        if (row.id == c.id && row.part == c.parts[part].name && row.setting == "default" && !row.missing()) {
          std::fprintf(stderr, "counting instructions: %s %s\n", row.id.c_str(), row.engine.c_str());
          row.instructions = count_instructions(row.engine, c.id, static_cast<int>(part), row.knobs);
        }
}

// Which of the parts that pass did a spoiled reference bring to fall? Those that it did not have no reference number, or
// a goal wider than what was spoiled.
void tell_perturbed(Options options, const std::string& version, const std::vector<Row>& spoiled) {
  options.perturb = 0;
  options.sweep = false;
  const std::vector<Row> right = run_all(options, version);
  int passing = 0, noticed = 0;
  std::string blind;
  for (const Row& row : right)
    for (const Row& other : spoiled) {
      if (other.key() != row.key() || !row.passed) continue;
      ++passing;
      noticed += !other.passed;
      if (other.passed) blind += "\n  still passes: " + row.id + " " + row.part + ", " + row.engine;
    }
  std::printf("\nspoiled references: %d of %d parts that pass fail now%s\n", noticed, passing, blind.c_str());
}

int measure(Words& words) {
  if (words.list) return print_list(), 0;
  if (!words.count.empty()) return play_for_count(words.count.at(0), words.count.at(1), std::stoi(words.count.at(2)), parse_knobs(words.count.at(3)));
  Options& options = words.options;
  options.effort = words.soak ? Effort::soak : words.full ? Effort::full : words.test ? Effort::test : Effort::quick;
  options.sweep = !words.default_only;
  if (!words.knobs.empty()) options.knobs = parse_knobs(words.knobs);
  const std::vector<Row> before = words.compare ? baseline(words.baseline) : std::vector<Row>();
  const auto keep = [&](const std::vector<Row>& so_far) {
    if (!words.csv.empty()) write_csv(words.csv, so_far);
  };
  std::vector<Row> rows = words.rows.empty() ? run_all(options, words.version, keep) : read_all(words.rows);
  if (options.instructions) add_instructions(rows);
  print_table(rows);
  if (!words.csv.empty()) write_csv(words.csv, rows);
  if (!words.report.empty()) write_report(words.report, rows);
  if (options.perturb != 0) tell_perturbed(options, words.version, rows);
  if (!words.compare) return 0;
  int compared = 0;
  const std::vector<Change> changes = compare(before, rows, compared);
  if (compared == 0) fail("measure: --compare: no row has a partner in '", words.baseline, "'; the baseline holds other cases, settings or efforts");
  return tell(changes, compared) ? 0 : 1;
}

}  // namespace

}  // namespace tumble::accuracy

int main(int count, char** arguments) {
  using namespace tumble::accuracy;
  Words words;
  CLI::App app("Speed against error: the accuracy and stability suite");
  app.add_flag("--quick", words.quick, "At most three minutes; long runs are shortened and say so (the default)");
  app.add_flag("--full", words.full, "Every setting that 40 s a case and engine allow; up to two hours");
  app.add_flag("--soak", words.soak, "The full forms of the cases that take minutes to hours");
  app.add_flag("--test", words.test, "The shortest form, as the tests run it");
  app.add_option("case,--case", words.options.cases, "Only these: A03 B01 ...")->delimiter(',');
  app.add_option("--engine", words.options.engines, "Only this: tumble or stock")->delimiter(',');
  app.add_flag("--default-only", words.default_only, "No other settings than each engine's default");
  app.add_option("--knobs", words.knobs, "SUBSTEPSxITERATIONS in place of our default");
  app.add_option("--perturb", words.options.perturb, "Spoils every reference by this part of itself, such as 0.01");
  app.add_flag("--instructions", words.options.instructions, "Counts instructions by valgrind too");
  app.add_option("--jobs", words.options.jobs, "Cases at once (2)");
  app.add_option("--seconds", words.options.seconds, "CPU seconds for the settings of a case on an engine (1.2 quick, 40 full)");
  app.add_option("--rows", words.rows, "Takes the rows of these CSV files instead of running");
  app.add_option("--csv", words.csv, "Writes the rows there");
  app.add_option("--report", words.report, "Writes index.html and its plots into this folder");
  app.add_flag("--compare", words.compare, "Says what got better or worse than the baseline; status 1 where something got worse");
  app.add_option("--baseline", words.baseline, "The folder of the baseline");
  app.add_option("--revision", words.version, "What the rows say of the project's version");
  app.add_flag("--list", words.list, "Names the cases");
  app.add_option("--count", words.count)->expected(4)->group("");
  CLI11_PARSE(app, count, arguments);
  try {
    return measure(words);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
