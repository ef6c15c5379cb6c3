#include "physics/bullet/step_world.h"

#include "physics/bullet/joint_part.h"

#include <BulletCollision/CollisionDispatch/btSimulationIslandManager.h>

namespace tumble {

namespace {

bool agree(const BodyState& a, const BodyState& b) { return (a.group & b.mask) && (b.group & a.mask); }

bool joined_apart(const BodyState& a, const BodyState& b) {
  for (const JointPart* joint : a.joints)
    if (joint->live && !joint->def.collide_connected && (joint->a == &b || joint->b == &b)) return true;
  return false;
}

// Bullet's islands, without a look at what is static: thousands of static bodies cost nothing.
class Islands final : public btSimulationIslandManager {
 public:
  explicit Islands(const StepWorld& world) : world_(world) {}

  void updateActivationState(btCollisionWorld* world, btDispatcher* dispatcher) override {
    int index = 0;
    for (int i = 0; i < world_.movable().size(); ++i) {
      btRigidBody* body = world_.movable()[i];
      if (!body->isStaticOrKinematicObject()) body->setIslandTag(index++);
      body->setCompanionId(-1);
    }
    initUnionFind(index);
    findUnions(dispatcher, world);
  }

  void storeIslandActivationState(btCollisionWorld*) override {
    int index = 0;
    for (int i = 0; i < world_.movable().size(); ++i) {
      btRigidBody* body = world_.movable()[i];
      if (body->isStaticOrKinematicObject()) continue;
      body->setIslandTag(getUnionFind().find(index));
      getUnionFind().getElement(index).m_sz = body->getWorldArrayIndex();
      ++index;
    }
  }

 private:
  const StepWorld& world_;
};

}  // namespace

StepWorld::StepWorld(btDispatcher& dispatcher, btBroadphaseInterface& broadphase, btSequentialImpulseConstraintSolver& solver,
                     btCollisionConfiguration& configuration)
    : btDiscreteDynamicsWorld(&dispatcher, &broadphase, &solver, &configuration) {
  solver.setRandSeed(0);  // a world does not depend on those before it
  // Bullet frees what is there with its own allocator.
  m_islandManager->~btSimulationIslandManager();
  btAlignedFree(m_islandManager);
  m_islandManager = new (btAlignedAlloc(sizeof(Islands), 16)) Islands(*this);
}

void StepWorld::updateAabbs() {
  for (int i = 0; i < m_nonStaticRigidBodies.size(); ++i)
    if (m_nonStaticRigidBodies[i]->isActive()) updateSingleAabb(m_nonStaticRigidBodies[i]);
  for (btCollisionObject* ghost : ghosts)
    if (ghost->isActive()) updateSingleAabb(ghost);
}

bool PairFilter::needBroadphaseCollision(btBroadphaseProxy* proxy_a, btBroadphaseProxy* proxy_b) const {
  if (pairs->getNumOverlappingPairs() >= kMostPairs) return false;
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
  for (int i = 0; i < m_nonStaticRigidBodies.size(); ++i) {
    btRigidBody& body = *m_nonStaticRigidBodies[i];
    if (body.isActive() && !body.isKinematicObject()) body.predictIntegratedTransform(h, body.getInterpolationWorldTransform());
  }
  getDispatchInfo().m_timeStep = h;
  getDispatchInfo().m_stepCount = 0;
  createPredictiveContacts(h);
  performDiscreteCollisionDetection();
  calculateSimulationIslands();
  getSolverInfo().m_timeStep = h;
  bounce_.prepare(*getDispatcher(), h);
  solveConstraints(getSolverInfo());
  // The solver has pushed overlaps apart by moving and turning bodies; from there on they turn our way.
  for (int i = 0; i < m_nonStaticRigidBodies.size(); ++i)
    state_of(m_nonStaticRigidBodies[i])->rotation_before = from_bullet(m_nonStaticRigidBodies[i]->getWorldTransform().getRotation());
  integrateTransforms(h);
  bounce_.apply();
}

}  // namespace tumble
