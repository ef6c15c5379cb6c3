#include "assets/image.h"

#include <cstdlib>
#include <cstring>

// Zeroed, so that a damaged picture, which leaves pixels unwritten, is the same in every run: it may be a height field.
static void* zeroed_realloc(void* old, std::size_t old_bytes, std::size_t bytes) {
  void* fresh = std::calloc(1, bytes);
  if (fresh && old) std::memcpy(fresh, old, old_bytes < bytes ? old_bytes : bytes);
  if (fresh) std::free(old);
  return fresh;
}

#define STBI_MALLOC(bytes) std::calloc(1, bytes)
#define STBI_REALLOC_SIZED(old, old_bytes, bytes) zeroed_realloc(old, old_bytes, bytes)
#define STBI_FREE(old) std::free(old)
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_NO_STDIO
#define STBI_MAX_DIMENSIONS 8192
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_ONLY_BMP
#define STBI_ONLY_TGA
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb_image.h>
#pragma GCC diagnostic pop

#include <fstream>
#include <iterator>

#include "base/error.h"

namespace tumble {

static_assert(STBI_MAX_DIMENSIONS == kLargestImageSide);

// Packing makes at most 1032 bytes of one, and a pixel takes at least a bit: a small file that claims more is refused
// before memory is taken for its pixels.
static bool claims_too_much(std::string_view bytes, const Image& image) {
  constexpr std::size_t kBestPacking = 1032;
  const std::size_t pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  return bytes.starts_with("\x89PNG") && pixels / 8 > kBestPacking * bytes.size();
}

Image read_image(std::string_view bytes, const std::string& name) {
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
  const int size = static_cast<int>(bytes.size());
  Image image;
  int channels = 0;
  if (!stbi_info_from_memory(data, size, &image.width, &image.height, &channels))
    fail("image: '", name, "' is no picture that can be read (", stbi_failure_reason(), "); give a PNG or JPEG file");
  if (image.width > kLargestImageSide || image.height > kLargestImageSide)
    fail("image: '", name, "' is ", image.width, " x ", image.height, " pixels; make each side at most ",
         kLargestImageSide);
  if (claims_too_much(bytes, image)) fail("image: '", name, "' is damaged (it ends before its pixels do); save it again as PNG");

  stbi_uc* pixels = stbi_load_from_memory(data, size, &image.width, &image.height, &channels, 4);
  if (!pixels) fail("image: '", name, "' is damaged (", stbi_failure_reason(), "); save it again as PNG");
  image.pixels.assign(pixels, pixels + std::size_t{4} * image.width * image.height);
  stbi_image_free(pixels);
  return image;
}

Image load_image(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) fail("image: cannot read '", file, "'; check its name and folder");
  const std::string bytes((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  return read_image(bytes, file);
}

}  // namespace tumble
