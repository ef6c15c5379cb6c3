#include "accuracy/cases/cases.h"

namespace tumble::accuracy {

std::vector<Case> stacking_cases() { return {}; }

}  // namespace tumble::accuracy
