#include "accuracy/cases/cases.h"

namespace tumble::accuracy {

Case a03_bounce();
Case a19_gas();
Case a20_cradle();
Case a21_oblique_impact();
Case a22_eccentric_impact();
Case a30_overlap();
Case b09_deep_overlap();
Case b10_fast_bodies();
Case b23_one_point();
Case b24_bad_values();
Case s07_tunnelling();
Case s08_jitter();
Case s09_twenty_overlapping();

std::vector<Case> impact_cases() {
  return {a03_bounce(), a19_gas(), a20_cradle(), a21_oblique_impact(), a22_eccentric_impact(), a30_overlap(),
          b09_deep_overlap(), b10_fast_bodies(), b23_one_point(), b24_bad_values(),
          s07_tunnelling(), s08_jitter(), s09_twenty_overlapping()};
}

}  // namespace tumble::accuracy
