#include <algorithm>

#include "physics/dynamics/mechanism.h"

namespace tumble::dynamics {

namespace {

// What a pull may be, over inertia / h^2, before a part of it is taken implicitly.
constexpr double kOwnStiffness = 0.25;

}  // namespace

// A link that is pulled at both ends turns back as a stiff spring does, and no explicit step survives one that swings
// faster than 2 / h. What is above a quarter of that is taken implicitly: more inertia across the pull (geometric stiffness).
void Mechanism::note_stiffness(double h) {
  for (Mover* mover : bodies_) {
    mover->stiffness = 0;
    mover->stiff_axis = {};
  }
  const auto add = [h](Mover& mover, const Pose& local, Vec3 impulse) {
    if (!mover.pushable) return;
    const Vec3 arm = mover.rotation * local.position;
    mover.stiffness += h * dot(impulse, arm);
    if (dot(arm, arm) > dot(mover.stiff_axis, mover.stiff_axis)) mover.stiff_axis = arm;
  };
  for (std::size_t i = 0; i < rows_.size();) {
    const Link& link = *rows_[i].link;
    Vec3 on_a, on_b;
    for (; i < rows_.size() && rows_[i].link == &link; ++i) {
      on_a += rows_[i].row.linear_a * pull_[static_cast<Eigen::Index>(i)];
      on_b += rows_[i].row.linear_b * pull_[static_cast<Eigen::Index>(i)];
    }
    add(*link.a, link.local_a, on_a);
    add(*link.b, link.local_b, on_b);
  }
  for (Mover* mover : bodies_) {
    mover->stiff_axis = normalized(mover->stiff_axis);
    const double own = std::max({mover->inertia.x, mover->inertia.y, mover->inertia.z}) * kOwnStiffness;
    mover->stiffness = mover->stiff_axis == Vec3{} ? 0 : std::max(0.0, mover->stiffness - own);
  }
}

void Mechanism::stiffen(double h) {
  note_stiffness(h);
  bool any = false;
  for (Mover* mover : bodies_) {
    if (mover->stiffness <= 0) continue;
    mover->refresh();
    any = true;
  }
  if (any) gather();
  conserves_ &= !any;
  factor();
}

}  // namespace tumble::dynamics
