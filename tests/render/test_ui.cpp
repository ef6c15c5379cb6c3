#include <catch2/catch.hpp>

#include "render/scenes.h"

using namespace tumble;
using namespace tumble::test;

namespace {

// 1280 x 720, so that a ui unit is a pixel.
Picture draw_ui(const DrawList& list) { return draw(list, 1280, 720); }

DrawUi panel(float x, float y, float width, float height, const Color& color) {
  DrawUi item;
  item.panel = {x, y, width, height, color, 0, ""};
  return item;
}

}  // namespace

TEST_CASE("ui: a round panel covers its rectangle less the corners", "[render]") {
  const auto covered = [](float radius) {
    PictureScene scene;
    scene.list.ui.push_back(panel(0, 0, 1280, 720, {0, 0, 0, 1}));
    scene.list.ui.push_back(panel(100, 100, 200, 100, {1, 1, 1, 1}));
    scene.list.ui.back().panel.radius = radius;
    const Picture picture = draw_ui(scene.list);
    double sum = 0;
    for (std::size_t i = 0; i < picture.pixels.size(); i += 3) sum += picture.pixels[i] / 255.0;
    return sum;
  };

  CHECK(covered(0) == Approx(200 * 100));
  // Four quarter circles stay of the corners' squares; a pixel's share is taken along its distance, hence the tolerance.
  CHECK(covered(40) == Approx(200 * 100 - (4 - kPi) * 40 * 40).margin(5));
  CHECK(covered(500) == Approx(200 * 100 - (4 - kPi) * 50 * 50).margin(5));  // half the shorter side at most
}

TEST_CASE("ui: a round corner is smooth", "[render]") {
  PictureScene scene;
  scene.list.ui.push_back(panel(0, 0, 1280, 720, {0, 0, 0, 1}));
  scene.list.ui.push_back(panel(100, 100, 200, 100, {1, 1, 1, 1}));
  scene.list.ui.back().panel.radius = 30;

  const Picture picture = draw_ui(scene.list);

  int between = 0;
  for (int x = 100; x < 130; ++x)
    for (int y = 100; y < 130; ++y) {
      const int g = pixel(picture, x, y).g;
      between += g > 20 && g < 235;
    }
  CHECK(between > 30);  // one or two pixels for each row of the corner
}

TEST_CASE("ui: nothing is drawn outside a clip, neither panels nor letters", "[render]") {
  PictureScene scene;
  scene.list.ui.push_back(panel(0, 0, 1280, 720, {0, 0, 0, 1}));
  scene.list.ui.push_back(panel(50, 50, 500, 300, {1, 1, 1, 1}));
  scene.add_text("MMMMMMMM\nMMMMMMMM\nMMMMMMMM", 40, 90, 80);
  for (std::size_t i = 1; i < 3; ++i) scene.list.ui[i].clip = {100, 120, 60, 40};

  const Picture picture = draw_ui(scene.list);

  for (int x = 0; x < 640; ++x)
    for (int y = 0; y < 400; ++y) {
      const bool inside = x >= 100 && x < 160 && y >= 120 && y < 160;
      if ((pixel(picture, x, y).r > 0) != inside) FAIL("pixel " << x << ", " << y);
    }
}

TEST_CASE("ui: an image fills its panel, upright and tinted", "[render]") {
  // Red and lime above, blue and white below.
  const Assets assets({{"four.png", picture_of(2, 2, {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255})}});
  PictureScene scene;
  scene.list.assets = assets.library.get();
  scene.list.ui.push_back(panel(100, 100, 200, 200, {1, 0.5, 1, 1}));
  scene.list.ui.back().panel.image = "four.png";
  scene.list.ui.push_back(panel(190, 190, 20, 20, {0, 0, 0, 1}));

  const Picture picture = draw_ui(scene.list);

  CHECK(pixel(picture, 140, 140).r > 240);
  CHECK(pixel(picture, 140, 140).b < 15);
  CHECK(pixel(picture, 260, 140).g == Approx(128).margin(3));
  CHECK(pixel(picture, 140, 260).b > 240);
  CHECK(pixel(picture, 260, 260).r > 250);
  CHECK(pixel(picture, 260, 260).g == Approx(128).margin(3));
  CHECK(pixel(picture, 200, 200).b == 0);  // what comes later lies over it
}

TEST_CASE("ui: a missing image is pink and said once; a saved one is sent anew", "[render]") {
  Assets assets({});
  PictureScene scene;
  scene.list.assets = assets.library.get();
  scene.list.ui.push_back(panel(0, 0, 1280, 720, {1, 1, 1, 1}));
  scene.list.ui.back().panel.image = "gone.png";
  const auto window = Window::open(hidden_window());
  const auto renderer = make_gl_renderer(*window);

  for (int i = 0; i < 3; ++i) renderer->draw(scene.list, 320, 180);
  const Pixel missing = pixel(renderer->picture(), 160, 90);
  CHECK(missing.r > 240);
  CHECK(missing.g == Approx(51).margin(3));
  CHECK(assets.messages->size() == 1);

  (*assets.files)["gone.png"] = picture_of(1, 1, {0, 0, 255});
  assets.library->forget("gone.png");
  renderer->draw(scene.list, 320, 180);
  CHECK(pixel(renderer->picture(), 160, 90).r < 5);
  CHECK(pixel(renderer->picture(), 160, 90).b > 250);
}
