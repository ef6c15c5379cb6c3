#include "engine/extract.h"

#include <limits>

#include "test_engine_support.h"

using namespace tumble;

namespace {

constexpr double kWide = 16.0 / 9;

Vec3 place_of(const DrawMesh& mesh) { return {mesh.matrix[12], mesh.matrix[13], mesh.matrix[14]}; }

NodeId add_camera(PlainGame& game, Vec3 position, const Map& camera = {}) {
  return game.make({{"name", "eye"}, {"position", position}, {"camera", camera}});
}

}  // namespace

TEST_CASE("extract: visible meshes of enabled nodes, and nothing below hidden ones", "[engine]") {
  PlainGame game;
  add_camera(game, {});
  game.make({{"mesh", "box"}});
  game.make({{"mesh", "box"}, {"visible", false}, {"children", List{Map{{"mesh", "box"}}}}});
  game.make({{"mesh", "box"}, {"enabled", false}, {"children", List{Map{{"mesh", "box"}}}}});
  game.make({{"name", "plain"}});

  CHECK(extract(game, 1, kWide).meshes.size() == 1);
}

TEST_CASE("extract: a mesh's matrix takes its points to the picture's space", "[engine]") {
  PlainGame game;
  add_camera(game, {10, 0, 0});
  const Transform t{{1, 2, 3}, axis_angle({1, 2, 3}, 0.8), {2, 3, 4}};
  const NodeId node = game.make({{"mesh", "box"}});
  game.scene.jump(node, t);

  const Matrix m = extract(game, 1, kWide).meshes.at(0).matrix;

  const Vec3 p{0.5, -0.25, 0.75};
  const Vec3 drawn{m[0] * p.x + m[4] * p.y + m[8] * p.z + m[12], m[1] * p.x + m[5] * p.y + m[9] * p.z + m[13],
                   m[2] * p.x + m[6] * p.y + m[10] * p.z + m[14]};
  CHECK(distance(drawn, to_parent(t, p) - Vec3{10, 0, 0}) < 1e-5);  // floats of about 10
}

TEST_CASE("extract: poses lie between the last tick and this one, camera included", "[engine]") {
  PlainGame game;
  const NodeId eye = add_camera(game, {});
  const NodeId box = game.make({{"mesh", "box"}});
  game.run(1);
  game.tick_with([&] {
    game.set_position(eye, {0, 4, 0});
    game.set_position(box, {8, 0, 0});
  });

  const DrawList list = extract(game, 0.5, kWide);

  CHECK(list.origin == Vec3{0, 2, 0});
  CHECK(distance(place_of(list.meshes[0]), {4, -2, 0}) < 1e-6);
  CHECK(camera_view(game).pose.position == Vec3{0, 4, 0});  // rays see the tick
}

TEST_CASE("extract: far from the origin millimetres are still there", "[engine]") {
  PlainGame game;
  add_camera(game, {1e7, 0, 0});
  game.make({{"position", Vec3{1e7 + 0.001, 0, -2}}, {"mesh", "box"}});

  CHECK(place_of(extract(game, 1, kWide).meshes[0]).x == Approx(0.001).epsilon(1e-4));
}

TEST_CASE("extract: equal shapes are one, whatever fields they do not read", "[engine]") {
  PlainGame game;
  add_camera(game, {});
  for (const Map& mesh : {Map{{"shape", "sphere"}}, Map{{"shape", "sphere"}, {"size", Vec3{9, 9, 9}}}, Map{{"shape", "sphere"}, {"radius", 2}}})
    game.make({{"mesh", mesh}});

  const DrawList list = extract(game, 1, kWide);

  CHECK(list.shapes.size() == 2);
  CHECK(list.meshes[0].shape == list.meshes[1].shape);
  CHECK(list.shapes[list.meshes[2].shape].shape.radius == 2);
}

TEST_CASE("extract: a material's color, opacity and numbers", "[engine]") {
  PlainGame game;
  add_camera(game, {});
  game.make({{"mesh", "box"}, {"material", Map{{"color", "red"}, {"opacity", 0.5}, {"glow", 2}, {"metalness", 1}, {"roughness", 0.25}}}});

  const DrawMesh mesh = extract(game, 1, kWide).meshes[0];

  CHECK(mesh.color == Color{1, 0, 0, 0.5});
  CHECK(mesh.glow == 2);
  CHECK(mesh.metalness == 1);
  CHECK(mesh.roughness == 0.25f);
}

TEST_CASE("extract: without a light there is a sun, with a lamp only there is none, and a sun shines along its node", "[engine]") {
  PlainGame game;
  add_camera(game, {});
  CHECK(extract(game, 1, kWide).has_sun);

  game.make({{"light", "point"}});
  CHECK_FALSE(extract(game, 1, kWide).has_sun);

  game.make({{"light", Map{{"type", "sun"}, {"brightness", 3}}}, {"rotation_degrees", Vec3{-90, 0, 0}}});
  const DrawList list = extract(game, 1, kWide);
  CHECK(list.has_sun);
  CHECK(list.sun_brightness == 3);
  CHECK(distance(list.sun_direction, {0, -1, 0}) < 1e-12);
}

