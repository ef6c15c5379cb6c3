#include "assets/gltf_writer.h"

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "render/renderer.h"

using namespace tumble;

namespace {

std::string word(std::uint32_t value) {
  std::string bytes;
  for (int i = 0; i < 4; ++i) bytes += static_cast<char>(value >> 8 * i & 255);
  return bytes;
}

std::string padded(std::string bytes, char with) {
  while (bytes.size() % 4 != 0) bytes += with;
  return bytes;
}

}  // namespace

void add(std::string& list, const std::string& entry) { list += (list.empty() ? "" : ", ") + entry; }

int GltfWriter::view(const std::string& bytes) {
  add(views_, R"({"buffer": 0, "byteOffset": )" + std::to_string(bytes_.size()) + R"(, "byteLength": )" + std::to_string(bytes.size()) + "}");
  bytes_ += padded(bytes, '\0');
  return view_count_++;
}

int GltfWriter::numbers(const std::vector<float>& values, const std::string& type) {
  std::string bytes(values.size() * sizeof(float), '\0');
  std::memcpy(bytes.data(), values.data(), bytes.size());
  const std::size_t width = type == "SCALAR" ? 1 : static_cast<std::size_t>(type[3] - '0');
  add(accessors, R"({"bufferView": )" + std::to_string(view(bytes)) + R"(, "componentType": 5126, "type": ")" + type + R"(", "count": )" +
                     std::to_string(values.size() / width) + "}");
  return accessor_count_++;
}

int GltfWriter::indices(const std::vector<std::uint32_t>& values) {
  std::string bytes;
  for (const std::uint32_t value : values) bytes += {static_cast<char>(value & 255), static_cast<char>(value >> 8)};
  add(accessors, R"({"bufferView": )" + std::to_string(view(bytes)) + R"(, "componentType": 5123, "type": "SCALAR", "count": )" + std::to_string(values.size()) + "}");
  return accessor_count_++;
}

int GltfWriter::image(const std::string& bytes) {
  add(images, R"({"mimeType": "image/png", "bufferView": )" + std::to_string(view(bytes)) + "}");
  return image_count_++;
}

std::string GltfWriter::primitive(const Mesh& mesh, int material, std::size_t first, std::size_t count) {
  std::vector<float> positions, normals, uvs;
  for (const Vertex& vertex : mesh.vertices) {
    positions.insert(positions.end(), vertex.position.begin(), vertex.position.end());
    normals.insert(normals.end(), vertex.normal.begin(), vertex.normal.end());
    uvs.insert(uvs.end(), vertex.uv.begin(), vertex.uv.end());
  }
  const auto begin = mesh.triangles.begin() + static_cast<std::ptrdiff_t>(3 * first);
  const std::vector<std::uint32_t> triangles(begin, count == 0 ? mesh.triangles.end() : begin + static_cast<std::ptrdiff_t>(3 * count));
  const int at = numbers(positions, "VEC3"), normals_at = numbers(normals, "VEC3"), uvs_at = numbers(uvs, "VEC2"), indices_at = indices(triangles);
  return R"({"attributes": {"POSITION": )" + std::to_string(at) + R"(, "NORMAL": )" + std::to_string(normals_at) + R"(, "TEXCOORD_0": )" + std::to_string(uvs_at) +
         R"(}, "indices": )" + std::to_string(indices_at) + (material < 0 ? "" : R"(, "material": )" + std::to_string(material)) + "}";
}

std::string GltfWriter::json(const std::string& buffer) const {
  std::string text = R"({"asset": {"version": "2.0"}, "buffers": [{)" + buffer + R"("byteLength": )" + std::to_string(bytes_.size()) + "}]";
  for (const auto& [name, list] : {std::pair{"bufferViews", &views_}, {"accessors", &accessors}, {"nodes", &nodes}, {"meshes", &meshes},
                                   {"materials", &materials}, {"textures", &textures}, {"images", &images}, {"animations", &animations}})
    if (!list->empty()) text += std::string(", \"") + name + "\": [" + *list + "]";
  return text + extra + "}";
}

std::string GltfWriter::glb() const {
  const std::string text = padded(json(""), ' '), binary = padded(bytes_, '\0');
  std::string chunks = word(static_cast<std::uint32_t>(text.size())) + "JSON" + text;
  if (!binary.empty()) chunks += word(static_cast<std::uint32_t>(binary.size())) + std::string("BIN\0", 4) + binary;
  return "glTF" + word(2) + word(static_cast<std::uint32_t>(12 + chunks.size())) + chunks;
}

std::string GltfWriter::gltf(const std::string& bin_name) const {
  const std::string uri = bin_name.empty() ? "data:application/octet-stream;base64," + base64(bytes_) : bin_name;
  return json(R"("uri": ")" + uri + R"(", )");
}

std::string base64(const std::string& bytes) {
  constexpr char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k) three = three << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0);
    for (std::size_t k = 0; k < 4; ++k) text += i + k > bytes.size() ? '=' : letters[three >> (18 - 6 * k) & 63];
  }
  return text;
}

std::string png(int width, int height, const std::vector<std::uint8_t>& rgb) {
  const auto file = std::filesystem::temp_directory_path() / "tumble_test_gltf.png";
  write_png({width, height, rgb}, file.string());
  std::ifstream in(file, std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(in)), {});
  std::filesystem::remove(file);
  return bytes;
}

GltfWriter cube_writer() {
  GltfWriter writer;
  const Mesh cube = make_mesh({});
  const int picture = writer.image(png(2, 1, {255, 0, 0, 0, 0, 255}));
  add(writer.textures, R"({"source": )" + std::to_string(picture) + "}");
  add(writer.materials, R"({"doubleSided": true, "emissiveFactor": [0, 0.5, 0], "pbrMetallicRoughness": {"baseColorFactor": [0.5, 0, 0, 1], "roughnessFactor": 0.25, "metallicFactor": 0.75}})");
  add(writer.materials, R"({"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, "metallicFactor": 0}})");
  const std::string first = writer.primitive(cube, 0, 0, 6), second = writer.primitive(cube, 1, 6, 6);
  add(writer.meshes, R"({"primitives": [)" + first + ", " + second + "]}");
  add(writer.nodes, R"({"name": "lid", "mesh": 0, "translation": [0, 2, 0]})");  // before its parent: any order is allowed
  add(writer.nodes, R"({"name": "base", "mesh": 0, "children": [0]})");
  const auto clip = [&](const char* name, const char* interpolation, int times, int values) {
    add(writer.animations, std::string(R"({"name": ")") + name + R"(", "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}], "samplers": [{"input": )" +
                               std::to_string(times) + R"(, "output": )" + std::to_string(values) + R"(, "interpolation": ")" + interpolation + R"("}]})");
  };
  const int times = writer.numbers({0, 1}, "SCALAR");
  clip("open", "LINEAR", times, writer.numbers({0, 2, 0, 2, 2, 0}, "VEC3"));
  // Height 2 + t^3 - 3 t^2 + 3 t: begins at 2 with slope 3, ends at 3 with slope 0.
  clip("bounce", "CUBICSPLINE", times, writer.numbers({0, 0, 0, 0, 2, 0, 0, 3, 0, 0, 0, 0, 0, 3, 0, 0, 0, 0}, "VEC3"));
  return writer;
}

std::string cube_glb() { return cube_writer().glb(); }
