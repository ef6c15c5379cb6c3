// The convex shapes that a piece of a body is made of.
#pragma once

#include <BulletCollision/CollisionShapes/btTriangleShape.h>

#include "physics/bullet/shapes.h"

namespace tumble {

namespace detail {

template <class F>
struct EachTriangle final : btTriangleCallback {
  EachTriangle(const btTransform& given, F& function) : at(given), f(function) {}
  void processTriangle(btVector3* t, int, int) override {
    btTriangleShape triangle(t[0], t[1], t[2]);
    triangle.setMargin(0);
    f(static_cast<const btConvexShape&>(triangle), at);
  }
  const btTransform& at;
  F& f;
};

}  // namespace detail

// Calls f(convex shape, its pose) for a piece: once, or for each triangle of a mesh in the box (world).
template <class F>
void each_convex(const Piece& piece, const btTransform& at, const btVector3& low, const btVector3& high, F f) {
  if (piece.shape->isConvex()) {
    f(static_cast<const btConvexShape&>(*piece.shape), at);
    return;
  }
  detail::EachTriangle<F> callback(at, f);
  const btTransform back = at.inverse();
  btVector3 local_low, local_high;
  btTransformAabb(low, high, 0, back, local_low, local_high);
  static_cast<const btConcaveShape*>(piece.shape)->processAllTriangles(&callback, local_low, local_high);
}

}  // namespace tumble
