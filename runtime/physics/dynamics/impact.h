// What bounces: hits within a substep, one after the other in the order of their times.
//
// Each gives its impulse at once, between the kick and the drift, and moves the bodies back by what the new velocity did
// too early: after the drift they are where they would be had they met when they met. So a row of balls hands a blow on
// from each to the next, and a ball bounces as high as its restitution says at any step (the model is Newton's; sequential
// rather than simultaneous impacts: W. J. Stronge, Impact Mechanics).
#pragma once

#include <vector>

#include "physics/dynamics/contact.h"
#include "physics/dynamics/mechanism.h"

namespace tumble::dynamics {

// Contacts and joints of one island; after the first kick, before anything is solved.
void bounce(const std::vector<Contact*>& contacts, const std::vector<Mechanism*>& mechanisms, double h);

}  // namespace tumble::dynamics
