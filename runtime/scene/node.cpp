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

void describe(Material& material, Schema& s) {
  s.name("material", "How a mesh looks.");
  s.main("color");
  s.add("color", material.color, "A CSS name, \"#rrggbb\" or a color.");
  s.add("texture", material.texture, "A PNG or JPEG file; the color tints it.");
  s.add("roughness", material.roughness, "0 is a mirror, 1 is chalk.").between(0, 1);
  s.add("metalness", material.metalness, "1 is metal: reflections take its color.").between(0, 1);
  s.add("glow", material.glow, "Light of its own; 1 shows the color at full brightness in the dark.").at_least(0);
  s.add("opacity", material.opacity, "0 is invisible.").between(0, 1);
}

const EnumNames& enum_names(LightType) {
  static const EnumNames names = {"sun", "point", "spot"};
  return names;
}

void describe(Light& light, Schema& s) {
  s.name("light", "A light; a sun or spot shines along its node's forward direction.");
  s.main("type");
  s.add("type", light.type, "A sun shines everywhere, a point all around, a spot in a cone.");
  s.add("color", light.color, "Color of the light.");
  s.add("brightness", light.brightness, "1 is a clear day.").at_least(0);
  s.add("range", light.range, "How far a point or spot light reaches, m.").above(0);
  s.add("shadow", light.shadow, "Does it cast shadows?");
  s.angle("angle", light.angle, "A spot's whole cone.").between(0, kPi);
}

void describe(Camera& camera, Schema& s) {
  s.name("camera", "An eye that looks along its node's forward direction.");
  s.angle("field_of_view", camera.field_of_view, "Vertical opening; 60 degrees.").between(radians(1), radians(170));
  s.add("near", camera.near, "What is nearer is not drawn, m.").above(0);
  s.add("far", camera.far, "What is farther is not drawn, m.").above(0);
  s.add("active", camera.active, "The first active camera in tree order is drawn from.");
  s.check<Camera>([](const Camera& c) {
    if (c.near >= c.far) fail("near must be below far (got near ", c.near, ", far ", c.far, ")");
  });
}

}  // namespace tumble
