#include "physics/dynamics/link.h"

namespace tumble::dynamics {

JointFrame frame(const Link& link) {
  const auto carried = [](const Mover& mover, const Pose& local) { return Pose{mover.position, mover.rotation} * local; };
  return {carried(*link.a, link.local_a), carried(*link.b, link.local_b), link.a->position, link.b->position};
}

void refresh(Link& link) {
  link.rows.clear();
  const JointFrame now = frame(link);
  std::visit([&](const auto& kind) { rows(kind, now, link.rows); }, *link.kind);
  link.positions.resize(link.rows.free.size(), 0);
  for (std::size_t i = 0; i < link.positions.size(); ++i) {
    const FreeRow& free = link.rows.free[i];
    double& known = link.positions[i];
    known = free.turn ? known + std::remainder(free.position - known, 2 * kPi) : free.position;
  }
}

double speed(const Link& link, const JointRow& row) {
  return dot(row.linear_a, link.a->velocity) + dot(row.angular_a, link.a->spin) + dot(row.linear_b, link.b->velocity) +
         dot(row.angular_b, link.b->spin);
}

}  // namespace tumble::dynamics
