#include "assets/gltf_materials.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "assets/gltf_numbers.h"

namespace tumble {

namespace {

const Image kPink{1, 1, {255, 0, 255, 255}};

double from_linear(double v) { return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055; }
double to_linear(double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); }

// Files give light as it adds up; our colours are as screens show them.
Color color_of(const std::vector<double>& linear, const Color& fallback) {
  if (linear.size() < 3) return fallback;
  const auto channel = [](double v) { return from_linear(std::isfinite(v) ? std::max(v, 0.0) : 0.0); };
  return {channel(linear[0]), channel(linear[1]), channel(linear[2]), linear.size() > 3 ? std::clamp(linear[3], 0.0, 1.0) : 1};
}

double extension_number(const tinygltf::Material& material, const char* extension, const char* field, double fallback) {
  const auto found = material.extensions.find(extension);
  if (found == material.extensions.end() || !found->second.IsObject() || !found->second.Has(field)) return fallback;
  const tinygltf::Value& value = found->second.Get(std::string(field));
  const double number = value.IsNumber() ? value.GetNumberAsDouble() : fallback;
  return std::isfinite(number) ? number : fallback;
}

struct Materials {
  GltfFile& file;
  Model& model;
  std::size_t pixels = 0;
  std::map<int, Image> decoded;                      // by the file's number
  std::map<std::pair<int, std::string>, int> taken;  // number and how its alpha counts -> of Model::images

  // The picture that a texture of the file shows; decoded once. Budget and faults are one note, and pink.
  const Image& picture(int texture) {
    const auto& textures = file.records->textures;
    const int source = texture >= 0 && static_cast<std::size_t>(texture) < textures.size() ? textures[static_cast<std::size_t>(texture)].source : -1;
    const auto [place, fresh] = decoded.try_emplace(source, kPink);
    if (!fresh) return place->second;
    try {
      place->second = read(source);
    } catch (const Error& error) {
      model.notes.push_back(std::string(error.what()) + "; it is drawn in pink");
    }
    return place->second;
  }

  Image read(int source) {
    if (source < 0 || static_cast<std::size_t>(source) >= file.images.size())
      fail("a material wants picture ", source, " of ", file.images.size());
    const GltfImage& image = file.images[static_cast<std::size_t>(source)];
    const std::string what = "picture " + std::to_string(source);
    const std::string fetched = image.uri.empty() ? std::string() : fetch(file, image.uri, what);
    const std::string_view bytes = image.uri.empty() ? view_bytes(file, image.view, what.c_str()) : std::string_view(fetched);
    Image read = read_image(bytes, file.name + "', " + what + " of '" + file.name);
    pixels += static_cast<std::size_t>(read.width) * static_cast<std::size_t>(read.height);
    if (pixels > kMostModelPixels) fail(what, " is one too many: together they have more than ", kMostModelPixels, " pixels");
    return read;
  }

  // As a part of the model, its alpha as the material wants it: all opaque, cut at a value, or as it is.
  int image(int texture, const tinygltf::Material& material) {
    const auto& textures = file.records->textures;
    const int source = texture >= 0 && static_cast<std::size_t>(texture) < textures.size() ? textures[static_cast<std::size_t>(texture)].source : -1;
    const auto [place, fresh] = taken.try_emplace({source, material.alphaMode}, static_cast<int>(model.images.size()));
    if (!fresh) return place->second;
    Image image = picture(texture);
    for (std::size_t i = 3; i < image.pixels.size(); i += 4) {
      if (material.alphaMode == "MASK") image.pixels[i] = image.pixels[i] < 255 * material.alphaCutoff ? 0 : 255;
      else if (material.alphaMode != "BLEND") image.pixels[i] = 255;
    }
    model.images.push_back(std::move(image));
    return place->second;
  }

  // The mean of a picture as light, 0 to 1: for what we keep one value of.
  std::array<double, 3> mean(int texture, bool linear) {
    const Image& image = picture(texture);
    std::array<double, 256> value;
    for (int i = 0; i < 256; ++i) value[static_cast<std::size_t>(i)] = linear ? i / 255.0 : to_linear(i / 255.0);
    std::array<double, 3> sum{};
    for (std::size_t i = 0; i + 3 < image.pixels.size(); i += 4)
      for (std::size_t c = 0; c < 3; ++c) sum[c] += value[image.pixels[i + c]];
    for (double& s : sum) s /= static_cast<double>(image.width) * image.height;
    return sum;
  }

  ModelMaterial convert(const tinygltf::Material& from) {
    const tinygltf::PbrMetallicRoughness& pbr = from.pbrMetallicRoughness;
    ModelMaterial material;
    material.color = color_of(pbr.baseColorFactor, {1, 1, 1, 1});
    if (from.alphaMode != "BLEND") material.color.a = 1;
    if (pbr.baseColorTexture.index >= 0) material.image = image(pbr.baseColorTexture.index, from);
    material.roughness = std::clamp(pbr.roughnessFactor, 0.0, 1.0);
    material.metalness = std::clamp(pbr.metallicFactor, 0.0, 1.0);
    if (pbr.metallicRoughnessTexture.index >= 0) {
      const std::array<double, 3> both = mean(pbr.metallicRoughnessTexture.index, true);
      material.roughness *= both[1];
      material.metalness *= both[2];
    }
    material.two_sided = from.doubleSided;
    material.glow = glow_of(from);
    if (from.extensions.contains("KHR_materials_unlit")) material.glow = material.color;
    return material;
  }

  Color glow_of(const tinygltf::Material& from) {
    std::vector<double> light = from.emissiveFactor;
    if (light.size() != 3) return {0, 0, 0, 1};
    const double strength = extension_number(from, "KHR_materials_emissive_strength", "emissiveStrength", 1);
    const bool dark = light[0] == 0 && light[1] == 0 && light[2] == 0;
    const std::array<double, 3> share = dark || from.emissiveTexture.index < 0 ? std::array<double, 3>{1, 1, 1} : mean(from.emissiveTexture.index, false);
    for (std::size_t c = 0; c < 3; ++c) light[c] = std::clamp(light[c] * strength * share[c], 0.0, 100.0);
    return color_of(light, {0, 0, 0, 1});
  }
};

}  // namespace

void add_materials(GltfFile& file, Model& model) {
  Materials materials{file, model, 0, {}, {}};
  for (const tinygltf::Material& material : file.records->materials) model.materials.push_back(materials.convert(material));
  model.materials.emplace_back();
}

int uv_set(const tinygltf::Model& records, int material) {
  if (material < 0 || static_cast<std::size_t>(material) >= records.materials.size()) return 0;
  return records.materials[static_cast<std::size_t>(material)].pbrMetallicRoughness.baseColorTexture.texCoord;
}

}  // namespace tumble
