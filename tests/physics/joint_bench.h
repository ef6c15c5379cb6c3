// Bodies on joints, for tests.
#pragma once

#include "physical.h"

namespace tumble {

inline BodyDef rod() {
  BodyDef def = body(box({1, 0.1, 0.1}));
  def.mass = 2;
  def.can_sleep = false;
  return def;
}
// Of the rod about an axis across it through one end.
constexpr double kRodInertia = 2.0 / 12 * (1 + 0.01) + 2 * 0.25;

inline JointDef hinge(BodyId a, Vec3 anchor, Vec3 axis, const TurnDef& angle = {}) {
  JointDef def;
  def.a = a;
  def.anchor = anchor;
  def.axis = axis;
  def.kind = HingeDef{angle};
  return def;
}

inline JointDef slider(BodyId a, Vec3 axis, const SlideDef& position = {}) {
  JointDef def;
  def.a = a;
  def.axis = axis;
  def.kind = SliderDef{position};
  return def;
}

// A rod hinged to the world at its left end, about z.
struct Door {
  explicit Door(const TurnDef& angle, const WorldSettings& settings = weightless()) : scene(settings) {
    door = scene.add(rod(), {0.5, 0, 0});
    joint = scene.world.add(hinge(door, {-0.5, 0, 0}, {0, 0, 1}, angle), 0);
  }
  JointState state() const { return scene.world.state(joint); }
  Scene scene;
  BodyId door;
  JointId joint;
};

}  // namespace tumble
