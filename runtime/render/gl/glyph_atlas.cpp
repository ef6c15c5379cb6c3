#include "render/gl/glyph_atlas.h"

#include <algorithm>
#include <vector>

#include "assets/font.h"

namespace tumble {
namespace {

constexpr int kSide = 1024;
constexpr int kFilledSide = 4;
constexpr int kGap = 1;  // between letters, so that none bleeds into another

}  // namespace

GlyphAtlas::GlyphAtlas(const Gl& gl) : gl_(gl) {
  gl_.GenTextures(1, &texture_);
  gl_.BindTexture(GL_TEXTURE_2D, texture_);
  for (const GLenum side : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    gl_.TexParameteri(GL_TEXTURE_2D, side, GL_CLAMP_TO_EDGE);
  for (const GLenum way : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl_.TexParameteri(GL_TEXTURE_2D, way, GL_LINEAR);
  clear();
}

GlyphAtlas::~GlyphAtlas() { gl_.DeleteTextures(1, &texture_); }

void GlyphAtlas::clear() {
  entries_.clear();
  std::vector<std::uint8_t> pixels(std::size_t{kSide} * kSide, 0);
  for (int y = 0; y < kFilledSide; ++y) std::fill_n(&pixels[static_cast<std::size_t>(y) * kSide], kFilledSide, 255);
  gl_.BindTexture(GL_TEXTURE_2D, texture_);
  gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_R8, kSide, kSide, 0, GL_RED, GL_UNSIGNED_BYTE, pixels.data());
  x_ = kFilledSide + kGap;
  y_ = 0;
  row_height_ = kFilledSide;
}

GlyphAtlas::Entry GlyphAtlas::filled() const {
  constexpr float middle = 0.5f * kFilledSide / kSide;
  return {middle, middle, middle, middle, 0, 0, 0, 0};
}

void GlyphAtlas::bind(int unit) {
  gl_.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  gl_.BindTexture(GL_TEXTURE_2D, texture_);
}

bool GlyphAtlas::place(int width, int height, int& x, int& y) {
  if (x_ + width > kSide) {
    x_ = 0;
    y_ += row_height_ + kGap;
    row_height_ = 0;
  }
  if (width > kSide || y_ + height > kSide) return false;
  x = x_;
  y = y_;
  x_ += width + kGap;
  row_height_ = std::max(row_height_, height);
  return true;
}

const GlyphAtlas::Entry* GlyphAtlas::find(char32_t letter, bool mono, double size, int quarter) {
  const Key key{letter, mono, size, quarter};
  const auto found = entries_.find(key);
  if (found != entries_.end()) return &found->second;

  const Glyph glyph = built_in_font(mono).draw(letter, size, quarter / 4.0);
  int x = 0, y = 0;
  if (!place(glyph.width, glyph.height, x, y)) return nullptr;
  gl_.BindTexture(GL_TEXTURE_2D, texture_);
  gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  if (glyph.width > 0)
    gl_.TexSubImage2D(GL_TEXTURE_2D, 0, x, y, glyph.width, glyph.height, GL_RED, GL_UNSIGNED_BYTE,
                      glyph.coverage.data());
  const auto place_of = [](int pixel) { return static_cast<float>(pixel) / kSide; };
  const Entry entry{place_of(x), place_of(y), place_of(x + glyph.width), place_of(y + glyph.height),
                    glyph.left,  glyph.top,   glyph.width,               glyph.height};
  return &entries_.emplace(key, entry).first->second;
}

}  // namespace tumble
