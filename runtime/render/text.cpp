#include "render/text.h"

#include <algorithm>

#include "assets/font.h"

namespace tumble {
namespace {

constexpr int kTabWidth = 4;  // spaces

}  // namespace

void lay_out(std::string_view text, double size, bool mono, const std::function<void(const PlacedLetter&)>& each) {
  const Font& font = built_in_font(mono);
  double x = 0;
  int line = 0;
  for (const char32_t letter : letters(text)) {
    if (letter == U'\n') {
      x = 0;
      ++line;
      continue;
    }
    if (letter == U'\r') continue;
    const double width = letter == U'\t' ? kTabWidth * font.advance(U' ') : font.advance(letter);
    each({letter, x, line, width * size});
    x += width * size;
  }
}

TextSize measure_text(const std::string& text, double size, bool mono) {
  TextSize result;
  lay_out(text, size, mono, [&](const PlacedLetter& letter) {
    result.width = std::max(result.width, letter.x + letter.width);
  });
  result.height = size * static_cast<double>(1 + std::count(text.begin(), text.end(), '\n'));
  return result;
}

}  // namespace tumble
