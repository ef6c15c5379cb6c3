#include "scene/components.h"

namespace tumble {

void describe(Material& material, Schema& s) {
  s.name("material", "How a mesh looks.");
  s.main("color");
  s.add("color", material.color, "A CSS name, \"#rrggbb\" or a color.");
  s.add("texture", material.texture, "A PNG or JPEG file; the color tints it, and where it is less than half opaque there is a hole.");
  s.add("texture_size", material.texture_size, "How many metres the picture covers before it repeats, m; 0: once over each face.").at_least(0);
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
  s.add("brightness", light.brightness, "1 is a clear day; of a point or spot light, at a quarter of its range.").at_least(0);
  s.add("range", light.range, "How far a point or spot light reaches, m.").above(0);
  s.add("shadow", light.shadow, "Does a sun cast shadows? Points and spots cast none.");
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

void describe(Sky& sky, Schema& s) {
  s.name("sky", "Sky, air and fog around everything; the first visible one in tree order counts.");
  s.main("horizon");
  s.add("top", sky.top, "Color overhead.");
  s.add("horizon", sky.horizon, "Color at the horizon.");
  s.add("ground", sky.ground, "Color below the horizon, and of the light from below.");
  s.add("fog_color", sky.fog_color, "What far things fade to; nil: the horizon's color.");
  s.add("fog_start", sky.fog_start, "Where fog begins, m from the eye.").at_least(0);
  s.add("fog_end", sky.fog_end, "Where nothing else is seen, m from the eye; 0: no fog.").at_least(0);
  s.add("brightness", sky.brightness, "Of the light that comes from the sky.").at_least(0);
  s.add("exposure", sky.exposure, "Of the whole picture; 2 is twice as bright.").above(0);
  s.check<Sky>([](const Sky& k) {
    if (k.fog_end > 0 && k.fog_start >= k.fog_end)
      fail("fog_start must be below fog_end (got fog_start ", k.fog_start, ", fog_end ", k.fog_end, ")");
  });
}

void describe(Sound& sound, Schema& s) {
  s.name("sound", "Something to be heard from where the node is.");
  s.main("file");
  s.add("file", sound.file, "A WAV or OGG file.");
  s.add("volume", sound.volume, "1 is as recorded.").between(0, 4);
  s.add("pitch", sound.pitch, "2 is an octave higher and half as long.").between(0.1, 10);
  s.add("range", sound.range, "From so far away it cannot be heard, m; up to an eighth of it, it is heard in full.").above(0).allow_infinite();
  s.add("loop", sound.loop, "Does it begin again at its end?");
  s.add("playing", sound.playing, "Does it play? Without loop it becomes false at the file's end.");
  s.add("group", sound.group, "Whose volume it goes by: sound.groups.");
}

void describe(Particles& particles, Schema& s) {
  s.name("particles", "Small sprites that rise from a node: smoke, sparks, dust. Once begun they go their own way: they stay behind a node "
                      "that moves, and live on when it is hidden or destroyed.");
  s.main("color");
  s.add("rate", particles.rate, "How many begin in a second, 1/s.").between(0, 10000);
  s.add("life", particles.life, "How long each is seen, s.").between(0.01, 60);
  s.add("speed", particles.speed, "At their start, along the node's up direction, m/s.").at_least(0);
  s.angle("spread", particles.spread, "How far they may stray from that direction; 180 degrees: all around.").between(0, kPi);
  s.add("area", particles.area, "Size of the box in which they begin, around the node, m.").at_least(0);
  s.add("size", particles.size, "Across, at their start, m.").at_least(0);
  s.add("size_end", particles.size_end, "Across, at their end, m.").at_least(0);
  s.add("color", particles.color, "At their start.");
  s.add("color_end", particles.color_end, "At their end; nil: the color, fading.");
  s.add("gravity_factor", particles.gravity_factor, "How much gravity pulls them; below 0 they rise.");
  s.add("damping", particles.damping, "How fast the air stops them, 1/s: the speed falls as exp(-damping t).").at_least(0);
  s.add("variation", particles.variation, "By how much the life, speed and size of each may fall short: 0 makes all alike.").between(0, 1);
  s.add("glow", particles.glow, "Light of their own, as of a material.").at_least(0);
  s.add("texture", particles.texture, "A PNG file; none: a soft disc.");
  s.add("playing", particles.playing, "Do new ones begin? A burst needs it not.");
}

void describe(Animation& animation, Schema& s) {
  s.name("animation", "Keyframes from a model file: they move child nodes that bear the name of a node in the file, and where they are drawn the parts of the node's own model.");
  s.main("clip");
  s.add("clip", animation.clip, "Name of the clip; empty: the file's first. Another one begins at its start, with a speed below 0 at its end.");
  s.add("file", animation.file, "A glTF file; empty: the mesh's own.");
  s.add("speed", animation.speed, "1 is as recorded, -1 backwards.");
  s.add("loop", animation.loop, "Does it begin again at its end?");
  s.add("playing", animation.playing, "Does its time go on? Of a clip that does not loop it is false at the end, and on_animation_end(clip) is called.");
  s.add("time", animation.time, "Where it is in the clip, s.").at_least(0);
}

}  // namespace tumble
