// All contacts of a step as the solver wants them: those that pairs of bodies keep, and those of compounds and meshes, which
// are made from Bullet's manifolds and written back there.
#pragma once

#include <deque>
#include <vector>

#include "physics/bullet/chase.h"
#include "physics/bullet/collision.h"
#include "physics/dynamics/mover.h"

namespace tumble {

class StepContacts {
 public:
  // Of all that can move now. Bodies without a mover of their own share the first.
  void gather(Collision& collision, std::deque<dynamics::Mover>& movers, double seconds);
  std::vector<dynamics::Contact*>& list() { return list_; }
  template <class F>
  void each_chase(const F& each) {
    for (Chased& chased : chases_) each(*chased.contact, chased.chase);
  }
  void write_back(const std::deque<dynamics::Mover>& movers);

 private:
  struct Made {  // from a manifold: where its points are kept between steps
    dynamics::Contact contact;
    btManifoldPoint* points[dynamics::Contact::kMostPoints] = {};
  };
  struct Chased {
    dynamics::Contact* contact;
    Chase chase;
  };

  void take(KeptContact& kept, std::deque<dynamics::Mover>& movers, double seconds);
  void make(btPersistentManifold& manifold, std::deque<dynamics::Mover>& movers, double seconds);
  void add_point(Made& made, btPersistentManifold& manifold, btManifoldPoint& point);
  void drop_seams();

  std::vector<dynamics::Contact*> list_;
  std::vector<KeptContact*> kept_;   // of each of the list; nullptr of one that was made
  std::vector<KeptContact*> taken_;  // those of the list, and those that were dropped from it
  std::deque<Made> made_;
  std::deque<Chased> chases_;
};

}  // namespace tumble
