#include <zlib.h>

#include <cstdlib>

// stb's own packing takes four times as long and packs worse.
static unsigned char* pack(unsigned char* bytes, int size, int* packed_size, int level) {
  uLongf length = compressBound(static_cast<uLong>(size));
  auto* packed = static_cast<unsigned char*>(std::malloc(length));
  if (!packed || compress2(packed, &length, bytes, static_cast<uLong>(size), level) != Z_OK) {
    std::free(packed);
    return nullptr;
  }
  *packed_size = static_cast<int>(length);
  return packed;
}

#define STBIW_ZLIB_COMPRESS pack
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#include <stb_image_write.h>
#pragma GCC diagnostic pop

#include <fstream>

#include "base/error.h"
#include "render/renderer.h"

namespace tumble {

void write_png(const Picture& picture, const std::string& file) {
  if (picture.pixels.empty())
    fail("picture: there is none to write to '", file, "'; draw with a renderer that makes pictures");
  stbi_write_png_compression_level = 1;
  stbi_write_force_png_filter = 1;  // each pixel from its left neighbour: trying all five for each row takes longer than packing
  std::string bytes;
  const auto append = [](void* context, void* data, int size) {
    static_cast<std::string*>(context)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
  };
  stbi_write_png_to_func(append, &bytes, picture.width, picture.height, 3, picture.pixels.data(), picture.width * 3);
  std::ofstream out(file, std::ios::binary);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!out.flush()) fail("picture: cannot write '", file, "'; check that its folder exists and may be written to");
}

}  // namespace tumble
