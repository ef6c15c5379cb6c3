#include "accuracy/cases/cases.h"

namespace tumble::accuracy {

Case a03_bounce();
Case a19_gas();
Case a20_cradle();
Case a21_oblique_impact();
Case a22_eccentric_impact();
Case a30_overlap();

std::vector<Case> impact_cases() { return {a03_bounce(), a19_gas(), a20_cradle(), a21_oblique_impact(), a22_eccentric_impact(), a30_overlap()}; }

}  // namespace tumble::accuracy
