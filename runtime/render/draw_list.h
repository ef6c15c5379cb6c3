// One picture as plain data: what the engine extracts from the scene and a renderer draws. Floats, relative to
// `origin`.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "base/color.h"
#include "base/math.h"
#include "base/shape.h"

namespace tumble {

class AssetLibrary;

// Column-major 4x4.
using Matrix = std::array<float, 16>;

// Triangles that meshes share: those of a built-in shape, or of one part of the model file that the shape names.
struct DrawShape {
  Shape shape;
  int part = -1;                // -1: no model; what should have been one is drawn as a pink box
  std::uint64_t key = 0;        // equal for equal shapes and parts, in every picture
};
// A picture that is laid on meshes.
struct DrawTexture {
  std::string file;             // path in the game
  int image = -1;               // of the pictures inside a model file; -1: the file itself is a picture
  bool operator==(const DrawTexture&) const = default;
};

// Something to draw with triangles.
struct DrawMesh {
  std::uint32_t shape = 0;      // in DrawList::shapes; see shape_number()
  std::uint32_t texture = 0;    // in DrawList::textures; 0: none
  Matrix matrix;                // model to picture space (world minus origin), the node's scale with it
  Color color;                  // sRGB; tints the texture
  float roughness = 0.7f, metalness = 0, glow = 0;
  float texture_size = 0;       // m that the texture covers before it repeats; 0: once over each face
  bool two_sided = false;
  std::optional<Color> glow_color;  // of the light of its own; none: the mesh's color
};

// A point or spot light.
struct DrawLight {
  bool spot = false;
  std::array<float, 3> position, direction;  // picture space; direction: a spot's, unit
  Color color;
  float brightness = 1, range = 10;          // m
  float angle = 0.7853982f;                  // of a spot's whole cone, rad
};

// A sprite that faces the eye.
struct DrawParticle {
  std::array<float, 3> position;             // picture space
  float size = 0.1f;                         // across, m
  Color color;
  float glow = 0;
};
struct DrawParticles {
  std::string texture;                       // empty: a soft disc
  std::vector<DrawParticle> particles;
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
  float radius = 0;               // of its corners, ui units; at most half a side counts
  std::string image{};            // path in the game: drawn over the whole rectangle, tinted by the color; empty: none
};
struct DrawUi {
  bool is_text = false;
  DrawText text;
  DrawPanel panel;
  // Nothing is drawn outside {x, y, width, height}; no width: no limit.
  std::array<float, 4> clip{};
};

struct DrawList {
  Vec3 origin;                    // world place of the picture space's origin: the camera's, so that floats suffice
  Quat camera_rotation;           // the camera sits at the origin
  double field_of_view = 1.0471975511965976;  // vertical, rad
  double near = 0.1, far = 1000;

  bool has_sun = true;
  Vec3 sun_direction{0.5, -0.75, -0.433};      // along which its light travels, unit
  Color sun_color{1, 0.965, 0.9, 1};           // of the sun that there is without any light
  double sun_brightness = 1;
  bool sun_shadow = true;
  Color sky_top{0.35, 0.55, 0.85, 1}, sky_horizon{0.80, 0.88, 0.95, 1}, ground{0.45, 0.43, 0.40, 1};

  double sky_brightness = 1, exposure = 1;
  std::optional<Color> fog_color;              // none: what the sky behind looks like
  double fog_start = 0, fog_end = 0;           // m from the eye; fog_end 0: no fog

  AssetLibrary* assets = nullptr;              // models and pictures; null: stand-ins
  std::vector<DrawLight> lights;
  std::vector<DrawParticles> particles;
  std::vector<DrawShape> shapes;               // each once
  std::vector<DrawTexture> textures{{}};       // the first stands for none
  std::vector<DrawMesh> meshes;
  std::vector<DrawLine> lines;
  std::vector<DrawUi> ui;

  // Where in shapes or textures these are; they are added where they are new. A texture without a file is number 0.
  std::uint32_t shape_number(const Shape& shape, int part = -1);
  std::uint32_t texture_number(const std::string& file, int image = -1);

 private:
  std::unordered_map<std::uint64_t, std::uint32_t> shape_of_key_;
};

}  // namespace tumble
