// Files from anybody: every loader either reads a file or says in a sentence why not, whatever the bytes are.
#include <catch2/catch.hpp>
#include <functional>
#include <random>

#include "assets/gltf.h"
#include "assets/gltf_writer.h"
#include "assets/library.h"
#include "base/error.h"
#include "engine/scene_file.h"
#include "engine/settings.h"

using namespace tumble;

namespace {

using Load = std::function<void(const std::string& bytes)>;

// What the loader says, "" where it takes the file; anything but an Error fails the test.
std::string said(const Load& load, const std::string& bytes) {
  try {
    load(bytes);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

// Cut off after every `step` bytes, and with bytes changed in `rounds` ways that are the same in every run.
void damage(const std::string& good, const Load& load, std::size_t step, int rounds) {
  REQUIRE(said(load, good) == "");
  for (std::size_t size = 0; size < good.size(); size += step) said(load, good.substr(0, size));
  std::mt19937 random(20240607);
  for (int round = 0; round < rounds; ++round) {
    std::string bad = good;
    for (int i = 0; i <= round % 8; ++i) bad[random() % bad.size()] = static_cast<char>(random() & 255);
    said(load, bad);
  }
  SUCCEED("no crash, and nothing but sentences");
}

const Load load_model = [](const std::string& bytes) { read_model(bytes, "bad.glb", [](const std::string&) { return std::nullopt; }); };
const Load load_picture = [](const std::string& bytes) { read_image(bytes, "bad.png"); };
const Load load_scene = [](const std::string& bytes) {
  load_scene_file("bad", [&](const std::string&) { return std::optional(bytes); }, "scene.load");
};
const Load load_settings = [](const std::string& bytes) { read_settings(bytes, "game.json"); };

std::string many(const std::string& text, int count) {
  std::string all;
  for (int i = 0; i < count; ++i) all += text;
  return all;
}

// The cube with a piece of its text replaced.
std::string changed_cube(const std::string& from, const std::string& to) {
  std::string text = cube_writer().gltf();
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

std::vector<std::uint8_t> checkers() {
  std::vector<std::uint8_t> pixels;
  for (int i = 0; i < 32 * 32 * 3; ++i) pixels.push_back(static_cast<std::uint8_t>(i * i));
  return pixels;
}

}  // namespace

TEST_CASE("bad files: a damaged .glb is a sentence or a model", "[assets][bad]") { damage(cube_glb(), load_model, 64, 1500); }
TEST_CASE("bad files: a damaged .gltf is a sentence or a model", "[assets][bad]") { damage(cube_writer().gltf(), load_model, 64, 1500); }
TEST_CASE("bad files: a damaged picture is a sentence or a picture", "[assets][bad]") { damage(png(32, 32, checkers()), load_picture, 16, 1500); }

TEST_CASE("bad files: a picture too small for the pixels that it claims is refused before they get memory", "[assets][bad]") {
  std::string bytes = png(32, 32, checkers());
  bytes[18] = 0x20;  // the width's and the height's second byte: 8192
  bytes[19] = 0;
  bytes[22] = 0x20;
  bytes[23] = 0;
  CHECK_THAT(said(load_picture, bytes), Catch::Contains("ends before its pixels do"));
}

TEST_CASE("bad files: a damaged scene is a sentence or a scene", "[assets][bad]") {
  damage(R"({"tumble": 1, "children": [{"name": "crate", "position": [0, 2, 0], "mesh": {"shape": "box", "size": [1, 2, 1]}, "body": {"mass": 5},
             "joints": [{"type": "hinge", "b": "frame"}]}, {"name": "frame", "body": "static", "mesh": "box", "material": {"color": "#aabbcc"}}]})",
         load_scene, 8, 1500);
}

TEST_CASE("bad files: damaged settings are a sentence or settings", "[assets][bad]") {
  damage(R"({"title": "Ball", "tick_rate": 60, "window": {"width": 800, "height": 600}, "physics": {"gravity": [0, -9.81, 0]}, "actions": {"jump": ["space"]}})",
         load_settings, 8, 1500);
}

