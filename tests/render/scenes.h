// Small scenes for pictures, put together with verbs, and windows that nobody sees.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "assets/library.h"
#include "platform/window.h"
#include "render/renderer.h"

namespace tumble::test {

class PictureScene {
 public:
  explicit PictureScene(Vec3 eye = {4, 3, 6}, Vec3 target = {0, 0.5, 0});
  DrawMesh& add(ShapeKind kind, Vec3 position, const std::string& color, Quat rotation = {}, Vec3 scale = {1, 1, 1});
  DrawMesh& add(const Shape& shape, Vec3 position, const std::string& color, Quat rotation = {}, Vec3 scale = {1, 1, 1});
  void add_line(Vec3 from, Vec3 to, const std::string& color, bool on_top = false);
  void add_panel(float x, float y, float width, float height, const Color& color);
  void add_text(const std::string& text, float x, float y, float size, bool mono = false);

  DrawList list;
};

// A ground, a stack of grey boxes, one of each other shape, glass, metal and a thing that glows.
PictureScene still_life();

// Three lamps and a spot on things that nothing else lights.
PictureScene lamps_at_night();
// Columns in two rows that end in fog of the sky's colours.
PictureScene columns_in_fog();
struct Assets;
// A picture "checks.png" of 8 x 8 checks, the upper left one red.
Assets checks();
// Shapes with that picture: once over each face, and by the metre.
PictureScene painted_shapes(const Assets& assets);
// Grey smoke before and behind a box, glowing sparks, glass before and behind glass.
PictureScene smoke_and_sparks();

// A picture off screen, of the whole way from opening a window to reading it back.
Picture draw(const DrawList& list, int width = 640, int height = 360, bool es = false);

// A window that nobody sees, 320 x 180.
WindowDef hidden_window();

struct Pixel {
  int r, g, b;
};
// By column and row from the top left.
Pixel pixel(const Picture& picture, int x, int y);

// A PNG file's bytes, from RGB rows.
std::string picture_of(int width, int height, const std::vector<std::uint8_t>& pixels);

// Files that a picture may use, by name, and what was said about them.
struct Assets {
  explicit Assets(std::map<std::string, std::string> content);
  std::shared_ptr<std::map<std::string, std::string>> files;
  std::shared_ptr<std::vector<std::string>> messages;
  std::unique_ptr<AssetLibrary> library;
};

struct Difference {
  double mean = 0;     // of the channels' absolute differences, 0..255
  double changed = 0;  // share of pixels with a channel more than 12 off, 0..1
  // Another driver rounds otherwise and moves edges by a pixel; nobody would see that.
  bool is_small() const { return mean < 0.5 && changed < 0.0015; }
};
// Pictures of different size differ wholly.
Difference difference(const Picture& a, const Picture& b);

Picture load_picture(const std::string& file);
// Compares with tests/golden/<name>.png. A difference leaves <name>.actual.png in the working folder.
Difference difference_to_golden(const Picture& picture, const std::string& name);

}  // namespace tumble::test
