#include "accuracy/cases/cases.h"

namespace tumble::accuracy {

Case a24_carrier();
Case b16_press();
Case b21_scaling();
Case b22_removal();

std::vector<Case> life_cases() { return {a24_carrier(), b16_press(), b21_scaling(), b22_removal()}; }

}  // namespace tumble::accuracy
