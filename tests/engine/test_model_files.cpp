// Models in a scene: drawn part by part, framed, and as colliders.
#include "assets/gltf_writer.h"
#include "engine/camera.h"
#include "engine/extract.h"
#include "test_engine_support.h"

using namespace tumble;

namespace {

constexpr double kWide = 16.0 / 9;

// An engine whose game has these files.
struct FileGame : PlainGame {
  explicit FileGame(std::map<std::string, std::string> texts) : files(std::move(texts)) { assets = &library; }
  std::map<std::string, std::string> files;
  AssetLibrary library{[this](const std::string& path) -> std::optional<std::string> {
                         const auto found = files.find(path);
                         return found == files.end() ? std::nullopt : std::optional(found->second);
                       },
                       [this](const LogLine& line) { lines.push_back(line.text); }};
  // How far below a height of 10 m a ray down finds something.
  double depth(double x, double z) {
    const auto hit = world()->raycast({x, 10, z}, {0, -1, 0}, 100);
    return hit ? hit->distance : -1;
  }
  void save(const std::string& path, const std::string& bytes) {
    files[path] = bytes;
    files_changed(library.forget(path));
  }
};

Vec3 place_of(const DrawMesh& mesh, Vec3 origin) { return Vec3{mesh.matrix[12], mesh.matrix[13], mesh.matrix[14]} + origin; }

const DrawShape& shape_of(const DrawList& list, std::size_t mesh) { return list.shapes.at(list.meshes.at(mesh).shape); }

double volume_of(const Shape& shape) {
  BodyDef body;
  body.density = 1;
  body.colliders.emplace_back().shape = shape;
  return mass_properties(body).mass;
}

// A square pyramid without its base's inside: apex 2 m up, base 2 m wide at 0.
std::string roof_glb() {
  Shape pyramid;
  pyramid.shape = ShapeKind::pyramid;
  pyramid.size = {2, 2, 2};
  GltfWriter writer;
  add(writer.meshes, R"({"primitives": [)" + writer.primitive(make_mesh(pyramid), -1) + "]}");
  add(writer.nodes, R"({"mesh": 0, "translation": [0, 1, 0]})");
  return writer.glb();
}

// Three pixels wide and high, black but for white along the right edge.
std::string ramp_png() {
  std::vector<std::uint8_t> pixels;
  for (int i = 0; i < 9; ++i) pixels.insert(pixels.end(), 3, static_cast<std::uint8_t>(i % 3 == 2 ? 255 : 0));
  return png(3, 3, pixels);
}

}  // namespace

TEST_CASE("model files: each part is drawn where its node is, looking as the file says", "[engine][assets]") {
  FileGame game({{"cube.glb", cube_glb()}});
  game.make({{"position", Vec3{10, 0, 0}}, {"scale", Vec3{2, 2, 2}}, {"mesh", Map{{"file", "cube.glb"}}}});

  const DrawList list = extract(game, 1, kWide);

  REQUIRE(list.meshes.size() == 4);
  CHECK(shape_of(list, 0).part == 0);
  CHECK(shape_of(list, 0).shape.shape == ShapeKind::mesh);
  CHECK(shape_of(list, 0).key != shape_of(list, 1).key);
  CHECK(distance(place_of(list.meshes[0], list.origin), {10, 0, 0}) < 1e-5);
  CHECK(distance(place_of(list.meshes[2], list.origin), {10, 4, 0}) < 1e-5);  // 2 m up in the file, twice as large
  CHECK(list.meshes[0].roughness == 0.25f);
  CHECK(list.meshes[0].metalness == 0.75f);
  CHECK(list.meshes[0].two_sided);
  REQUIRE(list.meshes[0].glow_color);
  CHECK(list.meshes[0].glow_color->g == 1);
  CHECK(list.meshes[0].glow == Approx(0.735357).epsilon(1e-5));  // light of one half on the sRGB curve
  CHECK(list.meshes[1].color.g == Approx(1));
  CHECK(list.textures.at(list.meshes[1].texture) == DrawTexture{"cube.glb", 0});
}

