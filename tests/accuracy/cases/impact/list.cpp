#include "accuracy/cases/cases.h"

namespace tumble::accuracy {

std::vector<Case> impact_cases() { return {}; }

}  // namespace tumble::accuracy
