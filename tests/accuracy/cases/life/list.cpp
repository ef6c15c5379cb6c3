#include "accuracy/cases/cases.h"

namespace tumble::accuracy {

Case a24_carrier();
Case b16_press();
Case b21_scaling();
Case b22_removal();
Case b25_time_steps();
Case b26_sleep();
Case b28_degenerate();
Case b29_soak();
Case b30_determinism();
Case b33_switches();

std::vector<Case> life_cases() {
  return {a24_carrier(), b16_press(), b21_scaling(), b22_removal(), b25_time_steps(), b26_sleep(), b28_degenerate(), b29_soak(), b30_determinism(), b33_switches()};
}

}  // namespace tumble::accuracy
