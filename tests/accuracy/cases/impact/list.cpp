#include "accuracy/cases/cases.h"

namespace tumble::accuracy {

Case a03_bounce();

std::vector<Case> impact_cases() { return {a03_bounce()}; }

}  // namespace tumble::accuracy
