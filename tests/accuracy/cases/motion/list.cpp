#include "accuracy/cases/cases.h"

namespace tumble::accuracy {

Case a01_free_fall();
Case a02_projectile();
Case a09_tennis_racket();
Case a10_symmetric_top();
Case a11_heavy_top();
Case a28_mass_properties();
Case b13_fast_spin();
Case b17_extreme_inertia();

std::vector<Case> motion_cases() {
  return {a01_free_fall(),  a02_projectile(),      a09_tennis_racket(), a10_symmetric_top(),
          a11_heavy_top(),  a28_mass_properties(), b13_fast_spin(),     b17_extreme_inertia()};
}

}  // namespace tumble::accuracy
