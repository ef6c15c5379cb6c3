// One picture as plain data: what the engine extracts from the scene and a renderer draws. Floats, relative to
// `origin`.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/color.h"
#include "base/math.h"
#include "base/shape.h"

namespace tumble {

// Column-major 4x4.
using Matrix = std::array<float, 16>;

// Something to draw with triangles. Built-in meshes are named by their shape; a file's by its path.
struct DrawMesh {
  Shape shape;             // already scaled by nothing: the node's scale is in the matrix
  Matrix matrix;           // model to picture space (world minus origin)
  Color color;             // sRGB
  float roughness = 0.7f, metalness = 0, glow = 0;
  std::uint64_t key = 0;   // equal keys: equal shape, may be drawn as instances
};

struct DrawLine {
  std::array<float, 3> from, to;  // picture space
  Color color;
  bool on_top = false;            // seen through everything
};

// Text in ui units: 720 high whatever the window, origin top left.
struct DrawText {
  std::string text;               // UTF-8; line feeds begin new lines
  float x = 0, y = 0, size = 24;  // of the first line's top left corner; size is the line height
  Color color;
  bool mono = false;
};
// A filled rectangle in ui units, drawn in order with the texts.
struct DrawPanel {
  float x = 0, y = 0, width = 0, height = 0;
  Color color;
};
struct DrawUi {
  bool is_text = false;
  DrawText text;
  DrawPanel panel;
};

struct DrawList {
  Vec3 origin;                    // world place of the picture space's origin: the camera's, so that floats suffice
  Quat camera_rotation;           // the camera sits at the origin
  double field_of_view = 1.0471975511965976;  // vertical, rad
  double near = 0.1, far = 1000;

  bool has_sun = true;
  Vec3 sun_direction{0.5, -0.75, -0.433};      // along which its light travels, unit
  Color sun_color;
  double sun_brightness = 1;
  bool sun_shadow = true;
  Color sky_top{0.35, 0.55, 0.85, 1}, sky_horizon{0.80, 0.88, 0.95, 1}, ground{0.45, 0.43, 0.40, 1};

  std::vector<DrawMesh> meshes;
  std::vector<DrawLine> lines;
  std::vector<DrawUi> ui;
};

}  // namespace tumble
