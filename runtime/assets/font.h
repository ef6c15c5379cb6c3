// The two built-in typefaces: how wide texts are, in font units, and what letters look like, in pixels.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace tumble {

// One letter as coverage, 0..255.
struct Glyph {
  int width = 0, height = 0;
  int left = 0, top = 0;  // of the picture's top left corner from the pen on the baseline; top is negative above it
  std::vector<std::uint8_t> coverage;  // rows from the top
};

// A typeface at any size. "size" always is the line height; a letter's body is smaller.
class Font {
 public:
  // `bytes` is a TrueType file and outlives the font.
  explicit Font(std::string_view bytes);
  ~Font();

  // How far the pen moves on after a letter, for size 1. Letters that the face lacks are as wide as its box for them.
  double advance(char32_t letter) const;
  // From the line's top to its baseline, for size 1.
  double ascent() const;
  // A letter drawn `size` pixels high, its pen `shift` (0..1) of a pixel right of a pixel's edge.
  Glyph draw(char32_t letter, double size, double shift) const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

// DejaVu Sans, or DejaVu Sans Mono for code and figures.
const Font& built_in_font(bool mono);

// The letters of a UTF-8 text; what is not valid UTF-8 becomes U+FFFD.
std::u32string letters(std::string_view text);

}  // namespace tumble
