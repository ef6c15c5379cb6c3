// What a mechanism from which nothing takes energy has lost to the length of its substeps, and how it gets it back.
//
// A step that is symplectic keeps an energy of its own, which differs from the true one by h^2 times something that
// depends on the state (Hairer, Lubich, Wanner, Geometric Numerical Integration, IX): the true one swings by that and
// comes back. When h changes in mid-swing, so does what is kept. Substeps get shorter where the difference is large and
// longer where it is small, so that each whip would take a little. So it is kept in a book: where h gets shorter the
// difference goes down with h^2, and where it gets longer, which is where all is quiet, to 0.
#pragma once

#include <vector>

#include "physics/dynamics/link.h"

namespace tumble::dynamics {

double kinetic_energy(const Mover& mover);
// What its forces give it in so many seconds from rest.
double energy_of_fall(const Mover& mover, double seconds);

// Do constant forces alone act on all bodies, and does what holds them keep still?
bool without_loss(const std::vector<Mover*>& bodies, const std::vector<Link*>& links);

class EnergyBook {
 public:
  // At the start of a step, rows as the bodies are. Where the substeps are others than in the last one, velocities change.
  void begin(const std::vector<Mover*>& bodies, const std::vector<Link*>& links, double h);
  // At its end. `conserved`: nothing but constant forces did work.
  void end(const std::vector<Mover*>& bodies, bool conserved);

 private:
  double h_ = 0;
  double gained_ = 0;         // J, since what does work last acted
  double kinetic_ = 0;        // when the step began
  std::vector<Vec3> places_;  // of the bodies then
};

// Scales how bodies move against each other, so that their energy changes by so much; their motion as one rigid body
// stays, where the links to what cannot be pushed allow one, and with it momentum and angular momentum. False where that
// would be more than a small part of the energy, and nothing changed.
bool add_energy(const std::vector<Mover*>& bodies, const std::vector<Link*>& links, double energy);

}  // namespace tumble::dynamics
