// One texture with every letter drawn so far, at the pixel sizes in use.
#pragma once

#include <cstdint>
#include <map>
#include <tuple>

#include "render/gl/functions.h"

namespace tumble {

class GlyphAtlas {
 public:
  explicit GlyphAtlas(const Gl& gl);
  ~GlyphAtlas();
  GlyphAtlas(const GlyphAtlas&) = delete;
  GlyphAtlas& operator=(const GlyphAtlas&) = delete;

  // A letter's place in the texture (0..1) and its picture's place from the pen on the baseline, in pixels.
  struct Entry {
    float u0 = 0, v0 = 0, u1 = 0, v1 = 0;
    int left = 0, top = 0, width = 0, height = 0;
  };
  // `size` is the line height in pixels; `quarter` shifts the pen by so many quarters of a pixel. Nothing, where the
  // texture is full: then clear() and begin the picture again.
  const Entry* find(char32_t letter, bool mono, double size, int quarter);
  // The middle of a filled spot, for panels.
  Entry filled() const;
  void clear();
  void bind(int unit);

 private:
  using Key = std::tuple<char32_t, bool, double, int>;

  bool place(int width, int height, int& x, int& y);

  const Gl& gl_;
  GLuint texture_ = 0;
  int x_ = 0, y_ = 0, row_height_ = 0;  // where the next letter goes: rows of letters from the top
  std::map<Key, Entry> entries_;
};

}  // namespace tumble
