#include "assets/font.h"

#define STB_TRUETYPE_IMPLEMENTATION
#define STBTT_STATIC
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb_truetype.h>
#pragma GCC diagnostic pop

#include <array>
#include <cassert>

namespace tumble {

// Generated from assets/fonts at build time; empty for an unknown name.
std::string_view embedded_font(std::string_view file);

struct Font::Data {
  stbtt_fontinfo info;
  int ascent = 0, line = 1;                // font units
  std::array<int, 256> advance_of_latin{};  // most texts; others are looked up
};

Font::Font(std::string_view bytes) : data_(std::make_unique<Data>()) {
  const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
  [[maybe_unused]] const int ok = stbtt_InitFont(&data_->info, data, stbtt_GetFontOffsetForIndex(data, 0));
  assert(ok);
  int descent = 0, gap = 0, bearing = 0;
  stbtt_GetFontVMetrics(&data_->info, &data_->ascent, &descent, &gap);
  data_->line = data_->ascent - descent + gap;
  for (int letter = 0; letter < 256; ++letter)
    stbtt_GetCodepointHMetrics(&data_->info, letter, &data_->advance_of_latin[letter], &bearing);
}

Font::~Font() = default;

double Font::advance(char32_t letter) const {
  int advance = 0, bearing = 0;
  if (letter < 256) advance = data_->advance_of_latin[letter];
  else stbtt_GetCodepointHMetrics(&data_->info, static_cast<int>(letter), &advance, &bearing);
  return static_cast<double>(advance) / data_->line;
}

double Font::ascent() const { return static_cast<double>(data_->ascent) / data_->line; }

Glyph Font::draw(char32_t letter, double size, double shift) const {
  const auto scale = static_cast<float>(size / data_->line);
  const auto x_shift = static_cast<float>(shift);
  const int index = stbtt_FindGlyphIndex(&data_->info, static_cast<int>(letter));
  int left, top, right, bottom;
  stbtt_GetGlyphBitmapBoxSubpixel(&data_->info, index, scale, scale, x_shift, 0, &left, &top, &right, &bottom);

  Glyph glyph{right - left, bottom - top, left, top, {}};
  if (glyph.width <= 0 || glyph.height <= 0) return {};
  glyph.coverage.resize(static_cast<std::size_t>(glyph.width) * glyph.height);
  stbtt_MakeGlyphBitmapSubpixel(&data_->info, glyph.coverage.data(), glyph.width, glyph.height, glyph.width, scale,
                                scale, x_shift, 0, index);
  return glyph;
}

const Font& built_in_font(bool mono) {
  static const Font sans_font(embedded_font("DejaVuSans.ttf"));
  static const Font mono_font(embedded_font("DejaVuSansMono.ttf"));
  return mono ? mono_font : sans_font;
}

namespace {

// How many bytes follow a first byte, and the letter's bits in it; -1 where no letter begins so.
struct Lead {
  int more;
  char32_t bits;
};
Lead lead(unsigned char byte) {
  if (byte < 0x80) return {0, byte};
  if (byte >= 0xC2 && byte < 0xE0) return {1, byte & 0x1Fu};
  if (byte >= 0xE0 && byte < 0xF0) return {2, byte & 0x0Fu};
  if (byte >= 0xF0 && byte < 0xF5) return {3, byte & 0x07u};
  return {-1, 0};
}

}  // namespace

std::u32string letters(std::string_view text) {
  constexpr char32_t kReplacement = 0xFFFD;
  std::u32string result;
  for (std::size_t i = 0; i < text.size();) {
    const auto [more, bits] = lead(static_cast<unsigned char>(text[i++]));
    char32_t letter = bits;
    int read = 0;
    while (read < more && i < text.size() && (static_cast<unsigned char>(text[i]) & 0xC0) == 0x80) {
      letter = (letter << 6) | (static_cast<unsigned char>(text[i++]) & 0x3Fu);
      ++read;
    }
    result.push_back(more < 0 || read < more ? kReplacement : letter);
  }
  return result;
}

}  // namespace tumble
