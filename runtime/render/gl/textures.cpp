#include "render/gl/textures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "assets/library.h"
#include "render/batches.h"
#include "render/mipmaps.h"

namespace tumble {
namespace {

constexpr std::uint64_t kKeptPictures = 600;
constexpr int kPinkSide = 1;

std::uint8_t encoded(float linear) {
  const double c = linear <= 0.0031308f ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(std::clamp(c, 0.0, 1.0) * 255));
}

// Colours times opacity, as light: then the colour of what is wholly clear does not bleed into its neighbours when the
// card mixes pixels.
std::vector<std::uint8_t> premultiplied(const Image& image) {
  std::array<float, 256> light;
  for (int i = 0; i < 256; ++i) light[i] = linear(Color{i / 255.0, 0, 0, 1})[0];
  std::vector<std::uint8_t> pixels = image.pixels;
  for (std::size_t i = 0; i + 3 < pixels.size(); i += 4) {
    const std::uint8_t opacity = pixels[i + 3];
    if (opacity == 255) continue;
    for (std::size_t k = i; k < i + 3; ++k) pixels[k] = encoded(light[pixels[k]] * static_cast<float>(opacity) / 255);
  }
  return pixels;
}

bool has_holes(const Image& image) {
  for (std::size_t i = 3; i < image.pixels.size(); i += 4)
    if (image.pixels[i] < 255) return true;
  return false;
}

const Image* image_of(AssetLibrary* assets, const DrawTexture& texture) {
  if (!assets) return nullptr;
  if (texture.image < 0) return assets->image(texture.file);
  const Model* model = assets->model(texture.file);
  const bool known = model && texture.image < static_cast<int>(model->images.size());
  return known ? &model->images[static_cast<std::size_t>(texture.image)] : nullptr;
}

Image pink() {
  Image image{kPinkSide, kPinkSide, {}};
  for (const double part : {kMissing.r, kMissing.g, kMissing.b, kMissing.a})
    image.pixels.push_back(static_cast<std::uint8_t>(std::lround(part * 255)));
  return image;
}

}  // namespace

Textures::Textures(const Gl& gl) : gl_(gl) {}

Textures::~Textures() {
  for (const auto& [key, entry] : entries_) forget(entry);
}

void Textures::forget(const Entry& entry) { gl_.DeleteTextures(1, &entry.texture); }

void Textures::begin_picture(AssetLibrary* assets) {
  ++picture_;
  std::erase_if(entries_, [&](const auto& item) {
    const bool old = assets != assets_ || item.second.last_drawn + kKeptPictures < picture_;
    if (old) forget(item.second);
    return old;
  });
  assets_ = assets;
}

const Textures::Entry& Textures::find(const DrawTexture& texture) {
  const auto [place, is_new] = entries_.try_emplace(Key{texture.file, texture.image});
  Entry& entry = place->second;
  const std::uint64_t version = assets_ ? assets_->version(texture.file) : 0;
  if (is_new) gl_.GenTextures(1, &entry.texture);
  if (is_new || version != entry.version) upload(entry, texture);
  entry.version = version;
  entry.last_drawn = picture_;
  return entry;
}

void Textures::upload(Entry& entry, const DrawTexture& texture) {
  const Image* found = image_of(assets_, texture);
  const bool usable = found && found->width > 0 && found->height > 0;
  const Image image = usable ? Image{found->width, found->height, premultiplied(*found)} : pink();
  entry.has_holes = has_holes(image);
  gl_.ActiveTexture(GL_TEXTURE0);
  gl_.BindTexture(GL_TEXTURE_2D, entry.texture);
  gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  GLint level = 0;
  const auto send = [&](const Image& copy) {
    gl_.TexImage2D(GL_TEXTURE_2D, level++, GL_SRGB8_ALPHA8, copy.width, copy.height, 0, GL_RGBA, GL_UNSIGNED_BYTE, copy.pixels.data());
  };
  send(image);
  for (const Image& copy : smaller_copies(image)) send(copy);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

void Textures::bind(GLuint texture, int unit, bool again) {
  gl_.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  gl_.BindTexture(GL_TEXTURE_2D, texture);
  for (const GLenum side : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    gl_.TexParameteri(GL_TEXTURE_2D, side, again ? GL_REPEAT : GL_CLAMP_TO_EDGE);
}

}  // namespace tumble
