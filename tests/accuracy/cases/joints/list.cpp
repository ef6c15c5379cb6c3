#include "accuracy/cases/cases.h"

namespace tumble::accuracy {

Case a12_pendulum();
Case a13_double_pendulum();
Case s05_ten_links();

std::vector<Case> joint_cases() { return {a12_pendulum(), a13_double_pendulum(), s05_ten_links()}; }

}  // namespace tumble::accuracy
