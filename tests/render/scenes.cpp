#include "render/scenes.h"

#include <unistd.h>

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
  DrawMesh& mesh = list.meshes.emplace_back();
  mesh.shape.shape = kind;
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
  scene.add(ShapeKind::capsule, {-1.6, 1, 0.8}, "cornflowerblue").shape.height = 2;
  scene.add(ShapeKind::cylinder, {-2.8, 0.5, -1}, "yellowgreen");
  scene.add(ShapeKind::cone, {-1.4, 0.5, -2.2}, "indianred");
  scene.add(ShapeKind::pyramid, {2.4, 0.5, -1.8}, "khaki");
  scene.add(ShapeKind::torus, {-0.8, 0.2, 2.4}, "plum").shape.thickness = 0.4;
  DrawMesh& gold = scene.add(ShapeKind::sphere, {1, 0.4, 2.4}, "gold", {}, {0.8, 0.8, 0.8});
  gold.metalness = 1;
  gold.roughness = 0.3f;
  scene.add(ShapeKind::box, {3, 0.5, 0}, "#66ccff60");
  scene.add(ShapeKind::sphere, {0, 2.5, 0}, "tomato", {}, {0.5, 0.5, 0.5}).glow = 1;
  scene.add(ShapeKind::mesh, {-3.2, 0.5, 1}, "white");
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
