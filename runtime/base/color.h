// Colours as people write them: red, green, blue and opacity from 0 to 1, in the sRGB curve.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tumble {

struct Color {
  double r = 1, g = 1, b = 1, a = 1;
  bool operator==(const Color&) const = default;
};

// A CSS name ("orange") or "#rgb", "#rrggbb", "#rrggbbaa"; nothing for any other text.
std::optional<Color> parse_color(std::string_view text);
// The same, but an unknown text is an Error that begins with `where` and gives the nearest name.
Color color_or_fail(std::string_view text, std::string_view where);
// All CSS colour names, in alphabetical order.
const std::vector<std::string>& color_names();
// hue, saturation and value from 0 to 1; hues wrap around.
Color from_hsv(double hue, double saturation, double value);
// "#rrggbb", or "#rrggbbaa" where it is not opaque.
std::string to_hex(const Color& color);

}  // namespace tumble
