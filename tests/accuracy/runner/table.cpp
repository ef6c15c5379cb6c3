#include "accuracy/runner/table.h"

#include <cstdio>
#include <map>

#include "accuracy/runner/scalars.h"

namespace tumble::accuracy {

namespace {

std::string cell(const Row* row) {
  if (!row) return "-";
  if (row->missing()) return "missing";
  char text[48];
  std::snprintf(text, sizeof text, "%.2e %s", row->error, row->passed ? "pass" : row->failed.empty() ? "over" : "FAIL");
  return text;
}

std::string cost_cell(const Row* row) {
  if (!row || !row->cost) return "";
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", *row->cost);
  return text;
}

std::string note(const Row* ours, const Row* stock) {
  if (ours && !ours->failed.empty()) return ours->failed;
  if (stock && stock->missing()) return "stock: " + stock->failed;
  return "";
}

void print_sums(const std::vector<Row>& rows) {
  std::printf("\n%-8s %14s %22s %14s %18s %16s\n", "engine", "mean digits", "cost to 1 % (0.1 %)", "accuracy", "stability", "unreached 1 %");
  for (const auto& [engine, sum] : scalars(rows)) {
    char cost[48], accuracy[32], stability[32];
    std::snprintf(cost, sizeof cost, "%.2f (%.2f)", sum.cost_1, sum.cost_01);
    std::snprintf(accuracy, sizeof accuracy, "%d of %d", sum.accuracy_passed, sum.accuracy_cases);
    std::snprintf(stability, sizeof stability, "%d of %d", sum.stability_passed, sum.stability_cases);
    std::printf("%-8s %14.2f %22s %14s %18s %16d\n", engine.c_str(), sum.median_digits, cost, accuracy, stability, sum.unreached_1);
  }
}

}  // namespace

void print_table(const std::vector<Row>& rows) {
  // In the order in which they first appear.
  std::vector<std::pair<std::string, std::string>> order;
  std::map<std::pair<std::string, std::string>, std::map<std::string, const Row*>> cells;
  for (const Row& row : rows) {
    if (row.setting != "default") continue;
    auto& list = cells[{row.id, row.part}];
    if (list.empty()) order.emplace_back(row.id, row.part);
    list[row.engine] = &row;
  }
  std::printf("%-4s %-30s %-14s %-14s %8s %8s  %s\n", "case", "part", "tumble", "stock", "goal", "cost", "");
  for (const auto& key : order) {
    const auto& list = cells[key];
    const auto find = [&](const char* engine) { return list.contains(engine) ? list.at(engine) : nullptr; };
    const Row *ours = find("tumble"), *stock = find("stock"), *any = ours ? ours : stock;
    std::printf("%-4s %-30.30s %-14s %-14s %8.1e %8s  %s%s\n", key.first.c_str(), key.second.c_str(), cell(ours).c_str(), cell(stock).c_str(), any->goal, cost_cell(ours).c_str(),
                any->shortened ? "quick " : "", note(ours, stock).c_str());
  }
  print_sums(rows);
}

}  // namespace tumble::accuracy
