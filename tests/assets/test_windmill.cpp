// The model of games/samples/models. It is made here: `tumble_tests "[make]"` writes it anew.
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <iterator>

#include "assets/gltf.h"
#include "assets/gltf_writer.h"
#include "support/source_tree.h"

using namespace tumble;

namespace {

const char* const kFile = "games/samples/models/windmill.glb";

// Rows of bricks, every other one shifted by half a brick.
std::string bricks() {
  std::vector<std::uint8_t> pixels;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      const int row = y / 16, column = (x + (row % 2) * 16) / 32 % 2;
      const bool joint = y % 16 < 2 || (x + (row % 2) * 16) % 32 < 2;
      const int shade = joint ? 235 : 205 + 8 * ((row * 3 + column * 5) % 4) - (x * 7 + y * 13) % 9;
      pixels.insert(pixels.end(), {static_cast<std::uint8_t>(shade), static_cast<std::uint8_t>(shade - (joint ? 8 : 30)), static_cast<std::uint8_t>(shade - (joint ? 20 : 55))});
    }
  return png(64, 64, pixels);
}

Shape box(Vec3 size) {
  Shape shape;
  shape.size = size;
  return shape;
}

Shape round(ShapeKind kind, double radius, double height) {
  Shape shape;
  shape.shape = kind;
  shape.radius = radius;
  shape.height = height;
  return shape;
}

// A tower that is narrower above, the picture four times around it and three times up.
Mesh tower() {
  Mesh mesh = make_mesh(round(ShapeKind::cylinder, 1.2, 5));
  for (Vertex& vertex : mesh.vertices) {
    auto& [x, y, z] = vertex.position;
    const float turn = std::atan2(x, z) / static_cast<float>(2 * kPi);
    vertex.uv = {4 * turn, 3 * (0.5f - y / 5)};
    const float narrow = 1 - 0.3f * (y / 5 + 0.5f);
    x *= narrow;
    z *= narrow;
  }
  return mesh;
}

std::string material(const char* color, double roughness, const std::string& more = "") {
  return std::string(R"({"pbrMetallicRoughness": {"baseColorFactor": [)") + color + R"(, 1], "metallicFactor": 0, "roughnessFactor": )" + std::to_string(roughness) + more + "}}";
}

std::string windmill() {
  GltfWriter writer;
  add(writer.textures, R"({"source": )" + std::to_string(writer.image(bricks())) + "}");
  add(writer.materials, material("1, 1, 1", 0.9, R"(, "baseColorTexture": {"index": 0})"));
  add(writer.materials, material("0.42, 0.07, 0.04", 0.6));  // roof
  add(writer.materials, material("0.16, 0.08, 0.03", 0.7));  // wood
  add(writer.materials, material("0.85, 0.8, 0.65", 0.9));   // cloth
  const auto mesh = [&](const Mesh& mesh, int material) { add(writer.meshes, R"({"primitives": [)" + writer.primitive(mesh, material) + "]}"); };
  mesh(tower(), 0);
  mesh(make_mesh(round(ShapeKind::cone, 1.15, 1.4)), 1);
  mesh(make_mesh(box({0.7, 1.4, 0.2})), 2);
  mesh(make_mesh(round(ShapeKind::cylinder, 0.2, 0.7)), 2);
  mesh(make_mesh(box({0.12, 5.6, 0.12})), 2);
  mesh(make_mesh(box({0.7, 2.1, 0.05})), 3);

  const std::string quarter = "0, 0, 0.70710678, 0.70710678", lying = "0.70710678, 0, 0, 0.70710678";
  add(writer.nodes, R"({"name": "windmill", "children": [1, 2, 3, 4]})");
  add(writer.nodes, R"({"name": "tower", "mesh": 0, "translation": [0, 2.5, 0]})");
  add(writer.nodes, R"({"name": "roof", "mesh": 1, "translation": [0, 5.7, 0]})");
  add(writer.nodes, R"({"name": "door", "mesh": 2, "translation": [0, 0.7, 1.08]})");
  add(writer.nodes, R"({"name": "blades", "translation": [0, 4.6, 1.25], "children": [5, 6, 7, 8, 9, 10, 11]})");
  add(writer.nodes, R"({"mesh": 3, "rotation": [)" + lying + R"(], "translation": [0, 0, -0.2]})");
  add(writer.nodes, R"({"mesh": 4})");
  add(writer.nodes, R"({"mesh": 4, "rotation": [)" + quarter + "]}");
  for (const char* sail : {R"("translation": [0.4, 1.65, 0])", R"("translation": [-0.4, -1.65, 0])"}) add(writer.nodes, R"({"mesh": 5, )" + std::string(sail) + "}");
  for (const char* sail : {R"("translation": [-1.65, 0.4, 0])", R"("translation": [1.65, -0.4, 0])"})
    add(writer.nodes, R"({"mesh": 5, "rotation": [)" + quarter + "], " + sail + "}");

  // A full turn against the clock in 8 s; four keys a turn, since between two keys the shorter way is taken.
  std::vector<float> times, turns;
  for (int i = 0; i <= 4; ++i) {
    const double half = i * kPi / 4;
    times.push_back(static_cast<float>(2 * i));
    turns.insert(turns.end(), {0, 0, static_cast<float>(std::sin(half)), static_cast<float>(std::cos(half))});
  }
  const std::string input = std::to_string(writer.numbers(times, "SCALAR")), output = std::to_string(writer.numbers(turns, "VEC4"));
  add(writer.animations, R"({"name": "turn", "channels": [{"sampler": 0, "target": {"node": 4, "path": "rotation"}}], "samplers": [{"input": )" + input + R"(, "output": )" + output + "}]}");
  return writer.glb();
}

}  // namespace

TEST_CASE("windmill: write the sample's model", "[.][make]") {
  std::ofstream(source_tree() / kFile, std::ios::binary) << windmill();
}

TEST_CASE("windmill: the sample's blades turn once in eight seconds", "[assets]") {
  std::ifstream in(source_tree() / kFile, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(in)), {});
  const Model model = read_model(bytes, kFile, [](const std::string&) { return std::nullopt; });

  REQUIRE(find_clip(model, "turn"));
  CHECK(find_clip(model, "turn")->seconds == 8);
  int blades = 0;
  while (model.nodes.at(static_cast<std::size_t>(blades)).name != "blades") ++blades;
  // A point above the axis is to the left of it after a quarter turn.
  const ModelPlace place = places(model, model, *find_clip(model, "turn"), 2)[static_cast<std::size_t>(blades)];
  CHECK(distance(place.point({0, 1, 0}), {-1, 4.6, 1.25}) < 1e-6);
  CHECK(model.images.size() == 1);
}
