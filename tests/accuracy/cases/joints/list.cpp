#include "accuracy/cases/cases.h"

namespace tumble::accuracy {

Case a12_pendulum();
Case a13_double_pendulum();
Case a14_spring();
Case a15_motor();
Case a16_limit();
Case a17_neutrality();
Case a18_chain();
Case s05_ten_links();

std::vector<Case> joint_cases() {
  return {a12_pendulum(), a13_double_pendulum(), a14_spring(), a15_motor(), a16_limit(), a17_neutrality(), a18_chain(), s05_ten_links()};
}

}  // namespace tumble::accuracy
