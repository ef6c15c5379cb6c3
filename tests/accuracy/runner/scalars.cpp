#include "accuracy/runner/scalars.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace tumble::accuracy {

namespace {

constexpr double kDecades = 3, kMostDigits = 8;
constexpr double kUnreached = 10;  // an accuracy that no setting reaches counts as ten times the dearest one tried

struct Point {
  double cost, error;
};

std::vector<Point> points(const std::vector<const Row*>& rows) {
  std::vector<Point> list;
  for (const Row* row : rows)
    if (row->cost) list.push_back({*row->cost, row->error});
  std::sort(list.begin(), list.end(), [](const Point& a, const Point& b) { return a.cost < b.cost; });
  return list;
}

// The area under the running minimum of log10 error, over three decades of cost.
double digits(const std::vector<Point>& list, double from) {
  double area = 0, best = 0, at = std::log10(from);
  const double end = at + kDecades;
  for (const Point& p : list) {
    const double x = std::min(std::log10(p.cost), end);
    if (x > at) {
      area += best * (x - at);
      at = x;
    }
    best = std::min(best, std::max(-kMostDigits, std::log10(p.error)));
  }
  area += best * (end - at);
  return -area / kDecades;
}

double cheapest(const std::vector<Point>& list, double error, bool& reached) {
  for (const Point& p : list)
    if (p.error <= error) {
      reached = true;
      return p.cost;
    }
  reached = false;
  return list.back().cost * kUnreached;
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return n % 2 ? values[n / 2] : (values[n / 2 - 1] + values[n / 2]) / 2;
}

using Parts = std::map<std::string, std::map<std::string, std::vector<const Row*>>>;  // case, part

struct Sums {
  double log = 0;
  int count = 0;
  void add(double value) {
    log += std::log10(value);
    ++count;
  }
  double mean() const { return count ? std::pow(10, log / count) : 1; }
};

CaseScalars of_case(const std::map<std::string, std::vector<const Row*>>& parts, const Parts& stock, const std::string& id) {
  CaseScalars out;
  out.passed = true;
  Sums at_budget, one, tenth;
  double digit_sum = 0;
  int measured = 0;
  for (const auto& [name, rows] : parts) {
    const Row* standard = nullptr;
    for (const Row* row : rows)
      if (row->setting == "default") standard = row;
    out.passed = out.passed && standard && standard->passed;
    if (!standard || standard->missing()) continue;
    ++out.parts;
    const std::vector<Point> list = points(rows);
    if (list.empty()) continue;
    double from = 1;
    std::vector<Point> theirs;
    if (stock.contains(id) && stock.at(id).contains(name)) theirs = points(stock.at(id).at(name));
    if (!theirs.empty()) from = theirs.front().cost;
    digit_sum += digits(list, from);
    ++measured;
    double best = 1;
    for (const Point& p : list)
      if (p.cost <= 1.05) best = std::min(best, p.error);
    at_budget.add(best);
    if (theirs.empty()) continue;
    bool reached = false, stock_reached = false;
    one.add(cheapest(list, 1e-2, reached) / cheapest(theirs, 1e-2, stock_reached));
    out.unreached_1 += !reached;
    tenth.add(cheapest(list, 1e-3, reached) / cheapest(theirs, 1e-3, stock_reached));
    out.unreached_01 += !reached;
  }
  out.digits = measured ? digit_sum / measured : 0;
  out.error_at_budget = at_budget.mean();
  if (one.count) out.cost_1 = one.mean();
  if (tenth.count) out.cost_01 = tenth.mean();
  return out;
}

// The share of cases whose every part passes at so many substeps (ten iterations, or the default).
int substeps_for_90(const Parts& parts) {
  std::set<int> tried;
  for (const auto& [id, list] : parts)
    for (const auto& [name, rows] : list)
      for (const Row* row : rows)
        if (id[0] == 'B' && row->knobs.iterations == 10) tried.insert(row->knobs.substeps);
  for (const int substeps : tried) {
    int passed = 0, whole = 0;
    for (const auto& [id, list] : parts) {
      if (id[0] != 'B') continue;
      bool all = true;
      for (const auto& [name, rows] : list)
        all = all && std::any_of(rows.begin(), rows.end(), [&](const Row* r) { return r->passed && r->knobs.substeps == substeps && r->knobs.iterations == 10; });
      ++whole;
      passed += all;
    }
    if (whole && passed >= 0.9 * whole) return substeps;
  }
  return 0;
}

}  // namespace

std::map<std::string, EngineScalars> scalars(const std::vector<Row>& rows) {
  std::map<std::string, Parts> engines;
  for (const Row& row : rows) engines[row.engine][row.id][row.part].push_back(&row);
  std::map<std::string, EngineScalars> out;
  const Parts none, &stock = engines.contains("stock") ? engines.at("stock") : none;
  for (const auto& [engine, cases] : engines) {
    EngineScalars& sum = out[engine];
    std::vector<double> all_digits;
    Sums one, tenth;
    for (const auto& [id, parts] : cases) {
      const CaseScalars c = of_case(parts, stock, id);
      sum.cases[id] = c;
      if (id[0] == 'B') {
        ++sum.stability_cases;
        sum.stability_passed += c.passed;
      }
      if (id[0] != 'A') continue;
      ++sum.accuracy_cases;
      sum.accuracy_passed += c.passed;
      if (!c.parts) continue;
      all_digits.push_back(c.digits);
      if (c.cost_1) one.add(*c.cost_1);
      if (c.cost_01) tenth.add(*c.cost_01);
      sum.unreached_1 += c.unreached_1;
      sum.unreached_01 += c.unreached_01;
    }
    sum.median_digits = median(all_digits);
    sum.cost_1 = one.mean();
    sum.cost_01 = tenth.mean();
    sum.substeps_for_90 = substeps_for_90(cases);
  }
  return out;
}

}  // namespace tumble::accuracy
