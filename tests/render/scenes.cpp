#include "render/scenes.h"

#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "assets/image.h"
#include "base/error.h"
#include "support/source_tree.h"

namespace tumble::test {
namespace {

float f(double value) { return static_cast<float>(value); }

Matrix matrix_of(Vec3 position, Quat rotation, Vec3 scale) {
  const Vec3 x = rotation * Vec3{scale.x, 0, 0}, y = rotation * Vec3{0, scale.y, 0}, z = rotation * Vec3{0, 0, scale.z};
  return {f(x.x), f(x.y), f(x.z), 0, f(y.x), f(y.y), f(y.z), 0,
          f(z.x), f(z.y), f(z.z), 0, f(position.x), f(position.y), f(position.z), 1};
}

}  // namespace

PictureScene::PictureScene(Vec3 eye, Vec3 target) {
  list.origin = eye;
  list.camera_rotation = look_rotation(target - eye);
}

DrawMesh& PictureScene::add(ShapeKind kind, Vec3 position, const std::string& color, Quat rotation, Vec3 scale) {
  Shape shape;
  shape.shape = kind;
  return add(shape, position, color, rotation, scale);
}

DrawMesh& PictureScene::add(const Shape& shape, Vec3 position, const std::string& color, Quat rotation, Vec3 scale) {
  DrawMesh& mesh = list.meshes.emplace_back();
  mesh.shape = list.shape_number(shape);
  mesh.matrix = matrix_of(position - list.origin, rotation, scale);
  mesh.color = color_or_fail(color, "scene");
  return mesh;
}

void PictureScene::add_line(Vec3 from, Vec3 to, const std::string& color, bool on_top) {
  const Vec3 a = from - list.origin, b = to - list.origin;
  list.lines.push_back({{f(a.x), f(a.y), f(a.z)}, {f(b.x), f(b.y), f(b.z)}, color_or_fail(color, "line"), on_top});
}

void PictureScene::add_panel(float x, float y, float width, float height, const Color& color) {
  DrawUi& item = list.ui.emplace_back();
  item.panel = {x, y, width, height, color};
}

void PictureScene::add_text(const std::string& text, float x, float y, float size, bool mono) {
  DrawUi& item = list.ui.emplace_back();
  item.is_text = true;
  item.text = {text, x, y, size, {}, mono};
}

PictureScene still_life() {
  PictureScene scene({2.2, 2.4, 5}, {-0.1, 0.7, 0});
  scene.add(ShapeKind::box, {0, -0.5, 0}, "#a8aca4", {}, {30, 1, 30});
  scene.add(ShapeKind::box, {0, 0.5, 0}, "lightgray");
  scene.add(ShapeKind::box, {0.1, 1.5, 0}, "lightgray", axis_angle({0, 1, 0}, 0.5));
  scene.add(ShapeKind::sphere, {1.8, 0.5, 1}, "orange");
  Shape capsule, torus;
  capsule.shape = ShapeKind::capsule;
  capsule.height = 2;
  torus.shape = ShapeKind::torus;
  torus.thickness = 0.4;
  scene.add(capsule, {-1.6, 1, 0.8}, "cornflowerblue");
  scene.add(ShapeKind::cylinder, {-2.8, 0.5, -1}, "yellowgreen");
  scene.add(ShapeKind::cone, {-1.4, 0.5, -2.2}, "indianred");
  scene.add(ShapeKind::pyramid, {2.4, 0.5, -1.8}, "khaki");
  scene.add(torus, {-0.8, 0.2, 2.4}, "plum");
  DrawMesh& gold = scene.add(ShapeKind::sphere, {1, 0.4, 2.4}, "gold", {}, {0.8, 0.8, 0.8});
  gold.metalness = 1;
  gold.roughness = 0.3f;
  scene.add(ShapeKind::box, {3, 0.5, 0}, "#66ccff60");
  scene.add(ShapeKind::sphere, {0, 2.5, 0}, "tomato", {}, {0.5, 0.5, 0.5}).glow = 1;
  scene.add(ShapeKind::mesh, {-3.2, 0.5, 1}, "white");
  return scene;
}

PictureScene lamps_at_night() {
  PictureScene scene({0, 4, 9}, {0, 0.6, 0});
  DrawList& list = scene.list;
  list.has_sun = false;
  list.sky_brightness = 0.06;
  scene.add(ShapeKind::plane, {}, "lightgray", {}, {40, 1, 40});
  for (int i = -3; i <= 3; ++i) scene.add(i % 2 ? ShapeKind::sphere : ShapeKind::box, {1.5 * i, 0.5, 0}, "white");
  const auto add_lamp = [&](Vec3 place, const char* color, bool spot) {
    const Vec3 p = place - list.origin;
    list.lights.push_back({spot, {f(p.x), f(p.y), f(p.z)}, {0, -1, 0}, color_or_fail(color, "lamp"), 1.5f, 6, 1});
    scene.add(ShapeKind::sphere, place, color, {}, {0.2, 0.2, 0.2}).glow = 2;
  };
  add_lamp({-3.7, 1.6, 1.5}, "orange", false);
  add_lamp({0, 1.6, 1.5}, "lime", false);
  add_lamp({3.7, 1.6, 1.5}, "deepskyblue", false);
  add_lamp({0, 3.5, -3}, "white", true);
  return scene;
}

PictureScene columns_in_fog() {
  PictureScene scene({0, 2.5, 8}, {0, 2, -10});
  scene.list.fog_start = 5;
  scene.list.fog_end = 60;
  scene.add(ShapeKind::plane, {}, "#8fae7a", {}, {400, 1, 400});
  for (int i = 0; i < 12; ++i)
    for (const double x : {-3.0, 3.0}) scene.add(ShapeKind::cylinder, {x, 2, -6.0 * i}, "wheat", {}, {1, 4, 1});
  return scene;
}

Assets checks() {
  std::vector<std::uint8_t> pixels;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      const bool first = x < 8 && y < 8, light = (x / 8 + y / 8) % 2 == 0;
      const std::uint8_t other = first ? 40 : light ? 235 : 90;
      pixels.insert(pixels.end(), {static_cast<std::uint8_t>(light ? 235 : 90), other, other});
    }
  return Assets({{"checks.png", picture_of(64, 64, pixels)}});
}

