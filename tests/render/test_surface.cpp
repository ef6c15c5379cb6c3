// What is on surfaces and before them: textures, glass, particles.
#include <catch2/catch.hpp>

#include "render/batches.h"
#include "render/scenes.h"

using namespace tumble;
using namespace tumble::test;

namespace {

// Left half white, right half black.
Assets stripes() {
  return Assets({{"stripes.png", picture_of(2, 1, {255, 255, 255, 0, 0, 0})},
                 {"red.png", picture_of(1, 1, {255, 0, 0})}});
}

// From straight above, 10 m up, evenly lit.
PictureScene from_above(const Assets& assets) {
  PictureScene scene({0, 10, 0.0001}, {0, 0, 0});
  scene.list.assets = assets.library.get();
  scene.list.sun_direction = {0, -1, 0};
  scene.list.sun_shadow = false;
  return scene;
}

// How often a row of pixels goes from dark to light.
int rises(const Picture& picture, int row) {
  int count = 0;
  bool was_light = true;
  for (int x = 0; x < picture.width; ++x) {
    const Pixel p = pixel(picture, x, row);
    const bool is_light = p.g > 215, is_dark = p.g < 80;
    count += is_light && !was_light;
    if (is_light || is_dark) was_light = is_light;
  }
  return count;
}

DrawParticle particle(const PictureScene& scene, Vec3 place, float size, const std::string& color) {
  const Vec3 p = place - scene.list.origin;
  return {{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)}, size, color_or_fail(color, "test"), 0};
}

}  // namespace

TEST_CASE("surface: a texture lies once on each face, or repeats by metres whatever the scale", "[render]") {
  const Assets assets = stripes();
  const auto count = [&](float texture_size, Vec3 scale) {
    PictureScene scene = from_above(assets);
    scene.list.sky_horizon = scene.list.sky_top = scene.list.ground = {0.2, 0.2, 0.2, 1};  // dark around the plane
    DrawMesh& mesh = scene.add(ShapeKind::plane, {}, "white", {}, scale);
    mesh.texture = scene.list.texture_number("stripes.png");
    mesh.texture_size = texture_size;
    scene.list.meshes[0].roughness = 1;
    return rises(draw(scene.list), 180);
  };

  CHECK(count(0, {4, 1, 4}) == 1);
  CHECK(count(2, {4, 1, 4}) == 2);
  CHECK(count(1, {4, 1, 4}) == 4);
  CHECK(count(1, {8, 1, 4}) == 8);
  CHECK(count(0.5, {4, 1, 2}) == 8);
}

TEST_CASE("surface: the colour tints a texture", "[render]") {
  const Assets assets({{"white.png", picture_of(1, 1, {255, 255, 255})}});
  PictureScene plain = from_above(assets), painted = from_above(assets);
  plain.add(ShapeKind::plane, {}, "tomato", {}, {50, 1, 50});
  DrawMesh& mesh = painted.add(ShapeKind::plane, {}, "tomato", {}, {50, 1, 50});
  mesh.texture = painted.list.texture_number("white.png");

  CHECK(difference(draw(plain.list), draw(painted.list)).is_small());
}

TEST_CASE("surface: a missing texture is pink, a saved one is seen at once", "[render]") {
  Assets assets({});
  PictureScene scene = from_above(assets);
  DrawMesh& mesh = scene.add(ShapeKind::plane, {}, "white", {}, {50, 1, 50});
  mesh.texture = scene.list.texture_number("late.png");
  const auto window = Window::open(hidden_window());
  const auto renderer = make_gl_renderer(*window);

  renderer->draw(scene.list, 320, 180);
  const Pixel missing = pixel(renderer->picture(), 160, 90);
  CHECK(missing.r > missing.b);
  CHECK(missing.b > missing.g + 60);

  (*assets.files)["late.png"] = picture_of(1, 1, {0, 255, 0});
  assets.library->forget("late.png");
  renderer->draw(scene.list, 320, 180);
  CHECK(pixel(renderer->picture(), 160, 90).g > 200);
  CHECK(pixel(renderer->picture(), 160, 90).r < 100);
}

TEST_CASE("surface: glass is drawn from afar whatever the order in the list", "[render]") {
  const auto picture = [](bool near_first) {
    PictureScene scene({0, 0, 8}, {0, 0, 0});
    scene.add(ShapeKind::box, {0, 0, -4}, "white", {}, {30, 30, 1});
    const auto add = [&](double z, const char* color) { scene.add(ShapeKind::box, {0, 0, z}, color, {}, {2, 2, 0.1}); };
    if (near_first) add(2, "#ff000080");
    add(0, "#0000ff80");
    if (!near_first) add(2, "#ff000080");
    return draw(scene.list);
  };
  const Picture a = picture(true), b = picture(false);

  CHECK(difference(a, b).mean == 0);
  CHECK(pixel(a, 320, 180).r > pixel(a, 320, 180).b);  // the red one is before the blue one
}

