#include "accuracy/report/page.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <set>
#include <sstream>

#include "accuracy/runner/scalars.h"

namespace tumble::accuracy {

namespace {

const char* const kHead = R"(<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<title>Tumble: speed against error</title>
<style>
body { font: 16px/1.5 system-ui, sans-serif; margin: 0 auto; max-width: 62rem; padding: 1rem; color: #1d2126; background: #fff }
h1 { font-size: 1.6rem } h2 { margin-top: 2.2rem; border-bottom: 1px solid #d9dde3 } h3 { margin: 1.6rem 0 .2rem }
table { border-collapse: collapse; font-size: .86rem; margin: .4rem 0 } th, td { padding: .16rem .5rem; text-align: left; border-bottom: 1px solid #eceff3; white-space: nowrap } th { white-space: normal; vertical-align: bottom }
td.n { text-align: right; font-variant-numeric: tabular-nums } .wide { overflow-x: auto }
.pass { background: #d7f0dc } .near { background: #fdf1c7 } .over { background: #f8d4cf } .none { color: #8a8f98 }
.heat th { white-space: nowrap } .heat td { padding: 0 .3rem; font-size: .72rem; text-align: center } .plots { display: flex; flex-wrap: wrap; gap: .6rem }
.plots img { width: 100%; max-width: 29.5rem; height: auto } p.small { color: #4c535d; font-size: .86rem; margin: .1rem 0 } nav a { margin-right: .45rem; white-space: nowrap }
</style></head><body>
)";

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
  return out;
}

std::string number(double value, const char* format = "%.2e") {
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

// Passed; within ten times the goal (of a stability case: twice); beyond.
const char* color(const Row& row) {
  if (row.missing()) return "none";
  if (row.passed) return "pass";
  const double near = row.id[0] == 'B' ? 2 : 10;
  return row.failed.empty() && row.error <= near * row.goal ? "near" : "over";
}

std::string default_cell(const Row* row) {
  if (!row) return "<td class=none>-</td>";
  if (row->missing()) return "<td class=none>missing</td>";
  return std::string("<td class='n ") + color(*row) + "' title='" + escaped(row->failed) + "'>" + number(row->error) + (row->shortened ? " q" : "") + "</td>";
}

using Defaults = std::map<std::string, std::map<std::string, std::map<std::string, const Row*>>>;  // case, part, engine

Defaults defaults(const std::vector<Row>& rows) {
  Defaults out;
  for (const Row& row : rows)
    if (row.setting == "default") out[row.id][row.part][row.engine] = &row;
  return out;
}

const Row* get(const std::map<std::string, const Row*>& list, const char* engine) {
  const auto found = list.find(engine);
  return found == list.end() ? nullptr : found->second;
}

void write_sums(std::ostream& out, const std::vector<Row>& rows) {
  out << "<h2>In short</h2><div class=wide><table><tr><th>engine<th>digits<th>cost to 1 %<th>cost to 0.1 %<th>parts that never reach 1 %<th>accuracy cases within the goal<th>stability cases passed<th>substeps for 90 % of them</tr>";
  for (const auto& [engine, sum] : scalars(rows)) {
    out << "<tr><td>" << engine << "<td class=n>" << number(sum.median_digits, "%.2f") << "<td class=n>" << number(sum.cost_1, "%.2f") << "<td class=n>" << number(sum.cost_01, "%.2f") << "<td class=n>"
        << sum.unreached_1 << "<td class=n>" << sum.accuracy_passed << " of " << sum.accuracy_cases << "<td class=n>" << sum.stability_passed << " of " << sum.stability_cases << "<td class=n>"
        << (sum.substeps_for_90 ? std::to_string(sum.substeps_for_90) : "more than tried") << "</tr>";
  }
  out << "</table></div><p class=small>Digits: how many decimal digits are right on average over three decades of cost above stock Bullet's cheapest setting, the median of the "
         "accuracy cases. Cost to 1 %: processor time of the cheapest setting whose error is at most 1 %, over that of stock Bullet, geometric mean; a case that no setting "
         "brings there counts ten times its dearest setting. Stability: every part of a case passes at the engine's default setting.</p>";
}

// Settings across, cases down; a cell is the worst part.
void write_heat(std::ostream& out, const std::vector<Row>& rows, const std::string& engine) {
  std::map<std::pair<int, int>, std::string> settings;
  std::map<std::string, std::map<std::pair<int, int>, const Row*>> cells;
  for (const Row& row : rows) {
    if (row.engine != engine || row.missing()) continue;
    const std::pair<int, int> knobs{row.knobs.substeps, row.knobs.iterations};
    settings[knobs] = setting_name(row.knobs);
    const Row*& cell = cells[row.id][knobs];
    const auto badness = [](const Row& r) { return std::pair(r.passed ? 0 : std::string(color(r)) == "near" ? 1 : 2, r.error / std::max(r.goal, 1e-12)); };
    if (!cell || badness(row) > badness(*cell)) cell = &row;
  }
  out << "<h3>" << engine << "</h3><div class=wide><table class=heat><tr><th>";
  for (const auto& [knobs, name] : settings) out << "<th>" << name;
  for (const auto& [id, list] : cells) {
    out << "<tr><th><a href='#" << id << "'>" << id << "</a>";
    for (const auto& [knobs, name] : settings) {
      const auto cell = list.find(knobs);
      if (cell == list.end()) out << "<td>";
      else out << "<td class=" << color(*cell->second) << " title='" << escaped(cell->second->part) << "'>" << number(cell->second->error, "%.0e");
    }
  }
  out << "</table></div>";
}

// The fewest substeps at which a part passes at ten iterations.
std::string fewest(const std::vector<Row>& rows, const Row& of) {
  int best = 0;
  for (const Row& row : rows)
    if (row.engine == of.engine && row.id == of.id && row.part == of.part && row.knobs.iterations == 10 && row.passed && (best == 0 || row.knobs.substeps < best)) best = row.knobs.substeps;
  return best ? std::to_string(best) : "-";
}

void write_matrix(std::ostream& out, const std::vector<Row>& rows, const Defaults& all) {
  out << "<h2>Stability</h2><p class=small>Measured over allowed at the default setting; 1 is the limit. Beside it the fewest substeps at which it passes with ten iterations; - where none of those tried does.</p>"
         "<div class=wide><table><tr><th>case<th>part<th>Tumble<th>substeps<th>stock Bullet<th>substeps<th>what happened</tr>";
  for (const auto& [id, parts] : all) {
    if (id[0] != 'B') continue;
    for (const auto& [part, engines] : parts) {
      const Row *ours = get(engines, "tumble"), *stock = get(engines, "stock");
      out << "<tr><td><a href='#" << id << "'>" << id << "</a><td>" << escaped(part) << default_cell(ours) << "<td class=n>" << (ours ? fewest(rows, *ours) : "") << default_cell(stock) << "<td class=n>"
          << (stock ? fewest(rows, *stock) : "") << "<td>" << escaped(ours ? ours->failed : "") << "</tr>";
    }
  }
  out << "</table></div>";
}

void write_case(std::ostream& out, const Case& c, const Defaults& all, const std::set<std::string>& plots) {
  const auto parts = all.find(c.id);
  if (parts == all.end()) return;
  out << "<h3 id=" << c.id << ">" << c.id << " " << escaped(c.title) << "</h3><p class=small>" << escaped(c.scene) << ". Truth: " << escaped(c.reference) << ". Error: " << escaped(c.error) << ".</p>";
  out << "<div class=wide><table><tr><th>part<th>Tumble<th>stock Bullet<th>goal<th>cost over stock's<th></tr>";
  for (const Part& part : c.parts) {
    const auto engines = parts->second.find(part.name);
    if (engines == parts->second.end()) continue;
    const Row *ours = get(engines->second, "tumble"), *stock = get(engines->second, "stock");
    out << "<tr><td>" << escaped(part.name) << default_cell(ours) << default_cell(stock) << "<td class=n>" << number(part.goal, "%.0e") << "<td class=n>" << (ours && ours->cost ? number(*ours->cost, "%.2f") : "") << "<td>"
        << escaped(ours ? ours->failed : "") << "</tr>";
  }
  out << "</table></div><div class=plots>";
  std::string id = c.id;
  std::transform(id.begin(), id.end(), id.begin(), [](unsigned char x) { return std::tolower(x); });
  const std::pair<const char*, const char*> kinds[] = {{"cost", "error against cost"}, {"order", "error against the length of a substep"}, {"energy", "energy over time"}, {"momentum", "momentum over time"}, {"spin", "angular momentum over time"}};
  for (const auto& [kind, words] : kinds) {
    const std::string file = id + "-" + kind + ".svg";
    if (plots.contains(file)) out << "<img loading=lazy src='" << file << "' alt='" << c.id << ": " << words << "'>";
  }
  out << "</div>";
}

}  // namespace

std::string page(const std::vector<Row>& rows, const std::vector<Plot>& plots) {
  std::set<std::string> files;
  for (const Plot& plot : plots) files.insert(plot.file);
  const Defaults all = defaults(rows);
  std::ostringstream out;
  out << kHead << "<h1>Speed against error</h1><p>Each case has a scene whose truth is known. Tumble and stock Bullet (Debian's 3.24 in single precision, with its own world and defaults) "
      << "run it at many settings; what they get wrong is drawn against what they cost. Lower and further left is better; a dot is one setting, the middle one of the case's parts. Version " << escaped(rows.empty() ? "" : rows.front().version)
      << "; <code>./tumble measure --full --report docs/accuracy</code> makes this page anew, and docs/guide/accuracy.md tells how to read it. "
      << "Green: within the goal; yellow: within ten times the goal (stability: twice); red: beyond; q: a shortened run. "
      << "An error below 1e-8 counts as 1e-8, one of an accuracy case above 1 as 1. In the plots thin lines join settings of equal iterations, the bold line is the best for its cost, "
      << "the big dot is the default. Tables scroll sideways.</p><nav>";
  for (const auto& [id, parts] : all) out << "<a href='#" << id << "'>" << id << "</a> ";
  out << "</nav>";
  write_sums(out, rows);
  write_matrix(out, rows, all);
  out << "<h2>Settings</h2><p class=small>4x10 is four substeps of ten iterations. A cell is the part that is furthest beyond its goal (its name shows under the pointer); an empty one was not run.</p>";
  write_heat(out, rows, "tumble");
  write_heat(out, rows, "stock");
  const std::pair<char, const char*> groups[] = {{'A', "Accuracy, case by case"}, {'B', "Stability, case by case"}, {'S', "Scenes that separate engines"}};
  for (const auto& [letter, title] : groups) {
    out << "<h2>" << title << "</h2>";
    for (const Case& c : all_cases())
      if (c.id[0] == letter) write_case(out, c, all, files);
  }
  out << "</body></html>\n";
  return out.str();
}

}  // namespace tumble::accuracy
