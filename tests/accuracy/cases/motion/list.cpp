#include "accuracy/cases/cases.h"

namespace tumble::accuracy {

Case a01_free_fall();

std::vector<Case> motion_cases() { return {a01_free_fall()}; }

}  // namespace tumble::accuracy
