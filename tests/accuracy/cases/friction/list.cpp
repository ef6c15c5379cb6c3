#include "accuracy/cases/cases.h"

namespace tumble::accuracy {

Case a04_incline();
Case a05_isotropy();
Case a06_rolling();
Case a07_push_under_load();
Case a08_spin_friction();
Case a29_toppling();
Case b20_planks();
Case b27_painleve_rod();
Case b32_eulers_disk();
Case s06_slide_with_spin();

std::vector<Case> friction_cases() {
  return {a04_incline(),  a05_isotropy(), a06_rolling(),      a07_push_under_load(), a08_spin_friction(),
          a29_toppling(), b20_planks(),   b27_painleve_rod(), b32_eulers_disk(),     s06_slide_with_spin()};
}

}  // namespace tumble::accuracy