TEST_CASE("surface: particles are soft discs that solid things hide and that hide nothing themselves", "[render]") {
  PictureScene scene({0, 0, 8}, {0, 0, 0});
  scene.list.sky_top = scene.list.sky_horizon = scene.list.ground = {0, 0, 0, 1};
  scene.list.has_sun = false;
  DrawParticles& set = scene.list.particles.emplace_back();
  set.particles.push_back(particle(scene, {-2, 0, 0}, 2, "white"));
  set.particles.back().glow = 1;
  set.particles.push_back(particle(scene, {2, 0, 0}, 2, "white"));
  set.particles.back().glow = 1;
  scene.add(ShapeKind::box, {2, 0, 2}, "black", {}, {3, 3, 0.1});

  const Picture picture = draw(scene.list);

  // 180 pixels stand for 8 tan 30 m at the particles' distance.
  const double metre = 180 / (8 * std::tan(radians(30)));
  const auto at = [&](double x, double y) { return pixel(picture, static_cast<int>(320 + x * metre), static_cast<int>(180 - y * metre)).g; };
  CHECK(at(-2, 0) > 200);
  CHECK(at(-2.5, 0) < at(-2, 0));
  CHECK(at(-2.5, 0) > 20);
  CHECK(at(-2, 0.9) < 60);
  CHECK(at(-2.9, 0.9) == 0);  // outside the disc
  CHECK(at(2, 0) < 10);       // behind the box
}

TEST_CASE("surface: meshes behind the camera are not sent", "[render]") {
  PictureScene scene({0, 0, 0}, {0, 0, -1});
  scene.add(ShapeKind::box, {0, 0, -5}, "red");
  scene.add(ShapeKind::box, {0, 0, 5}, "red");
  scene.add(ShapeKind::box, {50, 0, -5}, "red");
  scene.add(ShapeKind::box, {50, 0, -5}, "red", {}, {120, 1, 1});  // reaches into the picture
  MeshBoxes boxes;
  const Frustum frustum(scene.list, 16.0 / 9);

  const Batches batches = make_batches(scene.list, balls(scene.list, boxes.find(scene.list)), 0,
                                       [&](const Ball& ball) { return frustum.may_see(ball); });

  CHECK(batches.instances.size() == 2);
}

TEST_CASE("surface: a shadow is seen where the ball that throws it is not, and never lost", "[render]") {
  PictureScene scene({0, 0, 0}, {0, 0, -1});
  const Frustum frustum(scene.list, 16.0 / 9);
  const std::array<float, 3> down{0, -1, 0}, up{0, 1, 0}, away{0, 0, -1}, back{0, 0, 1};

  CHECK(frustum.may_see_shadow({0, 30, -10, 1}, down, 60));
  CHECK_FALSE(frustum.may_see_shadow({0, 30, -10, 1}, up, 60));
  CHECK(frustum.may_see_shadow({0, 0, 10, 1}, away, 60));
  CHECK_FALSE(frustum.may_see_shadow({0, 0, 10, 1}, back, 60));
  CHECK_FALSE(frustum.may_see_shadow({0, 0, -70, 1}, away, 60));
  CHECK(frustum.may_see_shadow({0, 0, -70, 1}, back, 60));

  // Whatever the light: where some place along it is in sight, the shadow is.
  int lost = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 light = normalized(Vec3{std::sin(i * 1.3), std::sin(i * 2.1 + 1), std::sin(i * 0.7 + 2)});
    const Ball ball{static_cast<float>(40 * std::sin(i * 3.1)), static_cast<float>(40 * std::sin(i * 1.7)), static_cast<float>(40 * std::sin(i * 2.3)), 1};
    bool seen = false;
    for (float far = 0; far < 100; far += 0.5f) {
      const Ball shadow{ball.x + far * static_cast<float>(light.x), ball.y + far * static_cast<float>(light.y), ball.z + far * static_cast<float>(light.z), 1};
      seen |= shadow.z > -60 && frustum.may_see(shadow);
    }
    lost += seen && !frustum.may_see_shadow(ball, {static_cast<float>(light.x), static_cast<float>(light.y), static_cast<float>(light.z)}, 60);
  }
  CHECK(lost == 0);
}
