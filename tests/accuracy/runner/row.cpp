#include "accuracy/runner/row.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "base/error.h"

namespace tumble::accuracy {

namespace {

// One description of the columns serves the writer and the reader.
template <class Visit>
void columns(Row& r, Visit&& visit) {
  visit("version", r.version);
  visit("engine", r.engine);
  visit("case", r.id);
  visit("part", r.part);
  visit("effort", r.effort);
  visit("shortened", r.shortened);
  visit("setting", r.setting);
  visit("substeps", r.knobs.substeps);
  visit("iterations", r.knobs.iterations);
  visit("error", r.error);
  visit("goal", r.goal);
  visit("passed", r.passed);
  visit("failed", r.failed);
  visit("bias", r.bias);
  visit("worst", r.worst);
  visit("energy_drift", r.energy_drift);
  visit("max_penetration", r.max_penetration);
  visit("max_joint_gap", r.max_joint_gap);
  visit("simulated", r.simulated);
  visit("bodies", r.bodies);
  visit("contact_points", r.contact_points);
  visit("us_per_tick", r.us_per_tick);
  visit("cost", r.cost);
  visit("cost_low", r.cost_low);
  visit("cost_high", r.cost_high);
  visit("instructions", r.instructions);
}

std::string text(const std::string& value) {
  if (value.find_first_of(",\"\n") == std::string::npos) return value;
  std::string out = "\"";
  for (const char c : value) {
    if (c == '"') out += '"';
    out += c == '\n' ? ' ' : c;
  }
  return out + '"';
}
std::string text(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.6g", value);
  return buffer;
}
std::string text(int value) { return std::to_string(value); }
std::string text(bool value) { return value ? "1" : "0"; }
std::string text(const std::optional<double>& value) { return value ? text(*value) : ""; }

void read(const std::string& word, std::string& out) { out = word; }
void read(const std::string& word, double& out) { out = std::strtod(word.c_str(), nullptr); }
void read(const std::string& word, int& out) { out = std::atoi(word.c_str()); }
void read(const std::string& word, bool& out) { out = word == "1"; }
void read(const std::string& word, std::optional<double>& out) {
  out.reset();
  if (!word.empty()) out = std::strtod(word.c_str(), nullptr);
}

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> words(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (quoted && c == '"' && i + 1 < line.size() && line[i + 1] == '"') words.back() += line[++i];
    else if (c == '"') quoted = !quoted;
    else if (c == ',' && !quoted) words.emplace_back();
    else if (c != '\r') words.back() += c;
  }
  return words;
}

}  // namespace

std::string effort_name(Effort effort) {
  switch (effort) {
    case Effort::test: return "test";
    case Effort::quick: return "quick";
    case Effort::full: return "full";
    case Effort::soak: return "soak";
  }
  return "";
}

std::string setting_name(const Knobs& knobs) { return std::to_string(knobs.substeps) + "x" + std::to_string(knobs.iterations); }

std::string csv_header() {
  std::string out;
  Row row;
  columns(row, [&](const char* name, auto&) { out += (out.empty() ? "" : ",") + std::string(name); });
  return out;
}

std::string csv_line(const Row& given) {
  std::string out;
  Row row = given;
  bool first = true;
  columns(row, [&](const char*, auto& value) {
    if (!std::exchange(first, false)) out += ',';
    out += text(value);
  });
  return out;
}

Row parse_csv_line(const std::string& line) {
  const std::vector<std::string> words = split(line);
  std::size_t i = 0;
  Row row;
  columns(row, [&](const char* name, auto& value) {
    if (i >= words.size()) fail("measure: a row has no column '", name, "': ", line);
    read(words[i++], value);
  });
  return row;
}

std::vector<Row> read_csv(const std::string& file) {
  std::ifstream in(file);
  std::string line;
  if (!in || !std::getline(in, line)) fail("measure: '", file, "' cannot be read; a CSV that measure wrote was expected");
  const std::vector<std::string> names = split(line);
  std::vector<Row> rows;
  for (int number = 2; std::getline(in, line); ++number) {
    if (line.empty()) continue;
    const std::vector<std::string> words = split(line);
    if (words.size() != names.size())
      fail("measure: ", file, ":", number, ": ", words.size(), " columns where the first line names ", names.size(), "; write the file anew with --csv");
    Row row;
    columns(row, [&](const char* name, auto& value) {
      for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == name) read(words[i], value);
    });
    rows.push_back(row);
  }
  return rows;
}

void write_csv(const std::string& file, const std::vector<Row>& rows) {
  std::ofstream out(file);
  out << csv_header() << '\n';
  for (const Row& row : rows) out << csv_line(row) << '\n';
  if (!out.flush()) fail("measure: '", file, "' cannot be written");
}

}  // namespace tumble::accuracy
