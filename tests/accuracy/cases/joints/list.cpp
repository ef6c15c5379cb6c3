#include "accuracy/cases/cases.h"

namespace tumble::accuracy {

std::vector<Case> joint_cases() { return {}; }

}  // namespace tumble::accuracy