TEST_CASE("model files: the node's material tints and replaces, its defaults change nothing", "[engine][assets]") {
  FileGame game({{"cube.glb", cube_glb()}});
  const NodeId node = game.make({{"mesh", Map{{"file", "cube.glb"}}}, {"material", Map{{"roughness", 0.5}}}});
  const Color before = extract(game, 1, kWide).meshes.at(0).color;
  game.set(node, "color", Color{0.5, 1, 0, 1});
  game.set(node, "material.opacity", 0.25);

  const DrawMesh mesh = extract(game, 1, kWide).meshes.at(0);

  CHECK(mesh.color.r == Approx(before.r * 0.5));
  CHECK(mesh.color.g == Approx(before.g));
  CHECK(mesh.color.b == 0);
  CHECK(mesh.color.a == 0.25);
  CHECK(mesh.roughness == 0.5f);
  CHECK(mesh.metalness == 0.75f);
}

TEST_CASE("model files: a missing one is said when it is named, and a box stands in", "[engine][assets]") {
  FileGame game({});
  game.make({{"mesh", Map{{"file", "tree.glb"}}}, {"body", "static"}, {"material", Map{{"texture", "bark.png"}}}});

  REQUIRE(game.lines.size() == 2);
  CHECK_THAT(game.lines[0], Catch::Contains("no file 'tree.glb'"));
  CHECK_THAT(game.lines[1], Catch::Contains("no file 'bark.png'"));
  const DrawList list = extract(game, 1, kWide);
  REQUIRE(list.meshes.size() == 1);
  CHECK(shape_of(list, 0).part == -1);
  CHECK(is_stand_in(shape_of(list, 0).shape));
  CHECK(game.depth(0, 0) == Approx(9.5));
}

TEST_CASE("model files: a camera that frames everything knows how large a model is", "[engine][assets]") {
  FileGame game({{"cube.glb", cube_glb()}});
  game.make({{"mesh", Map{{"file", "cube.glb"}}}});
  FileGame same({});
  same.make({{"position", Vec3{0, 1, 0}}, {"mesh", Map{{"shape", "box"}, {"size", Vec3{1, 3, 1}}}}});

  const CameraView a = framing(game.scene, game.assets), b = framing(same.scene, same.assets);

  CHECK(distance(a.pose.position, b.pose.position) < 1e-9);
}

TEST_CASE("model files: a static body has the model's triangles", "[engine][physics]") {
  FileGame game({{"roof.glb", roof_glb()}});
  game.make({{"mesh", Map{{"file", "roof.glb"}}}, {"body", "static"}, {"scale", Vec3{2, 1, 1}}});
  game.run(1);

  // The roof falls from 2 m at the middle to 0 at 1 m; the node stretches x to twice that.
  CHECK(game.depth(0.01, 0) == Approx(8 + 0.01).margin(2e-3));  // Bullet's margin of 1 mm
  CHECK(game.depth(1, 0) == Approx(9).margin(2e-3));
  CHECK(game.depth(0, 0.5) == Approx(9).margin(2e-3));
  CHECK(game.depth(2.1, 0) == -1);
}

TEST_CASE("model files: a dynamic body has the hull around the model", "[engine][physics]") {
  FileGame game({{"cube.glb", cube_glb()}});
  const NodeId node = game.make({{"mesh", Map{{"file", "cube.glb"}}}, {"body", Map{{"density", 1000}, {"gravity_factor", 0}}}});
  game.run(1);

  // Two cubes 2 m apart: the hull is a box of 1 x 3 x 1 m, centre 1 m up.
  const MassProperties mass = game.world()->mass_properties(game.body(node)->id);
  CHECK(mass.mass == Approx(3000));
  CHECK(distance(mass.center, {0, 1, 0}) < 1e-9);
  CHECK(game.depth(0, 0) == Approx(7.5).margin(2e-3));
}

