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
Case b08_bridges_nets();
Case b14_motor_into_limit();
Case b31_redundant_joints();
Case b34_mixed_chain();
Case b35_dragged();
Case s05_ten_links();

std::vector<Case> joint_cases() {
  return {a12_pendulum(), a13_double_pendulum(), a14_spring(), a15_motor(), a16_limit(),
          a17_neutrality(), a18_chain(), a27_catenary(), a32_jointed_contact(), b08_bridges_nets(),
          b14_motor_into_limit(), b31_redundant_joints(), b34_mixed_chain(), b35_dragged(), s05_ten_links()};
}

}  // namespace tumble::accuracy
