#include "scene/node.h"

namespace tumble {

namespace {

// How much a parent's scale stretches each axis of a child turned by `rotation`.
Vec3 stretch(Vec3 scale, Quat rotation) {
  if (scale.x == scale.y && scale.y == scale.z) return scale;
  if (rotation == Quat{}) return scale;  // not by the lengths below, which would round
  return {length(scaled(scale, rotation * Vec3{1, 0, 0})), length(scaled(scale, rotation * Vec3{0, 1, 0})),
          length(scaled(scale, rotation * Vec3{0, 0, 1}))};
}

}  // namespace

Transform operator*(const Transform& parent, const Transform& child) {
  return {to_parent(parent, child.position), parent.rotation * child.rotation,
          scaled(stretch(parent.scale, child.rotation), child.scale)};
}

Transform relative(const Transform& parent, const Transform& world) {
  const Quat rotation = normalized(conjugate(parent.rotation) * world.rotation);
  return {from_parent(parent, world.position), rotation, unscaled(world.scale, stretch(parent.scale, rotation))};
}

Transform between(const Transform& a, const Transform& b, double t) {
  return {lerp(a.position, b.position, t), slerp(a.rotation, b.rotation, t), lerp(a.scale, b.scale, t)};
}

}  // namespace tumble