TEST_CASE("model files: triangles are refused on a dynamic body, with the way out", "[engine]") {
  FileGame game({{"roof.glb", roof_glb()}});
  const Map body{{"colliders", List{Map{{"shape", "mesh"}, {"file", "roof.glb"}}}}};
  CHECK_THROWS_WITH(game.make({{"body", body}}), Catch::Contains("'roof.glb'") && Catch::Contains("dynamic") && Catch::Contains("shape = \"hull\""));
  CHECK_THROWS_WITH(game.make({{"mesh", Map{{"shape", "sphere"}, {"file", "roof.glb"}}}}), Catch::Contains("file belongs to a mesh"));
}

TEST_CASE("model files: a picture's brightness is a height field", "[engine][physics]") {
  FileGame game({{"hills.png", ramp_png()}});
  game.make({{"mesh", Map{{"shape", "height_field"}, {"file", "hills.png"}, {"size", Vec3{8, 3, 4}}}}, {"body", "static"}});
  game.run(1);

  // Centred: from -1.5 m to 1.5 m, flat from x = -4 to 0 and then up to x = 4.
  CHECK(game.depth(-2, 1) == Approx(11.5).margin(2e-3));
  CHECK(game.depth(2, 1) == Approx(10).margin(2e-3));
  CHECK(game.depth(3.999, -1) == Approx(8.5).margin(3e-3));
  const DrawList list = extract(game, 1, kWide);
  REQUIRE(list.meshes.size() == 1);
  CHECK(shape_of(list, 0).part == 0);
  CHECK(list.meshes[0].matrix[0] == 8);
}

TEST_CASE("model files: a flat model's hull is a thin slab, a rich one's has few corners", "[engine][physics]") {
  GltfWriter flat, rich;
  add(flat.meshes, R"({"primitives": [{"attributes": {"POSITION": )" + std::to_string(flat.numbers({-1, 0, -1, -1, 0, 1, 1, 0, 1}, "VEC3")) + "}}]}");
  add(flat.nodes, R"({"mesh": 0})");
  Shape ball;
  ball.shape = ShapeKind::sphere;
  ball.radius = 1;
  add(rich.meshes, R"({"primitives": [)" + rich.primitive(make_mesh(ball), -1) + "]}");
  add(rich.nodes, R"({"mesh": 0})");
  FileGame game({{"flat.glb", flat.glb()}, {"ball.glb", rich.glb()}});
  Shape hull;
  hull.shape = ShapeKind::hull;

  hull.file = "flat.glb";
  CHECK(volume_of(game.with_points(hull)) == Approx(2 * 2 * 0.01));
  hull.file = "ball.glb";
  const Shape solid = game.with_points(hull);
  CHECK(solid.points.size() <= 128);
  // Inside the ball of 4/3 pi m^3, and by no more than 128 corners must lose.
  const double volume = volume_of(solid);
  CHECK(volume < 4.0 / 3 * kPi);
  CHECK(volume > 0.9 * 4.0 / 3 * kPi);
}

TEST_CASE("model files: saving one fits its bodies anew", "[engine][physics]") {
  FileGame game({{"thing.glb", roof_glb()}});
  game.make({{"mesh", Map{{"file", "thing.glb"}}}, {"body", "static"}});
  game.run(1);
  CHECK(game.depth(0.9, 0.9) == Approx(9.8).margin(2e-3));

  game.save("thing.glb", "broken");
  game.run(1);
  CHECK_THAT(game.lines.back(), Catch::Contains("'thing.glb'") && Catch::Contains("neither"));
  CHECK(game.depth(0.4, 0.4) == Approx(9.5));  // the stand-in of 1 m

  game.save("thing.glb", cube_glb());
  game.run(1);
  CHECK(game.depth(0.4, 0.4) == Approx(7.5).margin(2e-3));
}
