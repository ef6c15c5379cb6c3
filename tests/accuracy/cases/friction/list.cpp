#include "accuracy/cases/cases.h"

namespace tumble::accuracy {

Case a04_incline();
Case a05_isotropy();
Case a06_rolling();
Case a07_push_under_load();
Case a08_spin_friction();

std::vector<Case> friction_cases() { return {a04_incline(), a05_isotropy(), a06_rolling(), a07_push_under_load(), a08_spin_friction()}; }

}  // namespace tumble::accuracy
