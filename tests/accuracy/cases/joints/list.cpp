#include "accuracy/cases/cases.h"

namespace tumble::accuracy {

Case a12_pendulum();
Case a13_double_pendulum();
Case a14_spring();
Case a15_motor();
Case a16_limit();
Case a17_neutrality();
Case a18_chain();
Case a27_catenary();
Case a32_jointed_contact();
Case s05_ten_links();

std::vector<Case> joint_cases() {
  return {a12_pendulum(), a13_double_pendulum(), a14_spring(), a15_motor(), a16_limit(), a17_neutrality(), a18_chain(), a27_catenary(), a32_jointed_contact(), s05_ten_links()};
}

}  // namespace tumble::accuracy
