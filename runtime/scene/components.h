// What hangs on a node to be seen or heard, beside its mesh: plain settings. Bodies and joints are the world's.
#pragma once

#include <optional>
#include <string>

#include "base/color.h"
#include "base/describe.h"

namespace tumble {

struct Material {
  Color color{0.8, 0.8, 0.8, 1};
  std::string texture;
  double texture_size = 0;    // m that the picture covers; 0: once over each face of the mesh
  double roughness = 0.7, metalness = 0, glow = 0, opacity = 1;
};
void describe(Material& material, Schema& s);

enum class LightType { sun, point, spot };
const EnumNames& enum_names(LightType);
struct Light {
  LightType type = LightType::sun;
  Color color{1, 1, 1, 1};
  double brightness = 1;      // 1 is a clear day
  double range = 10;          // of a point or spot light, m
  bool shadow = true;
  double angle = 0.7853981633974483;  // of a spot's whole cone, rad
};
void describe(Light& light, Schema& s);

struct Camera {
  double field_of_view = 1.0471975511965976;  // vertical, rad (60 degrees)
  double near = 0.1, far = 1000;              // m
  bool active = true;                         // the first active camera in tree order is drawn from
};
void describe(Camera& camera, Schema& s);

// Air and sky around everything; the first visible one in tree order counts.
struct Sky {
  Color top{0.35, 0.55, 0.85, 1}, horizon{0.80, 0.88, 0.95, 1}, ground{0.45, 0.43, 0.40, 1};
  std::optional<Color> fog_color;   // none: the horizon's
  double fog_start = 0, fog_end = 0;  // m from the eye; fog_end 0: no fog
  double brightness = 1;      // of the light that comes from the sky
  double exposure = 1;        // of the whole picture
};
void describe(Sky& sky, Schema& s);

struct Sound {
  std::string file;           // WAV or OGG
  double volume = 1, pitch = 1;
  double range = 30;          // m; from there on it cannot be heard
  bool loop = false, playing = false;
  std::string group = "effects";
};
void describe(Sound& sound, Schema& s);

// Small sprites that face the eye. They are drawn only: no script reads them, no hash knows them.
struct Particles {
  double rate = 20;           // 1/s
  double life = 1;            // s
  double speed = 1;           // m/s, along the node's up direction
  double spread = 0.4363323129985824;  // rad around it (25 degrees)
  Vec3 area;                  // size of the box they begin in, m
  double size = 0.1, size_end = 0;     // m
  Color color{1, 1, 1, 1};
  std::optional<Color> color_end;      // none: the color, clear
  double gravity_factor = 0;
  double damping = 0;         // 1/s
  double variation = 0.25;    // by how much life, speed and size may fall short
  double glow = 0;            // as of a material
  std::string texture;        // none: a soft disc
  bool playing = true;
};
void describe(Particles& particles, Schema& s);

// Plays a clip of keyframes from a model file: on the parts of the node's mesh, and on descendants that bear the name
// of a node in the file.
struct Animation {
  std::string clip;           // "": the file's first
  std::string file;           // "": the mesh's
  double speed = 1;
  bool loop = true, playing = true;
  double time = 0;            // s into the clip
};
void describe(Animation& animation, Schema& s);

}  // namespace tumble
