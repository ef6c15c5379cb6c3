#include "physics/bullet/step_world.h"

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionDispatch/btSimulationIslandManager.h>

#include <algorithm>

#include "physics/bullet/contacts.h"
#include "physics/bullet/joint_part.h"

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

StepWorld::StepWorld(PairDispatcher& dispatcher, btBroadphaseInterface& broadphase, btSequentialImpulseConstraintSolver& solver,
                     btCollisionConfiguration& configuration)
    : btDiscreteDynamicsWorld(&dispatcher, &broadphase, &solver, &configuration), pairs_(dispatcher) {
  // Bullet frees what is there with its own allocator.
  m_islandManager->~btSimulationIslandManager();
  btAlignedFree(m_islandManager);
  m_islandManager = new (btAlignedAlloc(sizeof(Islands), 16)) Islands(*this);
}

// ---- which pairs

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

// ---- a pair

namespace {

// Contacts are looked for this far ahead beside what the bodies' speeds ask for, m, but no farther than this part of the
// smaller body.
constexpr double kMargin = 0.01, kMarginPart = 0.2, kTriggerMargin = 1e-9;
constexpr int kMostLooks = 200;  // into a trigger, of a fast body

double reach_of(const BodyState& body) {
  return body.dynamic() ? body.extent : std::numeric_limits<double>::infinity();
}

// How fast a body's surface may come nearer, beside the motion of its centre.
double whirl(const BodyState& body) { return body.rigid->getAngularVelocity().length() * body.extent; }

double margin_of(const BodyState& a, const BodyState& b, const PairDispatcher& pairs) {
  const double speed = (a.rigid->getLinearVelocity() - b.rigid->getLinearVelocity()).length() + whirl(a) + whirl(b);
  const double smaller = std::min(reach_of(a), reach_of(b));
  double way = speed * pairs.seconds;
  // A body that is not to be looked after goes through what is thinner than its way.
  for (const BodyState* body : {&a, &b})
    if (body->dynamic() && !body->def.continuous.value_or(true)) way = std::min(way, inner_radius(body->def));
  return std::min(kMargin, kMarginPart * smaller) + way + pairs.fall;
}

struct Placed {
  btCollisionObject& object;
  btTransform at;
};

void process(btBroadphasePair& pair, PairDispatcher& pairs, const btDispatcherInfo& info, const Placed& a, const Placed& b) {
  const btCollisionObjectWrapper wrap_a(nullptr, a.object.getCollisionShape(), &a.object, a.at, -1, -1);
  const btCollisionObjectWrapper wrap_b(nullptr, b.object.getCollisionShape(), &b.object, b.at, -1, -1);
  if (!pair.m_algorithm) pair.m_algorithm = pairs.findAlgorithm(&wrap_a, &wrap_b, nullptr, BT_CONTACT_POINT_ALGORITHMS);
  if (!pair.m_algorithm) return;
  btManifoldResult result(&wrap_a, &wrap_b);
  result.m_closestPointDistanceThreshold = pairs.margin;
  pair.m_algorithm->processCollision(&wrap_a, &wrap_b, info, &result);
}

bool overlaps(btBroadphasePair& pair) {
  btManifoldArray manifolds;
  if (pair.m_algorithm) pair.m_algorithm->getAllContactManifolds(manifolds);
  for (int i = 0; i < manifolds.size(); ++i)
    for (int p = 0; p < manifolds[i]->getNumContacts(); ++p)
      if (manifolds[i]->getContactPoint(p).getDistance() <= 0) return true;
  return false;
}

// Where a body was at a part of the step that is over.
Placed at_part(btCollisionObject& object, double part) {
  const BodyState& body = *state_of(&object);
  btTransform at = object.getWorldTransform();
  if (body.dynamic()) at.setOrigin(body.last_good.getOrigin().lerp(at.getOrigin(), part));
  return {object, at};
}

// Is it in there at the end of the step, or, if it was not before, was it at any time of it? What is faster than it is
// thick is looked at on its way as well.
void look_into_trigger(btBroadphasePair& pair, PairDispatcher& pairs, const btDispatcherInfo& info, btCollisionObject& a, btCollisionObject& b) {
  const BodyState &body_a = *state_of(&a), &body_b = *state_of(&b);
  const btVector3 way_a = at_part(a, 0).at.getOrigin() - a.getWorldTransform().getOrigin();
  const btVector3 way_b = at_part(b, 0).at.getOrigin() - b.getWorldTransform().getOrigin();
  const double way = (way_a - way_b).length();
  const double thick = inner_radius(body_a.def) + inner_radius(body_b.def);
  const int looks = thick > 0 ? std::clamp(static_cast<int>(std::ceil(std::min(way / thick, 1e6))), 1, kMostLooks) : 1;
  process(pair, pairs, info, at_part(a, 1), at_part(b, 1));
  const bool was_in = std::any_of(body_a.pairs.begin(), body_a.pairs.end(), [&](const Pair* known) {
    return known->trigger && (known->a == &body_b || known->b == &body_b);
  });
  for (int i = looks - 1; i >= 1 && !was_in && !overlaps(pair); --i) {
    const double part = static_cast<double>(i) / looks;
    process(pair, pairs, info, at_part(a, part), at_part(b, part));
  }
}

void look_at(btBroadphasePair& pair, btCollisionDispatcher& dispatcher, const btDispatcherInfo& info) {
  auto& pairs = static_cast<PairDispatcher&>(dispatcher);
  auto *a = static_cast<btCollisionObject*>(pair.m_pProxy0->m_clientObject), *b = static_cast<btCollisionObject*>(pair.m_pProxy1->m_clientObject);
  if ((is_ghost(a) || is_ghost(b)) != pairs.triggers || !dispatcher.needsCollision(a, b)) return;
  // A threshold of 0 would be taken for none.
  if (pairs.triggers) {
    pairs.margin = kTriggerMargin;
    look_into_trigger(pair, pairs, info, *a, *b);
    return;
  }
  BodyState &body_a = *state_of(a), &body_b = *state_of(b);
  if (body_a.is_convex && body_b.is_convex) {
    if (!pair.m_algorithm) pair.m_algorithm = new (pairs.allocateCollisionAlgorithm(sizeof(BodyPair))) BodyPair(body_a, body_b, pairs.kept);
    static_cast<BodyPair*>(pair.m_algorithm)->look(pairs.fall, [&] { return margin_of(body_a, body_b, pairs); });
    return;
  }
  pairs.margin = margin_of(body_a, body_b, pairs);
  process(pair, pairs, info, {*a, a->getWorldTransform()}, {*b, b->getWorldTransform()});
}

}  // namespace