PictureScene painted_shapes(const Assets& assets) {
  PictureScene scene({1, 3, 6.5}, {0, 0.4, 0});
  scene.list.assets = assets.library.get();
  scene.add(ShapeKind::plane, {}, "tan", {}, {12, 1, 12}).texture_size = 4;
  scene.add(ShapeKind::box, {-2.4, 0.75, 0.5}, "white", axis_angle({0, 1, 0}, 0.5), {1.5, 1.5, 1.5});
  scene.add(ShapeKind::box, {0, 0.5, 0}, "skyblue", {}, {2, 1, 1}).texture_size = 1;
  scene.add(ShapeKind::sphere, {2.2, 0.7, 0.6}, "white", {}, {1.4, 1.4, 1.4});
  scene.add(ShapeKind::cylinder, {-0.9, 0.4, 2.2}, "white", {}, {0.8, 0.8, 0.8});
  scene.add(ShapeKind::pyramid, {1, 0.4, 2.4}, "white", {}, {0.8, 0.8, 0.8});
  for (DrawMesh& mesh : scene.list.meshes) mesh.texture = scene.list.texture_number("checks.png");
  DrawMesh& missing = scene.add(ShapeKind::box, {3.2, 0.4, -1.8}, "white", {}, {0.8, 0.8, 0.8});
  missing.texture = scene.list.texture_number("no such file.png");
  return scene;
}

