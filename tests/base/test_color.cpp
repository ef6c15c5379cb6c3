#include "base/color.h"
#include "base/error.h"

#include <algorithm>
#include <catch2/catch.hpp>

using namespace tumble;

TEST_CASE("color: CSS names are known in upper and lower case", "[base]") {
  CHECK(parse_color("orange") == Color{1, 165 / 255.0, 0, 1});
  CHECK(parse_color("RebeccaPurple") == Color{0x66 / 255.0, 0x33 / 255.0, 0x99 / 255.0, 1});
  CHECK(parse_color("green") == Color{0, 128 / 255.0, 0, 1});
  CHECK_FALSE(parse_color("oragne"));
  CHECK_FALSE(parse_color(""));
}

TEST_CASE("color: there are 148 names in alphabetical order, and each is found", "[base]") {
  const auto& names = color_names();

  CHECK(names.size() == 148);
  CHECK(std::is_sorted(names.begin(), names.end()));
  for (const std::string& name : names) CHECK(parse_color(name));
}

TEST_CASE("color: both spellings of gray are one colour", "[base]") {
  for (const std::string& name : color_names()) {
    const auto place = name.find("gray");
    if (place == std::string::npos) continue;
    std::string twin = name;
    twin.replace(place, 4, "grey");
    CHECK(parse_color(name) == parse_color(twin));
  }
}

TEST_CASE("color: hexadecimal forms of three, six and eight digits", "[base]") {
  CHECK(parse_color("#f80") == Color{1, 0x88 / 255.0, 0, 1});
  CHECK(parse_color("#FF8800") == parse_color("#f80"));
  CHECK(parse_color("#ff880080") == Color{1, 0x88 / 255.0, 0, 0x80 / 255.0});
  for (const char* wrong : {"#", "#ff", "#ffff", "#fffff", "#ggg", "#fffffffff", "ff8800", "#-12"}) CHECK_FALSE(parse_color(wrong));
}

TEST_CASE("color: unknown texts are refused with the way out", "[base]") {
  CHECK_THROWS_WITH(color_or_fail("oragne", "scene.add: color"), "scene.add: color: unknown name 'oragne'; did you mean 'orange'?");
  CHECK_THROWS_WITH(color_or_fail("qqqqqq", "color"), "color: unknown name 'qqqqqq'; give a CSS name such as 'orange', or '#rrggbb'");
  CHECK_THROWS_WITH(color_or_fail("#12", "color"), "color: '#12' is not a color; write #rgb, #rrggbb or #rrggbbaa");
}

TEST_CASE("color: what to_hex writes is read back as the same bytes", "[base]") {
  for (int i = 0; i < 256; ++i) {
    const Color color{i / 255.0, (255 - i) / 255.0, (i * 7 % 256) / 255.0, i % 3 ? 1 : i / 255.0};
    CHECK(parse_color(to_hex(color)) == color);
  }
  CHECK(to_hex({1, 0, 0, 1}) == "#ff0000");
  CHECK(to_hex({2, -1, 0, 0.5}) == "#ff000080");
}

TEST_CASE("color: hues run red, yellow, green, cyan, blue, magenta and wrap around", "[base]") {
  const Color wheel[] = {{1, 0, 0, 1}, {1, 1, 0, 1}, {0, 1, 0, 1}, {0, 1, 1, 1}, {0, 0, 1, 1}, {1, 0, 1, 1}};
  for (int i = -6; i < 12; ++i) {
    const Color color = from_hsv(i / 6.0, 1, 1), expected = wheel[(i + 6) % 6];
    CHECK(color.r == Approx(expected.r).margin(1e-12));
    CHECK(color.g == Approx(expected.g).margin(1e-12));
    CHECK(color.b == Approx(expected.b).margin(1e-12));
  }
  CHECK(from_hsv(0.3, 0, 0.25) == Color{0.25, 0.25, 0.25, 1});
}
