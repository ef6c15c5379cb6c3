// Finds what may touch during a whole step: boxes, then pairs, of what is awake. Motion is ours (solver.h).
#pragma once

#include <vector>

#include "base/team.h"
#include "physics/bullet/awake.h"

namespace tumble {

// Bullet's algorithms for compounds and meshes make their manifolds here. Those keep points up to the distance that the
// pair that is looked at may close in a step.
class PairDispatcher final : public btCollisionDispatcher {
 public:
  using btCollisionDispatcher::btCollisionDispatcher;
  btPersistentManifold* getNewManifold(const btCollisionObject* a, const btCollisionObject* b) override;
  double margin = 0;        // of the pair that is looked at, m
};

class Collision {
 public:
  Collision(PairDispatcher& dispatcher, Overlaps& overlaps, Awake& awake) : dispatcher_(dispatcher), overlaps_(overlaps), awake_(awake) {}

  // What may touch within the next `seconds`, of what is awake or was moved; wakes what that meets.
  void look(double seconds, Vec3 gravity, const std::vector<BodyState*>& carriers, Team& team);
  // What is in triggers where everything is now, after a step of so many seconds; and what went through them in it.
  void look_into_triggers(double seconds, const std::vector<BodyState*>& carriers);
  // Who was in a trigger on its way only: it had not been there before, and is not any more.
  struct Passage {
    BodyState *a, *b;
    double part;  // of the step, 0 to 1, at which it was in there
  };
  const std::vector<Passage>& passages() const { return passages_; }
  // Boxes as far as bodies go in a step like the last one, so that queries find everything where it is now.
  void fit_boxes(const std::vector<BodyState*>& carriers);
  // The same of one body that was put somewhere.
  void fit(BodyState& body);
  // The contacts of pairs of bodies of one convex part that have points.
  const std::vector<KeptContact*>& found() const { return overlaps_.found; }
  // f(btPersistentManifold&) for those with points; of solids or of triggers.
  template <class F>
  void each_manifold(Overlap::Kind kind, const F& f) {
    for (Overlap* overlap : overlaps_.active(kind)) {
      if (!overlap->algorithm) continue;
      manifolds_.resizeNoInitialize(0);
      overlap->algorithm->getAllContactManifolds(manifolds_);
      for (int i = 0; i < manifolds_.size(); ++i)
        if (manifolds_[i]->getNumContacts() > 0) f(*manifolds_[i]);
    }
  }

 private:
  void fit(Occupant& occupant, const btVector3& way, double around);
  double pull_on(const BodyState& body) const;
  double margin_of(const BodyState& a, const BodyState& b) const;
  void look_at(Overlap& overlap);
  void look_at_bodies(Overlap& overlap) const;
  bool comes_to(const BodyState& a, const BodyState& b, Vec3 normal, double separation) const;
  void wake_by(Overlap& overlap);
  void look_into(Overlap& overlap, double seconds);
  bool any_near(Overlap& overlap);
  bool any_inside(Overlap& overlap);

  PairDispatcher& dispatcher_;
  Overlaps& overlaps_;
  Awake& awake_;
  btDispatcherInfo info_;
  btManifoldArray manifolds_;
  std::vector<Passage> passages_;
  double seconds_ = 0;      // of the step that is to come
  Vec3 gravity_;            // in it
};

}  // namespace tumble
