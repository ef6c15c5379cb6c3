#include "physics/bullet/compound_pair.h"

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <LinearMath/btAabbUtil2.h>

#include <algorithm>

namespace tumble {

namespace {

const btCompoundShape& compound_of(const btCollisionObjectWrapper& wrap) {
  return static_cast<const btCompoundShape&>(*wrap.getCollisionShape());
}

struct Box {
  btVector3 low, high;
  Box(const btCollisionShape& shape, const btTransform& at) { shape.getAabb(at, low, high); }
  bool meets(const Box& other, double margin) const {
    const btVector3 grow(margin, margin, margin);
    return TestAabbAgainstAabb2(low - grow, high + grow, other.low, other.high);
  }
};

}  // namespace

CompoundPair::CompoundPair(const btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper* a,
                           const btCollisionObjectWrapper* b, bool second)
    : btActivatingCollisionAlgorithm(info, a, b), second_(second) {}

CompoundPair::~CompoundPair() { drop_all(); }

void CompoundPair::drop(int index) {
  btCollisionAlgorithm*& child = children_[index];
  if (!child) return;
  child->~btCollisionAlgorithm();
  m_dispatcher->freeCollisionAlgorithm(child);
  child = nullptr;
}

void CompoundPair::drop_all() {
  for (int i = 0; i < children_.size(); ++i) drop(i);
}

void CompoundPair::getAllContactManifolds(btManifoldArray& manifolds) {
  for (int i = 0; i < children_.size(); ++i)
    if (children_[i]) children_[i]->getAllContactManifolds(manifolds);
}

void CompoundPair::process_child(int index, const btCollisionObjectWrapper& child, const btCollisionObjectWrapper& other,
                                 const btDispatcherInfo& info, btManifoldResult& result) {
  const btCollisionObjectWrapper &a = second_ ? other : child, &b = second_ ? child : other;
  if (!children_[index]) children_[index] = m_dispatcher->findAlgorithm(&a, &b, nullptr, BT_CONTACT_POINT_ALGORITHMS);
  if (!children_[index]) return;

  // The result's own order of the two may be the other one.
  const bool is_first = result.getBody0Internal() == child.getCollisionObject();
  const btCollisionObjectWrapper* const before = is_first ? result.getBody0Wrap() : result.getBody1Wrap();
  if (is_first) result.setBody0Wrap(&child), result.setShapeIdentifiersA(-1, index);
  else result.setBody1Wrap(&child), result.setShapeIdentifiersB(-1, index);
  children_[index]->processCollision(&a, &b, info, &result);
  if (is_first) result.setBody0Wrap(before);
  else result.setBody1Wrap(before);
}

void CompoundPair::processCollision(const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b, const btDispatcherInfo& info,
                                    btManifoldResult* result) {
  const btCollisionObjectWrapper &whole = second_ ? *b : *a, &other = second_ ? *a : *b;
  const btCompoundShape& compound = compound_of(whole);
  if (children_.size() != compound.getNumChildShapes()) {
    drop_all();
    children_.resize(compound.getNumChildShapes(), nullptr);
  }
  const double margin = std::max(result->m_closestPointDistanceThreshold, gContactBreakingThreshold);
  const Box reach(*other.getCollisionShape(), other.getWorldTransform());
  for (int i = 0; i < children_.size(); ++i) {
    const btCollisionShape* const shape = compound.getChildShape(i);
    const btTransform at = whole.getWorldTransform() * compound.getChildTransform(i);
    if (!Box(*shape, at).meets(reach, margin)) {
      drop(i);
      continue;
    }
    process_child(i, btCollisionObjectWrapper(&whole, shape, whole.getCollisionObject(), at, -1, i), other, info, *result);
  }
}

btCollisionAlgorithm* CompoundPair::CreateFunc::CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                                         const btCollisionObjectWrapper* a,
                                                                         const btCollisionObjectWrapper* b) {
  return new (info.m_dispatcher1->allocateCollisionAlgorithm(sizeof(CompoundPair))) CompoundPair(info, a, b, second);
}

}  // namespace tumble
