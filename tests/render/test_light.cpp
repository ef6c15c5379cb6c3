// Pixels against formulas. Below a peak of 0.76 the way from light to pixels is the sRGB curve alone, so that light can
// be read back.
#include <catch2/catch.hpp>

#include "render/air.h"
#include "render/lamps.h"
#include "render/scenes.h"

using namespace tumble;
using namespace tumble::test;

namespace {

double light(int value) {
  const double c = value / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

// Seen from straight above, with nothing to light it but lamps.
constexpr double kHeight = 10;
PictureScene dark_floor() {
  PictureScene scene({0, kHeight, 0.0001}, {0, 0, 0});
  scene.list.has_sun = false;
  scene.list.sky_brightness = 0;
  scene.add(ShapeKind::plane, {}, "white", {}, {100, 1, 100}).roughness = 1;
  return scene;
}

// The pixel of 640 x 360 that shows a place on the floor.
Pixel floor_pixel(const Picture& picture, double x, double z) {
  const double metre = 180 / (kHeight * std::tan(radians(30)));
  return pixel(picture, static_cast<int>(320 + x * metre), static_cast<int>(180 + z * metre));
}

void add_lamp(PictureScene& scene, Vec3 place, double range) {
  const Vec3 p = place - scene.list.origin;
  DrawLight& lamp = scene.list.lights.emplace_back();
  lamp.position = {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
  lamp.direction = {0, -1, 0};
  lamp.range = static_cast<float>(range);
}

}  // namespace

TEST_CASE("light: a lamp's light falls with the square of the distance, and ends at its range", "[render]") {
  PictureScene scene = dark_floor();
  add_lamp(scene, {0, 3, 0}, 8);
  const Picture picture = draw(scene.list);

  for (const double x : {1.0, 2.0, 3.0, 4.0, 6.0, 9.0}) {
    INFO(x << " m aside");
    const double squared = x * x + 9, share = squared / 64, window = std::max(1 - share * share, 0.0);
    const double expected = window * window / (16 * share + 1.0 / 16) * 3 / std::sqrt(squared);
    // The sheen of a rough floor adds up to 2 %, a pixel's step up to 1 % and half a value.
    CHECK(light(floor_pixel(picture, x, 0).g) == Approx(expected).epsilon(0.035).margin(0.002));
  }
  CHECK(lamp_share(2, 8) == Approx(1).epsilon(0.08));  // a clear day at a quarter of the range
}

TEST_CASE("light: a spot lights its cone alone, with a soft rim", "[render]") {
  PictureScene scene = dark_floor();
  add_lamp(scene, {0, 4, 0}, 20);
  scene.list.lights[0].brightness = 0.1f;
  PictureScene spot = dark_floor();
  spot.list.lights = scene.list.lights;
  spot.list.lights[0].spot = true;
  spot.list.lights[0].angle = static_cast<float>(radians(60));
  const Picture everywhere = draw(scene.list), cone = draw(spot.list);

  const auto share = [&](double degrees) {
    const double x = 4 * std::tan(radians(degrees));
    return light(floor_pixel(cone, x, 0).g) / light(floor_pixel(everywhere, x, 0).g);
  };
  CHECK(share(10) == Approx(1).margin(0.01));
  CHECK(share(20) == Approx(1).margin(0.01));  // the rim is the outer quarter of 30 degrees
  CHECK(share(24) < 0.95);
  CHECK(share(28) < share(24));
  CHECK(share(32) == 0);
}

TEST_CASE("light: of too many lamps the nearest and brightest are chosen", "[render]") {
  PictureScene scene = dark_floor();
  for (int i = 0; i < 40; ++i) add_lamp(scene, {0.1 * i, 3, 0}, 8);
  scene.list.lights[17].brightness = 50;
  add_lamp(scene, {0, 30, 0}, 8);  // behind the camera and too far to reach what it sees

  const Lamps lamps = choose_lamps(scene.list, Frustum(scene.list, 16.0 / 9), 8);

  REQUIRE(lamps.place.size() == 8);
  CHECK(lamps.light[0][0] == 50);
  for (const auto& place : lamps.place) CHECK(place[1] < 0);
}

TEST_CASE("light: fog takes its share by distance", "[render]") {
  for (const double distance : {20.0, 40.0, 60.0, 90.0}) {
    INFO(distance << " m");
    PictureScene scene({0, 0, 0}, {0, 0, -1});
    scene.list.has_sun = false;
    scene.list.sky_brightness = 0;
    scene.list.fog_color = Color{0.5, 0.5, 0.5, 1};
    scene.list.fog_start = 10;
    scene.list.fog_end = 110;
    scene.add(ShapeKind::box, {0, 0, -distance - 0.5}, "black", {}, {1000, 1000, 1});

    const double depth = (distance - 10) / 100, share = depth * depth * (3 - 2 * depth);
    CHECK(light(pixel(draw(scene.list), 320, 180).g) == Approx(light(128) * share).margin(0.004));
    CHECK(fog_share(distance, 10, 110) == Approx(share));
  }
}

TEST_CASE("light: without a color of its own, fog ends in the sky behind", "[render]") {
  PictureScene scene({0, 2, 0}, {0, 3, -10});
  scene.list.fog_end = 50;
  PictureScene empty = scene;
  scene.add(ShapeKind::box, {0, 0, -80}, "red", {}, {60, 60, 1});

  CHECK(difference(draw(scene.list), draw(empty.list)).is_small());
}

TEST_CASE("light: exposure doubles light", "[render]") {
  PictureScene scene = dark_floor();
  add_lamp(scene, {0, 3, 0}, 8);
  scene.list.lights[0].brightness = 0.2f;
  const double once = light(floor_pixel(draw(scene.list), 2, 0).g);
  scene.list.exposure = 2;

  CHECK(light(floor_pixel(draw(scene.list), 2, 0).g) == Approx(2 * once).epsilon(0.02));
}

TEST_CASE("light: what glows is seen in the dark, in its colour", "[render]") {
  PictureScene scene({0, 0, 5}, {0, 0, 0});
  scene.list.has_sun = false;
  scene.list.sky_brightness = 0;
  DrawMesh& mesh = scene.add(ShapeKind::box, {}, "black");
  mesh.glow = 1;
  mesh.glow_color = Color{0.5, 0.25, 0, 1};

  const Pixel p = pixel(draw(scene.list), 320, 180);

  CHECK(p.r == Approx(128).margin(2));
  CHECK(p.g == Approx(64).margin(2));
  CHECK(p.b <= 1);
}

TEST_CASE("light: a shadow's edge is soft over a few texels and falls all the way", "[render]") {
  PictureScene scene({0, 6, 0.0001}, {0, 0, 0});
  scene.list.sun_direction = normalized(Vec3{1, -1, 0});
  scene.add(ShapeKind::plane, {}, "gray", {}, {50, 1, 50});
  scene.add(ShapeKind::box, {0, 0.5, 0}, "gray");
  const Picture picture = draw(scene.list);

  // Along the ground across the edge at x = 1.5, in 640 x 360 pixels.
  const double metre = 180 / (6 * std::tan(radians(30)));
  int between = 0, before = 0;
  const int dark = pixel(picture, static_cast<int>(320 + 1.2 * metre), 180).g, lit = pixel(picture, static_cast<int>(320 + 1.8 * metre), 180).g;
  bool rises = true;
  for (double x = 1.3; x < 1.7; x += 1 / metre) {
    const int g = pixel(picture, static_cast<int>(320 + x * metre), 180).g;
    rises = rises && g + 2 >= before;
    before = g;
    between += g > dark + 5 && g < lit - 5;
  }
  CHECK(lit - dark > 40);
  CHECK(rises);
  CHECK(between >= 1);
  CHECK(between / metre < 0.2);  // m: no blur that would hide what casts it
}
