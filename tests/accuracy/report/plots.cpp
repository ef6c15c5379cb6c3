#include "accuracy/report/plots.h"

#include <sys/wait.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "base/error.h"

namespace tumble::accuracy {

namespace {

const char* const kOurs = "#c0392b";
const char* const kStock = "#8a8f98";

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

std::string tight(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.7g", value);
  return text;
}

// Data blocks and the plot elements that show them.
class Chart {
 public:
  void line(const std::vector<std::pair<double, double>>& points, const std::string& style) {
    if (points.empty()) return;
    const std::string name = "$d" + std::to_string(count_++);
    data_ << name << " << EOD\n";
    for (const auto& [x, y] : points) data_ << tight(x) << ' ' << tight(y) << '\n';
    data_ << "EOD\n";
    element(name + " using 1:2 " + style);
  }
  void element(const std::string& text) { elements_ += (elements_.empty() ? "plot " : ", \\\n  ") + text; }
  std::string script(const std::string& settings) const { return data_.str() + settings + elements_ + "\n"; }
  bool empty() const { return elements_.empty(); }

 private:
  std::ostringstream data_;
  std::string elements_;
  int count_ = 0;
};

std::vector<std::pair<double, double>> envelope(std::vector<CasePoint> points) {
  std::erase_if(points, [](const CasePoint& p) { return !p.cost; });
  std::sort(points.begin(), points.end(), [](const CasePoint& a, const CasePoint& b) { return *a.cost < *b.cost; });
  std::vector<std::pair<double, double>> out;
  for (const CasePoint& p : points)
    if (out.empty() || p.error < out.back().second) out.emplace_back(*p.cost, p.error);
  return out;
}

void add_engine(Chart& chart, const std::vector<CasePoint>& points, const std::string& title, const char* color) {
  std::map<int, std::vector<std::pair<double, double>>> by_iterations;
  std::map<int, std::map<int, const CasePoint*>> sorted;
  for (const CasePoint& p : points) sorted[p.knobs.iterations][p.knobs.substeps] = &p;
  for (const auto& [iterations, list] : sorted)
    for (const auto& [substeps, p] : list)
      if (p->cost) by_iterations[iterations].emplace_back(*p->cost, p->error);
  for (const auto& [iterations, line] : by_iterations)
    chart.line(line, "with linespoints pt 7 ps 0.25 lw 0.6 lc rgb '" + std::string(color) + "' notitle");
  chart.line(envelope(points), "with lines lw 3 lc rgb '" + std::string(color) + "' title '" + title + "'");
  for (const CasePoint& p : points)
    if (p.setting == "default" && p.cost)
      chart.line({{*p.cost, p.error}}, "with points pt 7 ps 1.1 lc rgb '" + std::string(color) + "' title '" + title + ", default " + setting_name(p.knobs) + "'");
}

const char* const kPaper =
    "set grid lc rgb '#e4e6ea' lw 0.5\nset key outside bottom center horizontal maxrows 3 samplen 2 font ',10'\nset tics nomirror\nset border 3 lc rgb '#555555'\n"
    "set xlabel offset 0,0.6\n";
const char* const kLogLog = "set logscale xy\nset format y '10^{%L}'\n";

}  // namespace

namespace {

// Of two in the middle, their geometric mean.
double middle(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return n % 2 ? values[n / 2] : std::sqrt(values[n / 2 - 1] * values[n / 2]);
}

}  // namespace

std::vector<CasePoint> case_points(const std::vector<Row>& rows, const std::string& engine, const std::string& id) {
  std::set<std::string> parts;
  std::map<std::string, std::vector<const Row*>> by_setting;
  for (const Row& row : rows) {
    if (row.engine != engine || row.id != id || row.missing()) continue;
    parts.insert(row.part);
    by_setting[row.setting].push_back(&row);
  }
  std::vector<CasePoint> out;
  for (const auto& [setting, list] : by_setting) {
    if (list.size() != parts.size()) continue;
    std::vector<double> errors, costs;
    for (const Row* row : list) {
      errors.push_back(row->error);
      if (row->cost && *row->cost > 0) costs.push_back(*row->cost);
    }
    CasePoint point{setting, list[0]->knobs, middle(errors), {}};
    if (!costs.empty()) point.cost = middle(costs);
    out.push_back(point);
  }
  return out;
}

std::optional<Plot> cost_plot(const Case& c, const std::vector<Row>& rows) {
  Chart chart;
  add_engine(chart, case_points(rows, "stock", c.id), "stock Bullet", kStock);
  add_engine(chart, case_points(rows, "tumble", c.id), "Tumble", kOurs);
  if (chart.empty()) return {};
  if (c.stability()) {
    chart.element("1 with lines dt 2 lc rgb '#2e7d32' title 'the limit'");
  } else if (!c.accuracy()) {
    chart.element(tight(c.parts.front().goal) + " with lines dt 2 lc rgb '#2e7d32' title 'the goal'");
  } else {
    chart.element("0.01 with lines dt 2 lc rgb '#2e7d32' title '1 %'");
    chart.element("0.001 with lines dt 3 lc rgb '#2e7d32' title '0.1 %'");
  }
  return Plot{lower(c.id) + "-cost.svg", chart.script(std::string(kPaper) + kLogLog + "set xlabel 'cost, stock Bullet at its default = 1'\nset ylabel '" +
                                                      (c.stability() ? "measured / allowed" : "error") + "'\n")};
}

std::optional<Plot> order_plot(const Case& c, const std::vector<Row>& rows) {
  Chart chart;
  double longest = 0, at_longest = 0;
  for (const auto& [engine, color] : {std::pair{"stock", kStock}, std::pair{"tumble", kOurs}}) {
    std::map<double, double> points;
    for (const CasePoint& p : case_points(rows, engine, c.id))
      if (p.knobs.iterations == 10) points[1000 / (60.0 * p.knobs.substeps)] = p.error;
    if (points.size() < 3) continue;
    chart.line({points.begin(), points.end()}, "with linespoints pt 7 ps 0.6 lw 2 lc rgb '" + std::string(color) + "' title '" + (engine == std::string("stock") ? "stock Bullet" : "Tumble") + "'");
    longest = points.rbegin()->first;
    at_longest = std::max(at_longest, points.rbegin()->second);
  }
  if (chart.empty()) return {};
  const std::string scale = tight(at_longest), step = tight(longest);
  chart.element("[x=" + tight(longest / 32) + ":" + step + "] " + scale + " * (x / " + step + ") with lines dt 2 lw 0.7 lc rgb '#555555' title 'slope 1'");
  chart.element("[x=" + tight(longest / 32) + ":" + step + "] " + scale + " * (x / " + step + ")**2 with lines dt 3 lw 0.7 lc rgb '#555555' title 'slope 2'");
  return Plot{lower(c.id) + "-order.svg", chart.script(std::string(kPaper) + kLogLog + "set xlabel 'length of a substep, ms (10 iterations)'\nset ylabel 'error'\nset xrange [0.4:20]\n")};
}

namespace {

struct Quantity {
  const char *name, *label;
  double Trace::* value;
};
const Quantity kEnergy{"energy", "energy of the scene, J", &Trace::energy};
const Quantity kMomentum{"momentum", "momentum, kg m/s", &Trace::momentum};
const Quantity kSpin{"spin", "angular momentum about the origin, kg m^2/s", &Trace::spin};

// What is to stay as it is: energy of what bounces, swings and spins; momentum of what meets; spin of what is free.
struct Traced {
  const char *id, *part;
  std::vector<Quantity> quantities;
};
const Traced kTraced[] = {
    {"A03", "endless, e 1", {kEnergy}},
    {"A09", "energy", {kEnergy, kSpin}},
    {"A12", "hinge 150 deg energy", {kEnergy}},
    {"A19", "energy", {kEnergy, kMomentum}},
};

std::vector<Trace> trace(const Case& c, const std::string& part, const EngineKind& engine) {
  const auto found = std::find_if(c.parts.begin(), c.parts.end(), [&](const Part& p) { return p.name == part; });
  if (found == c.parts.end()) fail("measure: --report: case ", c.id, " has no part '", part, "' to trace");
  Trial trial(engine, engine.defaults, Effort::full);
  trial.trace();
  trial.count_for(60);
  try {
    found->run(trial);
  } catch (const Recorder::Enough&) {
  }
  return trial.scenes().front()->traces();
}

}  // namespace

std::vector<Plot> trace_plots(const Case& c) {
  std::vector<Plot> plots;
  for (const Traced& traced : kTraced) {
    if (c.id != traced.id) continue;
    std::map<std::string, std::vector<Trace>> traces;
    for (const EngineKind& engine : engines()) traces[engine.name] = trace(c, traced.part, engine);
    for (const Quantity& q : traced.quantities) {
      Chart chart;
      for (const auto& [engine, color] : {std::pair{"stock", kStock}, std::pair{"tumble", kOurs}}) {
        std::vector<std::pair<double, double>> points;
        const std::vector<Trace>& list = traces[engine];
        for (std::size_t i = 0; i < list.size(); i += std::max<std::size_t>(1, list.size() / 300)) points.emplace_back(list[i].seconds, list[i].*q.value);
        chart.line(points, "with lines lw 1.5 lc rgb '" + std::string(color) + "' title '" + (engine == std::string("stock") ? "stock Bullet" : "Tumble") + "'");
      }
      plots.push_back({lower(c.id) + "-" + q.name + ".svg", chart.script(std::string(kPaper) + "set format y '%g'\nset offsets graph 0, 0, 0.05, 0.05\nset xlabel 'time, s'\nset ylabel '" + q.label + "'\n")});
    }
  }
  return plots;
}

void draw(const std::string& folder, const std::vector<Plot>& plots) {
  const std::string script = folder + "/plots.gnuplot", log = folder + "/plots.log";
  {
    std::ofstream out(script);
    out << "set terminal svg size 460,330 dynamic font 'sans-serif,11' background '#ffffff'\n";
    for (const Plot& plot : plots) out << "reset\nset output '" << folder << '/' << plot.file << "'\n" << plot.script;
    if (!out.flush()) fail("measure: --report: '", script, "' cannot be written");
  }
  const int status = std::system(("gnuplot '" + script + "' 2>'" + log + "'").c_str());
  if (status != 0) {
    std::ifstream in(log);
    std::stringstream said;
    said << in.rdbuf();
    fail("measure: --report: gnuplot (Debian: gnuplot-nox) failed: ", said.str());
  }
  std::filesystem::remove(script);
  std::filesystem::remove(log);
}

}  // namespace tumble::accuracy
