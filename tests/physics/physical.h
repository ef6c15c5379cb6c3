// A world with verbs, for tests.
#pragma once

#include <catch2/catch.hpp>

#include "physics/world.h"

namespace tumble {

constexpr double kTick = 1.0 / 60;

inline Shape box(Vec3 size) {
  Shape shape;
  shape.size = size;
  return shape;
}
inline Shape ball(double radius) {
  Shape shape;
  shape.shape = ShapeKind::sphere;
  shape.radius = radius;
  return shape;
}
inline Shape upright(ShapeKind kind, double radius, double height) {
  Shape shape;
  shape.shape = kind;
  shape.radius = radius;
  shape.height = height;
  return shape;
}
inline Shape ring(double radius, double thickness) {
  Shape shape;
  shape.shape = ShapeKind::torus;
  shape.radius = radius;
  shape.thickness = thickness;
  return shape;
}
inline ColliderDef collider(const Shape& shape, Vec3 offset = {}, Quat rotation = {}) {
  ColliderDef def;
  def.shape = shape;
  def.offset = offset;
  def.rotation = rotation;
  return def;
}
inline BodyDef body(const Shape& shape, BodyType type = BodyType::dynamic) {
  BodyDef def;
  def.type = type;
  def.colliders = {collider(shape)};
  return def;
}
inline WorldSettings weightless() {
  WorldSettings settings;
  settings.gravity = {};
  return settings;
}

struct Scene {
  explicit Scene(const WorldSettings& settings = {}) : world(settings) {}

  BodyId add(const BodyDef& def, Vec3 position, Quat rotation = {}) { return world.add(def, {position, rotation}, 0); }
  // A static slab of 40 m with its top at y = 0.
  BodyId floor() { return add(body(box({40, 1, 40}), BodyType::fixed), {0, -0.5, 0}); }
  void run(double seconds, double tick = kTick) {
    const int count = static_cast<int>(std::lround(seconds / tick));
    for (int i = 0; i < count; ++i) world.step(tick);
  }
  Vec3 at(BodyId id) const { return world.pose(id).position; }

  World world;
};

inline int count(const std::vector<ContactEvent>& events, EventKind kind, bool trigger) {
  int result = 0;
  for (const ContactEvent& event : events) result += event.kind == kind && event.trigger == trigger;
  return result;
}

}  // namespace tumble
