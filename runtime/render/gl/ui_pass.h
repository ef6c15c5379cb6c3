// Panels and texts over the picture, in order; one draw call for each change of picture.
#pragma once

#include <vector>

#include "render/draw_list.h"
#include "render/gl/glyph_atlas.h"
#include "render/gl/program.h"
#include "render/gl/stream.h"
#include "render/gl/textures.h"

namespace tumble {

class UiPass {
 public:
  explicit UiPass(const Gl& gl);
  void draw(const std::vector<DrawUi>& ui, Textures& textures, int width, int height);

 private:
  struct Corner {
    float x, y, u, v;
    float r, g, b, a;
    float middle_x, middle_y, half_x, half_y, radius;  // of the panel, pixels; radius 0: not round
  };
  struct Rectangle {
    double left, top, right, bottom;  // pixels
  };
  // What is drawn from one texture.
  struct Run {
    GLuint image = 0;  // 0: letters and plain panels
    std::size_t first = 0, count = 0;
  };

  // False where the atlas is full.
  bool build(const std::vector<DrawUi>& ui, Textures& textures, double scale);
  bool add_text(const DrawText& text, double scale);
  void add_panel(const DrawPanel& panel, Textures& textures, double scale);
  void use_image(GLuint image);
  void add(Rectangle place, const GlyphAtlas::Entry& entry, const Color& color, double radius = 0);

  const Gl& gl_;
  Program program_;
  Stream stream_;
  GlyphAtlas atlas_;
  Rectangle clip_{};
  std::vector<Corner> corners_;
  std::vector<Run> runs_;
};

}  // namespace tumble
