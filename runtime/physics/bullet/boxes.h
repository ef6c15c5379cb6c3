// Where everything is: trees of boxes, each a little larger than what is in it, so that what hardly moves leaves them alone.
#pragma once

#include <BulletCollision/BroadphaseCollision/btDbvt.h>

#include <vector>

#include "physics/bullet/convert.h"

namespace tumble {

struct BodyState;
struct Overlap;

// What has a box: a body's solids, or its triggers.
struct Occupant {
  BodyState* body = nullptr;
  btCollisionObject* object = nullptr;
  bool triggers = false;
  bool fixed = false;                // never moves: its leaf is in a tree of its own
  btDbvtNode* leaf = nullptr;        // of a tree; nullptr while it is not in the world
  std::vector<Overlap*> overlaps;    // see overlaps.h
  const btDbvtVolume& box() const { return leaf->volume; }
};

class Boxes {
 public:
  void add(Occupant& occupant, const btDbvtVolume& box);
  void move(Occupant& occupant, const btDbvtVolume& box);
  void remove(Occupant& occupant);
  // Keeps the tree shallow: a bit with each call.
  void tidy() { moving_.optimizeIncremental(1); }

  // f(Occupant&) for all whose boxes meet this one.
  template <class F>
  void each_in(const btDbvtVolume& box, bool fixed_too, const F& f) const {
    Visit<F> visit(f);
    moving_.collideTV(moving_.m_root, box, visit);
    if (fixed_too) fixed_.collideTV(fixed_.m_root, box, visit);
  }
  // The same of the box `low` to `high` about a point that goes along a direction of length 1.
  template <class F>
  void each_along(Vec3 origin, Vec3 direction, double length, Vec3 low, Vec3 high, const F& f) const {
    Visit<F> visit(f);
    btVector3 inverse;
    unsigned signs[3];
    for (int i = 0; i < 3; ++i) {
      const double d = to_bullet(direction)[i];
      inverse[i] = d == 0 ? BT_LARGE_FLOAT : 1 / d;
      signs[i] = inverse[i] < 0;
    }
    btAlignedObjectArray<const btDbvtNode*> stack;
    for (const btDbvt* tree : {&moving_, &fixed_})
      tree->rayTestInternal(tree->m_root, to_bullet(origin), to_bullet(origin + direction * length), inverse, signs, length,
                            to_bullet(low), to_bullet(high), stack, visit);
  }
  // No point of any box is farther from the origin than this, m.
  double reach() const;

 private:
  template <class F>
  struct Visit final : btDbvt::ICollide {
    explicit Visit(const F& given) : f(given) {}
    void Process(const btDbvtNode* node) override { f(*static_cast<Occupant*>(node->data)); }
    const F& f;
  };
  btDbvt& tree_of(const Occupant& occupant) { return occupant.fixed ? fixed_ : moving_; }
  btDbvt moving_, fixed_;
};

}  // namespace tumble
