// The cases, by what they are about; each group's folder holds one file a case and the list of the group.
#pragma once

#include "accuracy/case.h"

namespace tumble::accuracy {

std::vector<Case> motion_cases();    // free flight, free rotation, mass properties
std::vector<Case> impact_cases();    // bounces, collisions, fast bodies, deep overlap
std::vector<Case> friction_cases();  // sliding, rolling, spinning, toppling
std::vector<Case> joint_cases();     // pendulums, springs, motors, limits, chains
std::vector<Case> stacking_cases();  // resting, towers, walls, piles, arches
std::vector<Case> life_cases();      // carriers, sleep, scaling, removal, bad input, determinism
std::vector<Case> query_cases();     // rays, casts, triggers, mesh edges

}  // namespace tumble::accuracy
