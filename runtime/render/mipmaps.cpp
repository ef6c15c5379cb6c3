#include "render/mipmaps.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tumble {
namespace {

// The curve of screens (IEC 61966-2-1) both ways, for many pixels.
class ScreenCurve {
 public:
  ScreenCurve() {
    for (std::size_t i = 0; i < 256; ++i) light_[i] = static_cast<float>(light_of(static_cast<double>(i)));
    for (std::size_t i = 0; i < 255; ++i) next_[i] = static_cast<float>(light_of(static_cast<double>(i) + 0.5));
    next_[255] = 2;  // brighter than anything
    std::uint8_t value = 0;
    for (std::size_t i = 0; i <= kSteps; ++i) {
      while (next_[value] <= static_cast<float>(i) / kSteps) ++value;
      first_[i] = value;
    }
  }

  float light(std::uint8_t value) const { return light_[value]; }
  std::uint8_t value(float light) const {
    std::uint8_t value = first_[static_cast<std::size_t>(light * kSteps)];
    while (next_[value] <= light) ++value;
    return value;
  }

 private:
  static constexpr std::size_t kSteps = 1024;

  static double light_of(double value) {
    const double c = value / 255;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  }

  std::array<float, 256> light_, next_;           // next_: from there on it is the value after
  std::array<std::uint8_t, kSteps + 1> first_{};  // the value at the beginning of each step
};

// Which two rows or columns a smaller one lies between, and its share of the second.
struct Between {
  std::size_t first, second;
  float share;
};

std::vector<Between> places(int size, int smaller) {
  std::vector<Between> result;
  for (int i = 0; i < smaller; ++i) {
    const double at = (i + 0.5) * size / smaller - 0.5;
    const auto first = static_cast<std::size_t>(at);
    result.push_back({first, std::min(first + 1, static_cast<std::size_t>(size) - 1), static_cast<float>(at - static_cast<double>(first))});
  }
  return result;
}

Image half(const Image& image, const ScreenCurve& curve) {
  Image result{std::max(1, image.width / 2), std::max(1, image.height / 2), {}};
  result.pixels.resize(std::size_t{4} * result.width * result.height);
  const std::vector<Between> across = places(image.width, result.width);
  const auto row = [&](std::size_t y) { return &image.pixels[4 * y * static_cast<std::size_t>(image.width)]; };
  std::uint8_t* out = result.pixels.data();
  for (const Between& y : places(image.height, result.height)) {
    const std::uint8_t *upper = row(y.first), *lower = row(y.second);
    for (const Between& x : across) {
      const auto mixed = [&](auto reading, std::size_t part) {
        const auto along = [&](const std::uint8_t* line) {
          const float a = reading(line[4 * x.first + part]), b = reading(line[4 * x.second + part]);
          return a + (b - a) * x.share;
        };
        const float above = along(upper);
        return above + (along(lower) - above) * y.share;
      };
      for (std::size_t part = 0; part < 3; ++part) *out++ = curve.value(mixed([&](std::uint8_t value) { return curve.light(value); }, part));
      *out++ = static_cast<std::uint8_t>(std::lround(mixed([](std::uint8_t value) { return static_cast<float>(value); }, 3)));
    }
  }
  return result;
}

}  // namespace

std::vector<Image> smaller_copies(const Image& image) {
  static const ScreenCurve curve;
  std::vector<Image> result;
  for (const Image* last = &image; last->width > 1 || last->height > 1; last = &result.back()) result.push_back(half(*last, curve));
  return result;
}

}  // namespace tumble