TEST_CASE("bad files: a model's sentence names the file, what is wrong and the way out", "[assets][bad]") {
  const auto check = [](const std::string& bytes, const std::string& part) {
    const std::string text = said(load_model, bytes);
    CAPTURE(text, part);
    CHECK(text.find("'bad.glb'") != std::string::npos);
    CHECK(text.find(part) != std::string::npos);
    CHECK(text.find(';') != std::string::npos);
  };
  check("", "it is empty");
  check("hello", "neither a .glb nor the text of a .gltf");
  check("[1, 2]", "no table");
  check("glTF", "ends within its header");
  check(cube_glb().substr(0, 500), "it says that it has");
  check(many("[", 100000), "nests deeper");
  check(R"({"a": )" + many(R"({"a": )", 100) + "1" + many("}", 101), "nests deeper");
  check(R"({"nodes": []})", "\"asset\"");
  check(R"({"asset": {"version": "2.0"}})", "neither triangles nor clips");
  check(changed_cube(R"("asset")", R"("extensionsRequired": ["KHR_draco_mesh_compression"], "asset")"), "KHR_draco_mesh_compression");
  check(changed_cube("\"mesh\": 0", "\"mesh\": 7"), "mesh 7 of 1");
  check(changed_cube("\"material\": 0", "\"material\": 70000"), "material 70000");
  check(changed_cube("\"children\": [0]", "\"children\": [0, 0]"), "node 0 hangs in two places");
  check(changed_cube("\"children\": [0]", "\"children\": [0, 99]"), "node 99 of 2");
  check(changed_cube("\"POSITION\": 0", "\"POSITION\": 12345"), "accessor 12345");
  check(changed_cube("\"count\": 24", "\"count\": 240"), "runs past its bytes");
  check(changed_cube("\"count\": 24", "\"count\": 18446744073709551615"), "18446744073709551615 entries");
  check(changed_cube("\"componentType\": 5126", "\"componentType\": 5130"), "unknown kind");
  check(changed_cube("\"byteLength\": 288}", "\"byteLength\": 99288}"), "runs past the end");
  check(changed_cube("\"byteLength\": 288}", "\"byteLength\": 18446744073709551615}"), "runs past the end");
  check(changed_cube("data:application/octet-stream;base64,", "data:,"), "not base64");
  check(changed_cube("data:application/octet-stream;base64,", "../../../etc/passwd?"), "not in the game");
  check(changed_cube("\"translation\": [0, 2, 0]", "\"translation\": [0, 2]"), "translation is not 3");
}

TEST_CASE("bad files: a triangle that wants a vertex that is not there is refused", "[assets][bad]") {
  GltfWriter writer;
  Mesh mesh = make_mesh({});
  mesh.triangles[4] = 24;
  add(writer.meshes, R"({"primitives": [)" + writer.primitive(mesh, -1) + "]}");
  add(writer.nodes, R"({"mesh": 0})");
  CHECK_THAT(said(load_model, writer.glb()), Catch::Contains("wants vertex 24 of 24"));
}

TEST_CASE("bad files: a few bytes cannot become a huge model", "[assets][bad]") {
  // Two hundred thousand nodes that each show a mesh: refused for their number; fewer for their vertices.
  GltfWriter writer = cube_writer();
  writer.animations.clear();
  writer.nodes = "{}" + many(", {}", 200'000);
  CHECK_THAT(said(load_model, writer.glb()), Catch::Contains("200001 nodes"));
  writer.nodes = R"({"mesh": 0})" + many(R"(, {"mesh": 0})", 99'000);
  CHECK_THAT(said(load_model, writer.glb()), Catch::Contains("more than 4000000 vertices"));

  // A buffer that every one of many others would copy.
  std::string text = cube_writer().gltf("a.bin");
  CHECK_THAT(said(load_model, text.replace(text.find("\"buffers\": ["), 12, "\"buffers\": [" + many("{\"byteLength\": 8}, ", 300))), Catch::Contains("at most 256"));
}

TEST_CASE("bad files: the library says what is wrong once, with the nearest name, and answers nothing", "[assets][bad]") {
  std::vector<std::string> log;
  std::map<std::string, std::string> files = {{"models/tree.glb", "no model"}, {"bark.png", "no picture"}};
  AssetLibrary library(
      [&](const std::string& path) -> std::optional<std::string> {
        const auto found = files.find(path);
        return found == files.end() ? std::nullopt : std::optional(found->second);
      },
      [&](const LogLine& line) { log.push_back(line.text); }, [&] { return std::vector<std::string>{"models/tree.glb", "bark.png"}; });

  for (int i = 0; i < 3; ++i) {
    CHECK(library.model("models/tre.glb") == nullptr);
    CHECK(library.model("models/tree.glb") == nullptr);
    CHECK(library.image("bark.png") == nullptr);
    CHECK(library.model("../tree.glb") == nullptr);
  }

  REQUIRE(log.size() == 4);
  CHECK_THAT(log[0], Catch::Contains("no file 'models/tre.glb'") && Catch::Contains("did you mean 'models/tree.glb'") && Catch::Contains("pink box"));
  CHECK_THAT(log[1], Catch::Contains("'models/tree.glb'") && Catch::Contains("neither a .glb"));
  CHECK_THAT(log[2], Catch::Contains("'bark.png'") && Catch::Contains("pink"));
  CHECK_THAT(log[3], Catch::Contains("'..' is not allowed"));

  files["models/tree.glb"] = cube_glb();
  CHECK(library.forget("models/tree.glb") == std::vector<std::string>{"models/tree.glb"});
  CHECK(library.model("models/tree.glb") != nullptr);
  CHECK(library.version("models/tree.glb") == 1);
  CHECK(library.forget("main.lua").empty());
}

TEST_CASE("bad files: saving what lies beside a model is saving the model", "[assets]") {
  GltfWriter writer = cube_writer();
  std::map<std::string, std::string> files = {{"a/cube.gltf", writer.gltf("cube.bin")}};
  AssetLibrary library(
      [&](const std::string& path) -> std::optional<std::string> {
        const auto found = files.find(path);
        return found == files.end() ? std::nullopt : std::optional(found->second);
      },
      {});
  CHECK(library.model("a/cube.gltf") == nullptr);
  files["a/cube.bin"] = writer.bin();

  CHECK(library.forget("a/cube.bin") == std::vector<std::string>{"a/cube.gltf"});

  CHECK(library.model("a/cube.gltf") != nullptr);
}