TEST_CASE("extract: lamps stand where their nodes are, spots shine along them", "[engine]") {
  PlainGame game;
  add_camera(game, {1, 0, 0});
  game.make({{"light", Map{{"type", "spot"}, {"color", "red"}, {"brightness", 3}, {"range", 7}, {"angle_degrees", 40}}},
             {"position", Vec3{1, 5, 0}}, {"rotation_degrees", Vec3{-90, 0, 0}}});
  game.make({{"light", "point"}, {"visible", false}});

  const DrawList list = extract(game, 1, kWide);

  REQUIRE(list.lights.size() == 1);
  const DrawLight& lamp = list.lights[0];
  CHECK(lamp.spot);
  CHECK(lamp.position == std::array<float, 3>{0, 5, 0});
  CHECK(lamp.direction[1] == Approx(-1));
  CHECK(lamp.color == Color{1, 0, 0, 1});
  CHECK(lamp.brightness == 3);
  CHECK(lamp.range == 7);
  CHECK(lamp.angle == Approx(radians(40)));
}

TEST_CASE("extract: the first visible sky counts", "[engine]") {
  PlainGame game;
  add_camera(game, {});
  game.make({{"sky", Map{{"top", "red"}}}, {"visible", false}});
  game.make({{"sky", Map{{"top", "blue"}, {"fog_color", "white"}, {"fog_start", 5}, {"fog_end", 50}, {"brightness", 0.5}, {"exposure", 2}}}});
  game.make({{"sky", Map{{"top", "lime"}}}});

  const DrawList list = extract(game, 1, kWide);

  CHECK(list.sky_top == Color{0, 0, 1, 1});
  CHECK(list.fog_color == Color{1, 1, 1, 1});
  CHECK(list.fog_start == 5);
  CHECK(list.fog_end == 50);
  CHECK(list.sky_brightness == 0.5);
  CHECK(list.exposure == 2);
}

TEST_CASE("extract: textures are listed once each", "[engine]") {
  PlainGame game;
  add_camera(game, {});
  for (const char* file : {"a.png", "b.png", "a.png"})
    game.make({{"mesh", "box"}, {"material", Map{{"texture", file}, {"texture_size", 2}}}});
  game.make({{"mesh", "box"}});

  const DrawList list = extract(game, 1, kWide);

  REQUIRE(list.textures.size() == 3);
  CHECK(list.textures[list.meshes[1].texture].file == "b.png");
  CHECK(list.meshes[0].texture == list.meshes[2].texture);
  CHECK(list.meshes[0].texture_size == 2);
  CHECK(list.meshes[3].texture == 0);
}

TEST_CASE("camera: the first active and enabled one in tree order", "[engine]") {
  PlainGame game;
  add_camera(game, {1, 0, 0}, {{"active", false}});
  const NodeId off = game.make({{"camera", Map{}}, {"enabled", false}});
  const NodeId second = add_camera(game, {2, 0, 0});
  add_camera(game, {3, 0, 0});

  CHECK(game.camera() == second);
  game.set_enabled(off, true);
  CHECK(game.camera() == off);
}

TEST_CASE("camera: where there is none, one is made that sees everything from +z and a little above", "[engine]") {
  PlainGame game;
  game.make({{"position", Vec3{-20, 0, 0}}, {"mesh", "box"}});
  game.make({{"position", Vec3{30, 10, -5}}, {"mesh", Map{{"shape", "sphere"}, {"radius", 3}}}});
  game.run(1);

  const NodeId camera = game.find_camera();
  REQUIRE(camera);
  const CameraView view = camera_view(game);
  CHECK(view.pose.position.z > 0);
  for (const Vec3 point : {Vec3{-20.5, -0.5, 0.5}, Vec3{33, 10, -5}, Vec3{30, 13, -5}, Vec3{30, 10, -2}}) {
    double x = -1, y = -1;
    REQUIRE(to_screen(view, point, 1, x, y));
    CHECK((x >= 0 && x <= 720 && y >= 0 && y <= 720));
  }
  CHECK(game.camera() == camera);
  add_camera(game, {});
  CHECK_FALSE(game.camera() == camera);
}

TEST_CASE("camera: drawing never makes one", "[engine]") {
  PlainGame game;
  game.make({{"mesh", "box"}});
  const std::size_t before = game.scene.size();

  extract(game, 1, kWide);
  camera_view(game);

  CHECK(game.scene.size() == before);
}

TEST_CASE("camera: the middle of the screen looks forward, its edges along the field of view", "[engine]") {
  CameraView view;
  view.pose.position = {1, 2, 3};
  view.field_of_view = kPi / 2;

  CHECK(camera_ray(view, 640, 360, kWide).first == Vec3{1, 2, 3});
  CHECK(distance(camera_ray(view, 640, 360, kWide).second, {0, 0, -1}) < 1e-12);
  CHECK(distance(camera_ray(view, 640, 0, kWide).second, normalized(Vec3{0, 1, -1})) < 1e-12);
  CHECK(distance(camera_ray(view, 1280, 360, kWide).second, normalized(Vec3{kWide, 0, -1})) < 1e-12);
}

TEST_CASE("camera: a point on a ray is drawn where the ray began on the screen", "[engine]") {
  CameraView view;
  view.pose = {{5, 6, 7}, axis_angle({1, 2, 3}, 1.3)};
  const auto [from, direction] = camera_ray(view, 200, 650, kWide);

  double x = 0, y = 0;
  REQUIRE(to_screen(view, from + direction * 42.0, kWide, x, y));
  CHECK(x == Approx(200));
  CHECK(y == Approx(650));
  CHECK_FALSE(to_screen(view, from - direction * 42.0, kWide, x, y));
}
