// Restitution, after the solver: bodies that hit leave with e times the speed at which they came.
//
// Bullet's own bounce takes the gap at the start of the substep off the speed and loses up to a third; here contacts
// are solved without restitution and the speed is given back once the bodies have met.
#pragma once

#include <vector>

#include "physics/bullet/convert.h"

namespace tumble {

class Bounce {
 public:
  // Between collision detection and the solver: notes what approaches.
  void prepare(btDispatcher& dispatcher, double h);
  // After positions moved: velocities of what hit. The impulses are added to the contact points'.
  void apply();
  // After the contacts were read: what bounced starts the next substep without an impulse.
  void forget();

 private:
  struct Hit {
    btPersistentManifold* manifold = nullptr;
    btManifoldPoint* point = nullptr;
    double leave = 0;      // m/s, along the normal
    double impulse = 0;    // given so far
  };
  void prepare(btPersistentManifold& manifold, double h);
  void give(Hit& hit);
  std::vector<Hit> hits_;
};

}  // namespace tumble
