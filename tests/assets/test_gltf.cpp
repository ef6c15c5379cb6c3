#include "assets/gltf.h"

#include <catch2/catch.hpp>
#include <map>

#include "assets/gltf_writer.h"
#include "base/error.h"

using namespace tumble;

namespace {

using OtherFiles = std::map<std::string, std::string>;

Model read(const std::string& bytes, const std::string& name = "models/cube.glb", const OtherFiles& others = {}) {
  return read_model(bytes, name, [&](const std::string& path) -> std::optional<std::string> {
    const auto found = others.find(path);
    return found == others.end() ? std::nullopt : std::optional(found->second);
  });
}

// By the divergence theorem: what closed triangles enclose, negative where they face inwards.
double volume(const std::vector<Vec3>& triangles) {
  double sum = 0;
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) sum += dot(triangles[i], cross(triangles[i + 1], triangles[i + 2])) / 6;
  return sum;
}

double area(const std::vector<Vec3>& triangles) {
  double sum = 0;
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3)
    sum += length(cross(triangles[i + 1] - triangles[i], triangles[i + 2] - triangles[i])) / 2;
  return sum;
}

ModelPose pose_at(const Model& model, const char* clip, double time, const char* node) {
  ModelPose pose;
  const ModelClip* found = find_clip(model, clip);
  REQUIRE(found);
  for (const ModelTrack& track : found->tracks)
    if (model.nodes[static_cast<std::size_t>(track.node)].name == node) sample(track, time, pose);
  return pose;
}

// One mesh of these triangles on one node, which is `node` but for its mesh.
std::string one_mesh(const std::vector<float>& positions, const std::string& more, const std::string& node = "") {
  GltfWriter writer;
  add(writer.meshes, R"({"primitives": [{"attributes": {"POSITION": )" + std::to_string(writer.numbers(positions, "VEC3")) + "}" + more + "}]}");
  add(writer.nodes, R"({"mesh": 0)" + node + "}");
  return writer.glb();
}

constexpr float kFloat = 1e-6f;

}  // namespace

TEST_CASE("gltf: nodes come parents first, with the places of the file", "[assets]") {
  const Model model = read(cube_glb());

  REQUIRE(model.nodes.size() == 2);
  CHECK(model.nodes[0].name == "base");
  CHECK(model.nodes[1].name == "lid");
  CHECK(model.nodes[1].parent == 0);
  CHECK(model.nodes[1].place.position == Vec3{0, 2, 0});
  // A cube of 1 m about the origin and one 2 m above.
  CHECK(model.low == Vec3{-0.5, -0.5, -0.5});
  CHECK(model.high == Vec3{0.5, 2.5, 0.5});
  CHECK(volume(triangles_of(model)) == Approx(2));
  CHECK(model.notes.empty());
}

TEST_CASE("gltf: a mesh is a part for each material and node", "[assets]") {
  const Model model = read(cube_glb());

  REQUIRE(model.parts.size() == 4);
  CHECK(model.parts[0].mesh.triangles.size() == 18);
  CHECK(model.parts[0].node != model.parts[2].node);
  const ModelMaterial& red = model.materials.at(static_cast<std::size_t>(model.parts[0].material));
  // Light of one half is 0.7354 on the sRGB curve.
  CHECK(red.color.r == Approx(0.735357).epsilon(1e-5));
  CHECK(red.color.g == 0);
  CHECK(red.roughness == 0.25);
  CHECK(red.metalness == 0.75);
  CHECK(red.two_sided);
  CHECK(red.image == -1);
  CHECK(red.glow.g == Approx(0.735357).epsilon(1e-5));
  const ModelMaterial& pictured = model.materials.at(static_cast<std::size_t>(model.parts[1].material));
  REQUIRE(pictured.image == 0);
  CHECK(model.images.at(0).pixels == std::vector<std::uint8_t>{255, 0, 0, 255, 0, 0, 255, 255});
  CHECK_FALSE(pictured.two_sided);
}

