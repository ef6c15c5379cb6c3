// Writes small glTF files with content that tests know.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "assets/mesh.h"

// Bytes go into one buffer; all else is JSON that the test writes, with the numbers that these functions return.
class GltfWriter {
 public:
  // Accessors: "VEC3" of floats, indices of 16 bits.
  int numbers(const std::vector<float>& values, const std::string& type);
  int indices(const std::vector<std::uint32_t>& values);
  // An image, by its file's bytes in the buffer.
  int image(const std::string& bytes);
  int view(const std::string& bytes);

  // Lists of JSON objects: nodes += R"({"mesh": 0})"; further ones after a comma.
  std::string nodes, meshes, materials, textures, images, animations, accessors, extra;

  // One primitive of a mesh; triangles from ... to of it, all where `count` is 0.
  std::string primitive(const tumble::Mesh& mesh, int material, std::size_t first = 0, std::size_t count = 0);

  std::string glb() const;
  // The text beside which `bin()` lies under that name, or which holds it, where there is no name.
  std::string gltf(const std::string& bin_name = "") const;
  const std::string& bin() const { return bytes_; }

 private:
  std::string json(const std::string& buffer) const;

  std::string bytes_, views_;
  int view_count_ = 0, accessor_count_ = 0, image_count_ = 0;
};

// Adds to a list with commas between.
void add(std::string& list, const std::string& entry);
std::string base64(const std::string& bytes);
// The bytes of a PNG of one colour, or of these pixels (RGB).
std::string png(int width, int height, const std::vector<std::uint8_t>& rgb);

// A cube of 1 m about `base`'s origin, its first six triangles red, the others with a picture of 2 x 1 pixels; `lid`
// hangs 2 m above and holds the same cube. `open` moves the lid 2 m along x in 1 s, `bounce` along a cubic curve.
std::string cube_glb();
GltfWriter cube_writer();
