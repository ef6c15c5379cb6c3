#include "render/mipmaps.h"

#include <catch2/catch.hpp>

#include <array>

using namespace tumble;

namespace {

Image filled(int width, int height, const std::array<std::uint8_t, 4>& pixel) {
  Image image{width, height, std::vector<std::uint8_t>(std::size_t{4} * width * height)};
  for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = pixel[i % 4];
  return image;
}

}  // namespace

TEST_CASE("mipmaps: they halve down to one pixel", "[render]") {
  std::vector<std::pair<int, int>> sizes;
  for (const Image& copy : smaller_copies(filled(12, 5, {1, 2, 3, 4}))) {
    sizes.emplace_back(copy.width, copy.height);
    CHECK(copy.pixels.size() == std::size_t{4} * copy.width * copy.height);
  }

  CHECK(sizes == std::vector<std::pair<int, int>>{{6, 2}, {3, 1}, {1, 1}});
  CHECK(smaller_copies(filled(1, 1, {1, 2, 3, 4})).empty());
}

TEST_CASE("mipmaps: one colour stays that colour", "[render]") {
  for (int value = 0; value < 256; ++value) {
    const auto v = static_cast<std::uint8_t>(value);
    for (const Image& copy : smaller_copies(filled(7, 3, {v, v, v, v})))
      REQUIRE(copy.pixels == filled(copy.width, copy.height, {v, v, v, v}).pixels);
  }
}

TEST_CASE("mipmaps: colours are mixed as light, opacity as it is", "[render]") {
  const Image image{2, 1, {0, 0, 255, 0, 255, 0, 255, 255}};

  const std::vector<Image> copies = smaller_copies(image);

  // Half the light of white is 188 on the curve of screens.
  REQUIRE(copies.size() == 1);
  CHECK(copies[0].pixels == std::vector<std::uint8_t>{188, 0, 255, 128});
}