TEST_CASE("gltf: clips move along lines, steps and cubic curves", "[assets]") {
  const Model model = read(cube_glb());

  CHECK(find_clip(model, "")->name == "open");
  CHECK(find_clip(model, "open")->seconds == 1);
  CHECK(find_clip(model, "shut") == nullptr);
  CHECK(pose_at(model, "open", 0.25, "lid").position == Vec3{0.5, 2, 0});
  CHECK(pose_at(model, "open", -1, "lid").position == Vec3{0, 2, 0});
  CHECK(pose_at(model, "open", 9, "lid").position == Vec3{2, 2, 0});
  for (const double t : {0.0, 0.3, 0.5, 0.9, 1.0})  // the cubic that its ends and slopes determine
    CHECK(pose_at(model, "bounce", t, "lid").position.y == Approx(2 + t * t * t - 3 * t * t + 3 * t).epsilon(1e-6));
}

TEST_CASE("gltf: a rotation between two keys is on the arc between them", "[assets]") {
  GltfWriter writer = cube_writer();
  const float half = static_cast<float>(std::sqrt(0.5));
  const std::string in = std::to_string(writer.numbers({0, 2}, "SCALAR")), out = std::to_string(writer.numbers({0, 0, 0, 1, 0, half, 0, half}, "VEC4"));
  add(writer.animations, R"({"name": "turn", "channels": [{"sampler": 0, "target": {"node": 1, "path": "rotation"}}], "samplers": [{"input": )" + in + R"(, "output": )" + out + "}]}");
  const Model model = read(writer.glb());

  // A quarter turn about y in 2 s: after 0.5 s by 22.5 degrees.
  const Vec3 ahead = pose_at(model, "turn", 0.5, "base").rotation * Vec3{0, 0, 1};
  CHECK(distance(ahead, {std::sin(radians(22.5)), 0, std::cos(radians(22.5))}) < kFloat);
  const std::vector<ModelPlace> moved = places(model, model, *find_clip(model, "turn"), 2);
  CHECK(distance(moved[1].point({1, 0, 0}), {0, 2, -1}) < kFloat);  // the lid goes along
}

TEST_CASE("gltf: a text finds its bytes and pictures beside it or in itself", "[assets]") {
  GltfWriter writer = cube_writer();
  writer.images = R"({"uri": "../pictures/red%20blue.png"})";
  const std::string picture = png(1, 1, {9, 8, 7});
  const OtherFiles others = {{"models/cube.bin", writer.bin()}, {"pictures/red blue.png", picture}};

  const Model model = read(writer.gltf("cube.bin"), "models/cube.gltf", others);
  CHECK(volume(triangles_of(model)) == Approx(2));
  CHECK(model.images.at(0).pixels == std::vector<std::uint8_t>{9, 8, 7, 255});

  writer.images = R"({"uri": "data:image/png;base64,)" + base64(picture) + R"("})";
  CHECK(read(writer.gltf(), "cube.gltf").images.at(0).pixels == std::vector<std::uint8_t>{9, 8, 7, 255});
}

TEST_CASE("gltf: a picture that is missing is pink and noted", "[assets]") {
  GltfWriter writer = cube_writer();
  writer.images = R"({"uri": "../../outside.png"})";
  const Model model = read(writer.glb());

  CHECK(model.images.at(0).pixels == std::vector<std::uint8_t>{255, 0, 255, 255});
  REQUIRE(model.notes.size() == 1);
  CHECK_THAT(model.notes[0], Catch::Contains("../../outside.png") && Catch::Contains("not in the game") && Catch::Contains("pink"));
}

TEST_CASE("gltf: triangles without normals get flat ones, in strips and fans too", "[assets]") {
  // A square of 2 m in the ground, facing up.
  const std::vector<float> zigzag = {0, 0, 0, 0, 0, 2, 2, 0, 0, 2, 0, 2}, round = {0, 0, 0, 0, 0, 2, 2, 0, 2, 2, 0, 0};
  for (const std::string& bytes : {one_mesh(zigzag, R"(, "mode": 5)"), one_mesh(round, R"(, "mode": 6)")}) {
    const Model model = read(bytes);
    CHECK(area(triangles_of(model)) == Approx(4));
    for (const Vertex& vertex : model.parts.at(0).mesh.vertices) CHECK(vertex.normal == std::array<float, 3>{0, 1, 0});
  }
  CHECK(read(one_mesh(zigzag, R"(, "mode": 6)")).notes.empty());
}