PictureScene smoke_and_sparks() {
  PictureScene scene({0, 2, 6}, {0, 1.2, 0});
  scene.add(ShapeKind::plane, {}, "lightgray", {}, {30, 1, 30});
  scene.add(ShapeKind::box, {-1.5, 0.75, 0}, "steelblue", {}, {1.2, 1.5, 1.2});
  scene.add(ShapeKind::box, {2.2, 0.6, -0.6}, "#ff606080", {}, {1.2, 1.2, 0.1});
  scene.add(ShapeKind::box, {2.5, 0.8, 0.4}, "#60a0ff80", {}, {1.2, 1.2, 0.1});
  DrawParticles smoke, sparks;
  for (int i = 0; i < 60; ++i) {
    const double up = i / 60.0, turn = i * 2.4;
    const Vec3 s = Vec3{-1.5 + 0.5 * up * std::sin(turn) + (i % 2 ? 0.9 : 0), 2.6 * up, std::cos(turn) * 1.2} - scene.list.origin;
    smoke.particles.push_back({{f(s.x), f(s.y), f(s.z)}, f(0.3 + 0.6 * up), {0.5, 0.5, 0.5, 0.5 * (1 - up)}, 0});
    const Vec3 p = Vec3{0.6 + 0.8 * up * std::sin(turn), 0.2 + 2 * up, 0.6 * up * std::cos(turn)} - scene.list.origin;
    sparks.particles.push_back({{f(p.x), f(p.y), f(p.z)}, f(0.16 - 0.1 * up), {1, 0.6, 0.15, 1}, 2});
  }
  scene.list.particles = {smoke, sparks};
  return scene;
}

Picture draw(const DrawList& list, int width, int height, bool es) {
  WindowDef def;
  def.width = width;
  def.height = height;
  def.offscreen = true;
  def.es = es;
  const auto window = Window::open(def);
  const auto renderer = make_gl_renderer(*window);
  renderer->draw(list, window->width(), window->height());
  return renderer->picture();
}

WindowDef hidden_window() {
  WindowDef def;
  def.width = 320;
  def.height = 180;
  def.offscreen = true;
  return def;
}

Pixel pixel(const Picture& picture, int x, int y) {
  const std::uint8_t* p = &picture.pixels[3 * (static_cast<std::size_t>(y) * picture.width + x)];
  return {p[0], p[1], p[2]};
}

std::string picture_of(int width, int height, const std::vector<std::uint8_t>& pixels) {
  const auto file = std::filesystem::temp_directory_path() / ("tumble_picture_" + std::to_string(getpid()) + ".png");
  write_png({width, height, pixels}, file.string());
  std::ifstream in(file, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  std::filesystem::remove(file);
  return bytes;
}

Assets::Assets(std::map<std::string, std::string> content)
    : files(std::make_shared<std::map<std::string, std::string>>(std::move(content))),
      messages(std::make_shared<std::vector<std::string>>()) {
  const auto read = [files = files](const std::string& path) -> std::optional<std::string> {
    const auto found = files->find(path);
    return found == files->end() ? std::nullopt : std::optional(found->second);
  };
  library = std::make_unique<AssetLibrary>(read, [messages = messages](const LogLine& line) { messages->push_back(line.text); });
}

Difference difference(const Picture& a, const Picture& b) {
  if (a.width != b.width || a.height != b.height || a.pixels.empty()) return {255, 1};
  double sum = 0;
  std::size_t changed = 0;
  for (std::size_t pixel = 0; pixel < a.pixels.size(); pixel += 3) {
    int most = 0;
    for (std::size_t i = pixel; i < pixel + 3; ++i) {
      const int apart = std::abs(a.pixels[i] - b.pixels[i]);
      sum += apart;
      most = std::max(most, apart);
    }
    changed += most > 12;
  }
  const auto channels = static_cast<double>(a.pixels.size());
  return {sum / channels, 3 * static_cast<double>(changed) / channels};
}

Picture load_picture(const std::string& file) {
  const Image image = load_image(file);
  Picture picture{image.width, image.height, {}};
  for (std::size_t i = 0; i < image.pixels.size(); i += 4)
    picture.pixels.insert(picture.pixels.end(), &image.pixels[i], &image.pixels[i] + 3);
  return picture;
}

Difference difference_to_golden(const Picture& picture, const std::string& name) {
  const auto file = source_tree("tests/golden/" + name + ".png");
  Difference result{255, 1};
  if (std::filesystem::exists(file)) result = difference(picture, load_picture(file.string()));
  if (!result.is_small()) write_png(picture, name + ".actual.png");
  return result;
}

}  // namespace tumble::test
