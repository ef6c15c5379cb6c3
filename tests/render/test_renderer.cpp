#include <catch2/catch.hpp>

#include "assets/mesh_detail.h"
#include "render/batches.h"
#include "render/null/renderer.h"
#include "render/scenes.h"

using namespace tumble;
using namespace tumble::test;

namespace {

// By shares of the picture's width and height.
Pixel pixel(const Picture& picture, double x, double y) {
  return test::pixel(picture, static_cast<int>(x * picture.width), static_cast<int>(y * picture.height));
}

}  // namespace

TEST_CASE("renderer: orange in the sun looks orange", "[render]") {
  PictureScene scene({0, 5, 0.01}, {0, 0, 0});
  scene.add(ShapeKind::plane, {}, "orange", {}, {50, 1, 50});

  const Pixel p = pixel(draw(scene.list), 0.5, 0.5);

  CHECK(p.r == Approx(255).margin(20));
  CHECK(p.g == Approx(165).margin(20));
  CHECK(p.b < 70);
}

TEST_CASE("renderer: a box shadows the ground, and only there", "[render]") {
  PictureScene scene({0, 10, 0.01}, {0, 0, 0});
  scene.list.sun_direction = normalized(Vec3{1, -1, 0});
  scene.add(ShapeKind::plane, {}, "gray", {}, {50, 1, 50});
  scene.add(ShapeKind::box, {0, 0.5, 0}, "gray");

  const Picture picture = draw(scene.list);

  // The box's top at x = -0.5 .. 0.5, y = 1 throws its shadow on the ground as far as x = 1.5.
  const double per_metre = 0.5 / (10 * std::tan(scene.list.field_of_view / 2)) * 360 / 640;
  const auto ground = [&](double x) { return pixel(picture, 0.5 + x * per_metre, 0.5).g; };
  CHECK(ground(1.0) < ground(-2.0) - 40);
  CHECK(ground(1.4) < ground(-2.0) - 40);
  CHECK(std::abs(ground(1.65) - ground(-2.0)) <= 6);
  CHECK(std::abs(ground(3.0) - ground(-2.0)) <= 6);
}

TEST_CASE("renderer: a lit surface has no stripes of its own shadow", "[render]") {
  for (const double height : {-0.15, -0.5, -1.0, -3.0}) {
    INFO("sun sinks " << height << " over 1");
    PictureScene scene({0, 4, 0.01}, {0, 0, 0});
    scene.list.sun_direction = normalized(Vec3{0.9, height, 0.43});
    scene.add(ShapeKind::box, {0, -0.5, 0}, "gray", {}, {40, 1, 40});
    scene.add(ShapeKind::box, {9, 0.5, 9}, "gray");  // casts, out of sight

    const Picture picture = draw(scene.list, 320, 180);

    int darkest = 255, brightest = 0;
    for (int x = 0; x < 20; ++x)
      for (int y = 0; y < 20; ++y) {
        const int g = pixel(picture, 0.4 + 0.01 * x, 0.4 + 0.01 * y).g;
        darkest = std::min(darkest, g);
        brightest = std::max(brightest, g);
      }
    CHECK(brightest - darkest <= 6);
  }
}

TEST_CASE("renderer: the picture is the same far from the world's origin", "[render]") {
  PictureScene scene = still_life();
  scene.list.origin += {1e6, 0, -1e6};

  CHECK(difference(draw(scene.list), draw(still_life().list)).is_small());
}

TEST_CASE("renderer: an unequal scale keeps lit faces lit", "[render]") {
  PictureScene scaled({0, 5, 0.01}, {0, 0, 0}), plain({0, 5, 0.01}, {0, 0, 0});
  scaled.add(ShapeKind::box, {0, -0.05, 0}, "gray", {}, {20, 0.1, 20});
  plain.add(ShapeKind::plane, {}, "gray", {}, {20, 1, 20});

  CHECK(pixel(draw(scaled.list), 0.5, 0.5).g == pixel(draw(plain.list), 0.5, 0.5).g);
}

