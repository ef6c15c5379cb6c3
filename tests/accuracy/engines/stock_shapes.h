// Bullet's own shapes as somebody who follows its manual would make them.
#pragma once

#include <btBulletDynamicsCommon.h>

#include <memory>
#include <vector>

#include "accuracy/simulation.h"
#include "base/math.h"

namespace tumble::accuracy {

inline btVector3 to_stock(Vec3 v) { return {static_cast<btScalar>(v.x), static_cast<btScalar>(v.y), static_cast<btScalar>(v.z)}; }
inline btQuaternion to_stock(Quat q) {
  return {static_cast<btScalar>(q.x), static_cast<btScalar>(q.y), static_cast<btScalar>(q.z), static_cast<btScalar>(q.w)};
}
inline btTransform to_stock(const Pose& p) { return btTransform(to_stock(p.rotation), to_stock(p.position)); }
inline Vec3 from_stock(const btVector3& v) { return {v.x(), v.y(), v.z()}; }
inline Quat from_stock(const btQuaternion& q) { return {q.x(), q.y(), q.z(), q.w()}; }
inline Pose from_stock(const btTransform& t) { return {from_stock(t.getOrigin()), normalized(from_stock(t.getRotation()))}; }

// Makes shapes and owns them.
class StockShapes {
 public:
  btCollisionShape* shape(const Shape& shape);
  btCollisionShape* convex(const Shape& shape);  // null: it is not convex
  // About the centre of mass, which is told in the body's frame.
  btCollisionShape* of_body(const BodyDef& body, Vec3& center);
  static double inner_radius(const BodyDef& body);

 private:
  template <class S>
  S* keep(S* shape) {
    shapes_.emplace_back(shape);
    return shape;
  }
  std::vector<std::unique_ptr<btTriangleMesh>> meshes_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
};

}  // namespace tumble::accuracy