TEST_CASE("gltf: a mirrored node's triangles still face outwards", "[assets]") {
  GltfWriter writer = cube_writer();
  writer.nodes = R"({"mesh": 0, "matrix": [-2, 0, 0, 0,  0, 3, 0, 0,  0, 0, 4, 0,  5, 6, 7, 1]})";
  writer.animations.clear();
  const Model model = read(writer.glb());

  CHECK(volume(triangles_of(model)) == Approx(24));
  CHECK(model.low == Vec3{4, 4.5, 5});
  CHECK(model.high == Vec3{6, 7.5, 9});
}

TEST_CASE("gltf: a matrix of a turn and a stretch is taken apart into them", "[assets]") {
  const Quat turn = axis_angle({1, 2, 3}, 0.7);
  const Vec3 x = turn * Vec3{2, 0, 0}, y = turn * Vec3{0, 3, 0}, z = turn * Vec3{0, 0, 4};
  std::string matrix;
  for (const double v : {x.x, x.y, x.z, 0.0, y.x, y.y, y.z, 0.0, z.x, z.y, z.z, 0.0, 1.0, 2.0, 3.0, 1.0}) add(matrix, std::to_string(v));
  const ModelPose rest = read(one_mesh({0, 0, 0, 1, 0, 0, 0, 1, 0}, "", R"(, "matrix": [)" + matrix + "]")).nodes.at(0).rest;

  CHECK(distance(rest.scale, {2, 3, 4}) < 1e-5);  // six decimals of text
  CHECK(std::abs(dot(rest.rotation, turn)) == Approx(1).epsilon(1e-6));
  CHECK(rest.position == Vec3{1, 2, 3});
}

TEST_CASE("gltf: rows that a file keeps apart are put in place", "[assets]") {
  GltfWriter writer;
  const int base = writer.view(std::string(36, '\0'));  // three corners at the origin
  const int rows = writer.view({1, 0, 2, 0});           // the second and the third differ
  const int values = writer.numbers({3, 0, 0, 0, 0, -5}, "VEC3");
  writer.accessors = R"({"bufferView": )" + std::to_string(base) + R"(, "componentType": 5126, "type": "VEC3", "count": 3, "sparse": {"count": 2, "indices": {"bufferView": )" +
                     std::to_string(rows) + R"(, "componentType": 5123}, "values": {"bufferView": )" + std::to_string(values + 2) + "}}}";
  add(writer.meshes, R"({"primitives": [{"attributes": {"POSITION": 0}}]})");
  add(writer.nodes, R"({"mesh": 0})");

  CHECK(triangles_of(read(writer.glb())) == std::vector<Vec3>{{0, 0, 0}, {3, 0, 0}, {0, 0, -5}});
}

TEST_CASE("gltf: whole numbers stand for fractions where the file says so", "[assets]") {
  GltfWriter writer;
  const int view = writer.view(std::string("\x00\x00\x00\x00\xff\x00\x00\x00\x00\xff\x00\x00", 12));  // bytes, each row filled up to four
  writer.accessors = R"({"bufferView": )" + std::to_string(view) + R"(, "componentType": 5121, "normalized": true, "type": "VEC3", "count": 3})";
  writer.extra = "";
  add(writer.meshes, R"({"primitives": [{"attributes": {"POSITION": 0}}]})");
  add(writer.nodes, R"({"mesh": 0})");
  std::string bytes = writer.gltf();
  bytes.replace(bytes.rfind(R"("byteLength": 12})"), 17, R"("byteStride": 4, "byteLength": 12})");

  CHECK(triangles_of(read(bytes)) == std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
}

TEST_CASE("gltf: what is not drawn is said, and the rest is there", "[assets]") {
  GltfWriter writer = cube_writer();
  writer.extra = R"(, "skins": [{"joints": [0]}])";
  writer.nodes = R"({"mesh": 0, "skin": 0})";
  writer.animations.clear();
  const Model model = read(writer.glb());

  CHECK(model.parts.size() == 2);
  REQUIRE(model.notes.size() == 1);
  CHECK_THAT(model.notes[0], Catch::Contains("bones"));
}