TEST_CASE("renderer: draws in any size, one after the other", "[render]") {
  const auto window = Window::open(hidden_window());
  const auto renderer = make_gl_renderer(*window);
  const PictureScene scene = still_life();
  CHECK(renderer->picture().pixels.empty());

  for (const auto& [width, height] : {std::pair{320, 180}, {64, 64}, {641, 359}, {320, 180}}) {
    renderer->draw(scene.list, width, height);
    const Picture picture = renderer->picture();
    CHECK(picture.width == width);
    CHECK(picture.height == height);
    CHECK(difference(picture, draw(scene.list, width, height)).is_small());
  }
  renderer->draw(scene.list, 0, 0);
  CHECK(renderer->picture().width == 320);
}

TEST_CASE("renderer: a resized window gives its new size", "[render]") {
  const auto window = Window::open(hidden_window());

  window->set_size(400, 300);
  window->poll();

  CHECK(window->width() == 400);
  CHECK(window->height() == 300);
}

TEST_CASE("renderer: two windows do not draw into each other", "[render]") {
  const auto first = Window::open(hidden_window()), second = Window::open(hidden_window());
  const auto a = make_gl_renderer(*first), b = make_gl_renderer(*second);
  const PictureScene life = still_life(), empty;

  a->draw(life.list, 320, 180);
  b->draw(empty.list, 320, 180);

  CHECK(difference(a->picture(), draw(life.list, 320, 180)).is_small());
  CHECK(difference(b->picture(), draw(empty.list, 320, 180)).is_small());
}

TEST_CASE("renderer: a text that outgrows the letter texture is still drawn", "[render]") {
  PictureScene crowded, last;
  for (int size = 20; size < 190; ++size)
    crowded.add_text("abcdefghijklmnopqrstuvwxyz", 0, 0, static_cast<float>(size));
  last.add_text("Hallo", 100, 100, 60);
  const auto window = Window::open(hidden_window());
  const auto renderer = make_gl_renderer(*window);

  renderer->draw(crowded.list, 1280, 720);
  renderer->draw(last.list, 1280, 720);

  CHECK(difference(renderer->picture(), draw(last.list, 1280, 720)).is_small());
}

TEST_CASE("renderer: the null renderer keeps the last list and counts", "[render]") {
  NullRenderer renderer;

  renderer.draw(PictureScene().list, 320, 180);
  renderer.draw(still_life().list, 320, 180);

  CHECK(renderer.is_null());
  CHECK(renderer.pictures() == 2);
  CHECK(renderer.last().meshes.size() == still_life().list.meshes.size());
  CHECK(renderer.picture().pixels.empty());
}

TEST_CASE("batches: what is round is coarser from afar, and as fine as ever from near", "[render]") {
  PictureScene scene({0, 0, 0}, {0, 0, -1});
  scene.add(ShapeKind::sphere, {0, 0, -1}, "red");
  scene.add(ShapeKind::sphere, {0, 0, -900}, "red");
  scene.add(ShapeKind::box, {0, 0, -900}, "red");

  MeshBoxes boxes;
  const Batches batches = make_batches(scene.list, balls(scene.list, boxes.find(scene.list)), 1e-4, [](const Ball&) { return true; });

  REQUIRE(batches.opaque.size() == 3);
  CHECK(batches.opaque[0].coarseness == 0);
  CHECK(batches.opaque[1].coarseness + batches.opaque[2].coarseness == kCoarsest);  // the box has no coarser form
}

TEST_CASE("batches: equal shapes are one batch, near ones first; glass comes one by one from afar", "[render]") {
  PictureScene scene({0, 0, 0}, {0, 0, -1});
  scene.add(ShapeKind::box, {0, 0, -9}, "red");
  scene.add(ShapeKind::sphere, {0, 0, -1}, "red");
  scene.add(ShapeKind::box, {0, 0, -3}, "red");
  scene.add(ShapeKind::box, {0, 0, -4}, "#ff000080");
  scene.add(ShapeKind::box, {0, 0, -6}, "#ff000080");
  scene.add(ShapeKind::box, {0, 0, -5}, "#ff000000");

  MeshBoxes boxes;
  const Batches batches = make_batches(scene.list, balls(scene.list, boxes.find(scene.list)), 0, [](const Ball&) { return true; });

  REQUIRE(batches.opaque.size() == 2);
  CHECK(batches.opaque[0].count == 1);  // the sphere, before both boxes
  CHECK(batches.opaque[1].count == 2);
  CHECK(batches.instances[batches.opaque[1].first].matrix[11] == -3);
  REQUIRE(batches.transparent.size() == 2);
  CHECK(batches.instances[batches.transparent[0].first].matrix[11] == -6);
}
