#include "render/text.h"

#include <catch2/catch.hpp>

#include "assets/font.h"

using namespace tumble;

TEST_CASE("text: umlauts are single letters and have a picture", "[render]") {
  CHECK(letters("Äpfel für Größe ß é").size() == 19);
  CHECK(letters("Größe")[2] == U'ö');
  CHECK(letters("🏀")[0] == char32_t{0x1F3C0});
  for (const bool mono : {false, true})
    for (const char32_t letter : letters("ÄÖÜäöüßéñçœŁ€–…"))
      CHECK(built_in_font(mono).draw(letter, 24, 0).width > 3);
}

TEST_CASE("text: bytes that are not UTF-8 become replacement letters, and the rest is read", "[render]") {
  CHECK(letters("a\xFF" "b") == std::u32string{U'a', 0xFFFD, U'b'});
  CHECK(letters("\xC3") == std::u32string{0xFFFD});
  CHECK(letters("\xC3(") == std::u32string{0xFFFD, U'('});
}

TEST_CASE("text: a text is as wide as its widest line and as high as its lines", "[render]") {
  const TextSize one = measure_text("wide line", 24), both = measure_text("i\nwide line", 24);

  CHECK(both.width == one.width);
  CHECK(one.height == 24);
  CHECK(both.height == 48);
  CHECK(measure_text("", 24).width == 0);
  CHECK(measure_text("", 24).height == 24);
}

TEST_CASE("text: width grows with size and adds up over letters", "[render]") {
  CHECK(measure_text("Ball", 48).width == Approx(2 * measure_text("Ball", 24).width));
  CHECK(measure_text("Ball", 24).width == Approx(measure_text("Ba", 24).width + measure_text("ll", 24).width));
}

TEST_CASE("text: the width is the typeface's own, the same everywhere", "[render]") {
  // DejaVu Sans: "H" is 1540 of 2048 units wide, its lines are 2384 high; DejaVu Sans Mono: 1233 of 2384.
  CHECK(measure_text("H", 2384).width == Approx(1540));
  CHECK(measure_text("iW", 2384, true).width == Approx(2 * 1233));
}

TEST_CASE("text: a letter's picture is as high as its size says", "[render]") {
  // A capital is 1493 of DejaVu Sans's 2384 units high.
  const Glyph glyph = built_in_font(false).draw(U'H', 100, 0);

  CHECK(glyph.height == Approx(100 * 1493 / 2384.0).margin(1));
  CHECK(glyph.top == -glyph.height);
  CHECK(glyph.coverage.size() == static_cast<std::size_t>(glyph.width) * glyph.height);
}