PairDispatcher::PairDispatcher(btCollisionConfiguration* configuration) : btCollisionDispatcher(configuration) {
  setNearCallback(look_at);
}

btPersistentManifold* PairDispatcher::getNewManifold(const btCollisionObject* a, const btCollisionObject* b) {
  btPersistentManifold* manifold = btCollisionDispatcher::getNewManifold(a, b);
  manifold->setContactBreakingThreshold(margin + kMargin);
  return manifold;
}

// ---- a pass

// A step ends with boxes for queries, and the next begins with the same ones unless somebody did something in between.
void StepWorld::enlarge(btCollisionObject& object) {
  BodyState& body = *state_of(&object);
  if (&object == body.rigid.get()) {
    const Boxed now{body.travel, body.placed, from_bullet(body.rigid->getLinearVelocity()), from_bullet(body.rigid->getAngularVelocity()),
                    pairs_.seconds, pairs_.fall};
    if (now == body.boxed) return;
    body.boxed = now;
  }
  btVector3 low, high;
  object.getCollisionShape()->getAabb(object.getWorldTransform(), low, high);
  const double spinning = whirl(body) * pairs_.seconds, around = std::min(kMargin, kMarginPart * body.extent) + pairs_.fall + spinning;
  const btVector3 way = body.rigid->getLinearVelocity() * pairs_.seconds, edge(around, around, around);
  body.ahead = way.length() + spinning;
  low.setMin(low + way);
  high.setMax(high + way);
  getBroadphase()->setAabb(object.getBroadphaseHandle(), low - edge, high + edge, getDispatcher());
}

void StepWorld::updateAabbs() {
  for (int i = 0; i < m_nonStaticRigidBodies.size(); ++i)
    if (m_nonStaticRigidBodies[i]->isActive()) enlarge(*m_nonStaticRigidBodies[i]);
  for (btCollisionObject* ghost : ghosts)
    if (ghost->isActive()) enlarge(*ghost);
}

void StepWorld::collide(double seconds, Vec3 gravity) {
  pairs_.seconds = seconds;
  pairs_.fall = length(gravity) * seconds * seconds;
  pairs_.triggers = false;
  performDiscreteCollisionDetection();
  wake_by_carriers();
  calculateSimulationIslands();
  m_islandManager->buildIslands(getDispatcher(), this);
}

// As Bullet's islands do it where there are manifolds.
void StepWorld::wake_by_carriers() {
  const auto wakes = [](const BodyState& mover, const BodyState& other) {
    return mover.def.type == BodyType::kinematic && mover.rigid->isActive() && other.dynamic();
  };
  for (const KeptContact* kept : pairs_.kept) {
    if (kept->contact.count == 0) continue;
    if (wakes(*kept->a, *kept->b)) kept->b->rigid->activate();
    if (wakes(*kept->b, *kept->a)) kept->a->rigid->activate();
  }
}

void StepWorld::collide_triggers() {
  if (ghosts.empty()) return;
  pairs_.triggers = true;
  const auto look = [this] {
    getDispatcher()->dispatchAllCollisionPairs(getBroadphase()->getOverlappingPairCache(), getDispatchInfo(), getDispatcher());
  };
  look();  // along the ways for which the boxes were made; those stay until what they found has been read
  bool strayed = false;
  const auto follow = [&](btCollisionObject& object) {
    btVector3 low, high;
    object.getCollisionShape()->getAabb(object.getWorldTransform(), low, high);
    const btBroadphaseProxy& box = *object.getBroadphaseHandle();
    if (!object.isActive() || TestAabbAgainstAabb2(low, high, box.m_aabbMin, box.m_aabbMax)) return;
    enlarge(object);
    strayed = true;
  };
  for (int i = 0; i < m_nonStaticRigidBodies.size(); ++i) follow(*m_nonStaticRigidBodies[i]);
  for (btCollisionObject* ghost : ghosts) follow(*ghost);
  if (!strayed) return;
  computeOverlappingPairs();
  look();
}

}  // namespace tumble
