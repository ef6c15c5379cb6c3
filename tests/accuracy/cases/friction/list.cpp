#include "accuracy/cases/cases.h"

namespace tumble::accuracy {

std::vector<Case> friction_cases() { return {}; }

}  // namespace tumble::accuracy
