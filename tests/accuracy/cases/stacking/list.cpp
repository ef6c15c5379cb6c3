#include "accuracy/cases/cases.h"

namespace tumble::accuracy {

Case a23_resting_forces();
Case a31_predictability();
Case b01_towers();
Case b02_pyramids();
Case b03_heavy_on_light();
Case b04_bridge();
Case b05_card_house();
Case b06_arches();
Case b07_planks();
Case b11_sizes();
Case b12_far_away();
Case b15_locked_axes();
Case s01_pile_of_500();
Case s02_pile_of_2000();
Case s03_pile_of_8000();
Case s04_wall();

std::vector<Case> stacking_cases() {
  return {a23_resting_forces(), a31_predictability(), b01_towers(), b02_pyramids(), b03_heavy_on_light(), b04_bridge(), b05_card_house(), b06_arches(),
          b07_planks(), b11_sizes(), b12_far_away(), b15_locked_axes(), s01_pile_of_500(), s02_pile_of_2000(), s03_pile_of_8000(), s04_wall()};
}

}  // namespace tumble::accuracy
