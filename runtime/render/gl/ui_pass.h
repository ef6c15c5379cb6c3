// Panels and texts over the picture, in order, in one draw call.
#pragma once

#include <vector>

#include "render/draw_list.h"
#include "render/gl/glyph_atlas.h"
#include "render/gl/program.h"
#include "render/gl/stream.h"

namespace tumble {

class UiPass {
 public:
  explicit UiPass(const Gl& gl);
  void draw(const std::vector<DrawUi>& ui, int width, int height);

 private:
  struct Corner {
    float x, y, u, v;
    float r, g, b, a;
  };
  struct Rectangle {
    double left, top, right, bottom;  // pixels
  };

  // False where the atlas is full.
  bool build(const std::vector<DrawUi>& ui, double scale);
  bool add_text(const DrawText& text, double scale);
  void add(const Rectangle& place, const GlyphAtlas::Entry& entry, const Color& color);

  const Gl& gl_;
  Program program_;
  Stream stream_;
  GlyphAtlas atlas_;
  std::vector<Corner> corners_;
};

}  // namespace tumble
