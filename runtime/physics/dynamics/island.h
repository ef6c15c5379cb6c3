// What is joined and what touches, apart from all else: it moves by itself, in as many substeps as it needs.
#pragma once

#include <deque>
#include <functional>
#include <vector>

#include "physics/dynamics/contact.h"
#include "physics/dynamics/mechanism.h"

namespace tumble::dynamics {

struct Island {
  std::vector<Mover*> movers;       // what can be pushed, and its own copies of what moves as it is told
  std::vector<Contact*> contacts;
  std::vector<Mechanism*> mechanisms;
  std::vector<std::function<void(double h)>> looks;  // at contacts, at the start of each substep
  bool bouncy = false;
};

// In the order of their first movers. May add movers: what moves and cannot be pushed goes its way in each island anew, and
// contacts and links then know the island's own. Sets Mover::island.
std::vector<Island> find_islands(std::deque<Mover>& movers, const std::vector<Contact*>& contacts, const std::vector<Mechanism*>& mechanisms);

// How many substeps a step of so many seconds takes, at least `least`; contacts' impulses are forces yet.
int substeps_of(const Island& island, double seconds, int least);

// Takes it through the step, with at least so many rounds over the contacts in each half of a substep. Tells how many
// substeps it took.
int run(Island& island, double seconds, int least, int rounds);

}  // namespace tumble::dynamics
