#include "accuracy/cases/cases.h"

namespace tumble::accuracy {

std::vector<Case> query_cases() { return {}; }

}  // namespace tumble::accuracy
