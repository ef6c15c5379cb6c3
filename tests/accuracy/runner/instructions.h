// Instructions of a simulated second, counted by valgrind's callgrind: the same whatever else the machine does.
#pragma once

#include "accuracy/runner/sweep.h"

namespace tumble::accuracy {

// Runs this program again under valgrind for one part at one setting; nothing where valgrind is missing or the part
// cannot be counted. `id` and `part` name what sweep.h's plan holds.
std::optional<double> count_instructions(const std::string& engine, const std::string& id, int part, const Knobs& knobs);

// What that second process does: plays the part until a second of its first scene is over, collecting within steps.
// Prints the simulated seconds. The exit status of the process.
int play_for_count(const std::string& engine, const std::string& id, int part, const Knobs& knobs);

}  // namespace tumble::accuracy
