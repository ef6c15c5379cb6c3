#include "physics/bullet/step_world.h"

#include "physics/bullet/joint_part.h"

namespace tumble {

namespace {

bool agree(const BodyState& a, const BodyState& b) { return (a.group & b.mask) && (b.group & a.mask); }

bool joined_apart(const BodyState& a, const BodyState& b) {
  for (const JointPart* joint : a.joints)
    if (joint->live && !joint->def.collide_connected && (joint->a == &b || joint->b == &b)) return true;
  return false;
}

}  // namespace

bool PairFilter::needBroadphaseCollision(btBroadphaseProxy* proxy_a, btBroadphaseProxy* proxy_b) const {
  const auto *object_a = static_cast<const btCollisionObject*>(proxy_a->m_clientObject);
  const auto *object_b = static_cast<const btCollisionObject*>(proxy_b->m_clientObject);
  const BodyState &a = *state_of(object_a), &b = *state_of(object_b);
  if (&a == &b || !agree(a, b)) return false;
  const bool ghost_a = is_ghost(object_a), ghost_b = is_ghost(object_b);
  if (ghost_a && ghost_b) return false;
  if (ghost_a) return b.def.type != BodyType::fixed && !b.solids->empty();
  if (ghost_b) return a.def.type != BodyType::fixed && !a.solids->empty();
  if (a.solids->empty() || b.solids->empty()) return false;
  return (a.dynamic() || b.dynamic()) && !joined_apart(a, b);
}

void StepWorld::substep(double h) {
  predictUnconstraintMotion(h);
  getDispatchInfo().m_timeStep = h;
  getDispatchInfo().m_stepCount = 0;
  createPredictiveContacts(h);
  performDiscreteCollisionDetection();
  calculateSimulationIslands();
  getSolverInfo().m_timeStep = h;
  bounce_.prepare(*getDispatcher(), h);
  solveConstraints(getSolverInfo());
  integrateTransforms(h);
  bounce_.apply();
}

}  // namespace tumble
