#include "accuracy/cases/cases.h"

namespace tumble::accuracy {

Case b01_towers();
Case b02_pyramids();
Case b03_heavy_on_light();
Case b04_bridge();
Case b05_card_house();
Case b06_arches();
Case b07_planks();

std::vector<Case> stacking_cases() {
  return {b01_towers(), b02_pyramids(), b03_heavy_on_light(), b04_bridge(), b05_card_house(), b06_arches(), b07_planks()};
}

}  // namespace tumble::accuracy
