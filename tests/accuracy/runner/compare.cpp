#include "accuracy/runner/compare.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

namespace tumble::accuracy {

namespace {

constexpr double kErrorNoise = 1.1, kMarginNoise = 1.5;
constexpr double kTooSmall = 0.1;       // of the goal: below it an error is as good as none
constexpr double kInstructionNoise = 1.02, kCostNoise = 1.1;

std::string arrow(const char* what, double from, double to) {
  char text[96];
  std::snprintf(text, sizeof text, "%s %.3g -> %.3g", what, from, to);
  return text;
}

bool stability(const Row& row) { return row.id[0] == 'B'; }

Verdict by_error(const Row& before, const Row& after) {
  const double noise = stability(after) ? kMarginNoise : kErrorNoise;
  const double floor = kTooSmall * after.goal;
  if (after.error > before.error * noise && after.error > floor) return Verdict::worse;
  if (before.error > after.error * noise && before.error > floor) return Verdict::better;
  return Verdict::same;
}

Change by_cost(const Row& before, const Row& after) {
  Change change{Verdict::same, before, after, ""};
  if (before.instructions && after.instructions) {
    const double ratio = *after.instructions / *before.instructions;
    if (ratio > kInstructionNoise) change.verdict = Verdict::worse;
    if (ratio < 1 / kInstructionNoise) change.verdict = Verdict::better;
    change.what = arrow("instructions a second", *before.instructions, *after.instructions);
  } else if (before.cost_low && before.cost_high && after.cost_low && after.cost_high && after.engine != "stock") {
    if (*after.cost_low > *before.cost_high * kCostNoise) change.verdict = Verdict::worse;
    if (*before.cost_low > *after.cost_high * kCostNoise) change.verdict = Verdict::better;
    change.what = arrow("cost", *before.cost, *after.cost);
  }
  return change;
}

}  // namespace

Change compare(const Row& before, const Row& after) {
  Change change{Verdict::same, before, after, ""};
  if (before.missing() || after.missing()) {
    if (before.missing() == after.missing()) return change;
    change.verdict = before.missing() ? Verdict::better : Verdict::worse;
    change.what = before.missing() ? "was missing, now runs" : after.failed;
    return change;
  }
  if (before.passed != after.passed) {
    change.verdict = after.passed ? Verdict::better : Verdict::worse;
    change.what = std::string(after.passed ? "passes now, " : "passed, now fails, ") + arrow("error", before.error, after.error);
    if (!after.failed.empty()) change.what += " (" + after.failed + ")";
    return change;
  }
  change.verdict = by_error(before, after);
  change.what = arrow("error", before.error, after.error);
  return change.verdict == Verdict::same ? by_cost(before, after) : change;
}

std::vector<Change> compare(const std::vector<Row>& before, const std::vector<Row>& after, int& compared) {
  std::map<std::string, const Row*> known;
  for (const Row& row : before) known[row.key()] = &row;
  std::vector<Change> changes;
  compared = 0;
  for (const Row& row : after) {
    const auto partner = known.find(row.key());
    if (partner == known.end()) continue;
    ++compared;
    const Change change = compare(*partner->second, row);
    if (change.verdict != Verdict::same) changes.push_back(change);
  }
  return changes;
}

bool tell(const std::vector<Change>& changes, int compared) {
  int worse = 0, better = 0;
  for (const Verdict verdict : {Verdict::worse, Verdict::better})
    for (const Change& change : changes) {
      if (change.verdict != verdict) continue;
      ++(verdict == Verdict::worse ? worse : better);
      const Row& row = change.after;
      std::printf("%-7s %s %s%s%s, %s, %s: %s\n", verdict == Verdict::worse ? "WORSE" : "better", row.id.c_str(), row.part.c_str(), row.part.empty() ? "" : ", ",
                  row.engine.c_str(), row.setting.c_str(), row.effort.c_str(), change.what.c_str());
    }
  std::printf("%d rows compared with the baseline: %d worse, %d better\n", compared, worse, better);
  return worse == 0;
}

}  // namespace tumble::accuracy
