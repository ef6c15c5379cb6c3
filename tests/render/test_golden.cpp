// Pictures drawn off screen against pictures that somebody has looked at. Where there is no OpenGL these tests fail:
// install Mesa (libgl1-mesa-dri, libegl1). After a wanted change, look at <name>.actual.png and put it in tests/golden.
#include <catch2/catch.hpp>

#include "render/scenes.h"

using namespace tumble;
using namespace tumble::test;

namespace {

void check_golden(const Picture& picture, const std::string& name) {
  const Difference d = difference_to_golden(picture, name);
  INFO(name << ": mean difference " << d.mean << ", share of changed pixels " << d.changed);
  CHECK(d.is_small());
}

void check_seen(const Picture& wrong, const Picture& right) {
  const Difference d = difference(wrong, right);
  INFO("mean difference " << d.mean << ", share of changed pixels " << d.changed);
  CHECK_FALSE(d.is_small());
}

PictureScene texts() {
  PictureScene scene;
  scene.add_panel(20, 20, 560, 150, {0, 0, 0, 0.6});
  scene.add_text("Äpfel für Größe ß é\nzweite Zeile — 42 €", 36, 36, 48);
  scene.add_text("small: quick brown fox, 16 units", 36, 190, 16);
  scene.add_text("local x = vec3(0, 1, 0)", 36, 230, 24, true);
  scene.add_text("Huge", 700, 300, 300);
  scene.add_panel(36, 300, 200, 100, {1, 0.5, 0, 1});
  scene.add_panel(136, 350, 200, 100, {0, 0.5, 1, 0.5});
  return scene;
}

PictureScene lines() {
  PictureScene scene({0, 2, 6}, {0, 0.5, 0});
  scene.add(ShapeKind::box, {0, 0.5, 0}, "lightgray");
  for (int i = -5; i <= 5; ++i) {
    scene.add_line({double(i), 0, -5}, {double(i), 0, 50}, "black");  // their ends lie behind the camera
    scene.add_line({-5, 0, double(i)}, {5, 0, double(i)}, "black");
  }
  scene.add_line({-2, 0.5, -1}, {2, 0.5, -1}, "red");
  scene.add_line({-2, 0.8, -1}, {2, 0.8, -1}, "lime", true);
  return scene;
}

}  // namespace

TEST_CASE("golden: a still life of all shapes", "[render][golden]") {
  check_golden(draw(still_life().list), "still_life");
}

TEST_CASE("golden: an empty scene is sky above a horizon", "[render][golden]") {
  check_golden(draw(PictureScene({0, 2, 6}, {0, 2, 0}).list), "empty");
}

TEST_CASE("golden: texts with umlauts, and panels in order", "[render][golden]") {
  check_golden(draw(texts().list, 1280, 720), "texts");
}

TEST_CASE("golden: lines behind a box are hidden, lines on top are not", "[render][golden]") {
  check_golden(draw(lines().list), "lines");
}

TEST_CASE("golden: lamps at night", "[render][golden]") { check_golden(draw(lamps_at_night().list), "lamps"); }

TEST_CASE("golden: columns that end in fog", "[render][golden]") { check_golden(draw(columns_in_fog().list), "fog"); }

TEST_CASE("golden: a picture on all shapes", "[render][golden]") {
  const Assets assets = checks();
  check_golden(draw(painted_shapes(assets).list), "painted");
}

TEST_CASE("golden: smoke, sparks and glass", "[render][golden]") {
  check_golden(draw(smoke_and_sparks().list), "particles");
}

TEST_CASE("golden: OpenGL ES draws the same pictures", "[render][golden]") {
  check_golden(draw(still_life().list, 640, 360, true), "still_life");
  check_golden(draw(texts().list, 1280, 720, true), "texts");
  check_golden(draw(lines().list, 640, 360, true), "lines");
  check_golden(draw(lamps_at_night().list, 640, 360, true), "lamps");
  check_golden(draw(columns_in_fog().list, 640, 360, true), "fog");
  const Assets assets = checks();
  check_golden(draw(painted_shapes(assets).list, 640, 360, true), "painted");
  check_golden(draw(smoke_and_sparks().list, 640, 360, true), "particles");
}

TEST_CASE("golden: what a graphics card adds is softer edges, not another picture", "[render][golden]") {
  const auto window = Window::open(hidden_window());
  const auto renderer = make_gl_renderer(*window, DrawQuality::full);
  renderer->draw(still_life().list, 640, 360);

  CHECK(difference(renderer->picture(), draw(still_life().list)).mean < 1.5);
}

TEST_CASE("golden: the comparison sees a missing shadow", "[render][golden]") {
  PictureScene scene = still_life();
  scene.list.sun_shadow = false;

  check_seen(draw(scene.list), draw(still_life().list));
}

TEST_CASE("golden: the comparison sees a box moved by a hand's breadth", "[render][golden]") {
  PictureScene scene = still_life();
  scene.list.meshes[1].matrix[12] += 0.1f;

  check_seen(draw(scene.list), draw(still_life().list));
}

TEST_CASE("golden: the comparison sees a misspelt word", "[render][golden]") {
  PictureScene scene = texts();
  scene.list.ui[1].text.text = "Apfel fur Grose s e\nzweite Zeile — 42 €";

  check_seen(draw(scene.list, 1280, 720), draw(texts().list, 1280, 720));
}
