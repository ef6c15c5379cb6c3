// What got better and worse since the frozen baseline, beyond noise.
#pragma once

#include "accuracy/runner/row.h"

namespace tumble::accuracy {

enum class Verdict { same, better, worse };

struct Change {
  Verdict verdict = Verdict::same;
  Row before, after;
  std::string what;       // "passed, now fails: fell at 4.9 s", "error 1.2e-3 -> 4e-3", "cost 1.0 -> 1.4"
};

// One run against its baseline. Errors repeat to the last bits on one machine and build, so a tenth counts; of a
// stability case only passing counts, and its margin where that grew by half. Cost counts by instructions (2 %) where both rows
// have them, else by the ratio to stock where the intervals are a tenth apart.
Change compare(const Row& before, const Row& after);
// Rows of `after` that have a partner of the same key in `before`, those that changed only.
std::vector<Change> compare(const std::vector<Row>& before, const std::vector<Row>& after, int& compared);
// Prints them, the worst first; true if nothing got worse.
bool tell(const std::vector<Change>& changes, int compared);

}  // namespace tumble::accuracy
