#include "accuracy/cases/cases.h"

namespace tumble::accuracy {

std::vector<Case> life_cases() { return {}; }

}  // namespace tumble::accuracy
