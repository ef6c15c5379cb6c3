#include "render/view.h"

#include <catch2/catch.hpp>

#include "render/scenes.h"

using namespace tumble;
using namespace tumble::test;

namespace {

struct Clip {
  double x, y, z, w;
};
Clip transform(const WideMatrix& m, Vec3 p) {
  const auto row = [&](int i) { return m[i] * p.x + m[4 + i] * p.y + m[8 + i] * p.z + m[12 + i]; };
  return {row(0), row(1), row(2), row(3)};
}

// Where a point of the world lies in the shadow map, in texels.
Vec3 texels(const ShadowFit& fit, Vec3 origin, Vec3 point, int map_size) {
  const Clip clip = transform(fit.matrix, point - origin);
  return {clip.x * map_size / 2, clip.y * map_size / 2, 0};
}

ShadowFit fit_shadow(const DrawList& list) {
  MeshBoxes boxes;
  return SunView(list, boxes.find(list)).fit(1.6, 1024);
}

PictureScene boxes_on_ground(Vec3 eye = {0, 3, 8}) {
  PictureScene scene(eye, eye + Vec3{0, -0.3, -1});
  scene.add(ShapeKind::plane, {}, "gray", {}, {200, 1, 200});
  scene.add(ShapeKind::box, {-1, 0.5, 0}, "gray");
  scene.add(ShapeKind::box, {3, 0.5, -2}, "gray");
  return scene;
}

}  // namespace

TEST_CASE("view: the camera matrix puts what is ahead in the middle", "[render]") {
  DrawList list;
  list.camera_rotation = look_rotation({1, 0, 0});

  const Clip ahead = transform(camera_matrix(list, 1.5), {5, 0, 0});
  const Clip edge = transform(camera_matrix(list, 1.5), {5, 5 * std::tan(list.field_of_view / 2), 0});

  CHECK(ahead.w == Approx(5));
  CHECK(std::hypot(ahead.x, ahead.y) < 1e-12);
  CHECK(edge.y / edge.w == Approx(1));
}

TEST_CASE("view: depth runs from -1 at near to 1 at far", "[render]") {
  DrawList list;
  const auto depth = [&](double distance) {
    const Clip clip = transform(camera_matrix(list, 1), {0, 0, -distance});
    return clip.z / clip.w;
  };

  CHECK(depth(list.near) == Approx(-1));
  CHECK(depth(list.far) == Approx(1));
}

TEST_CASE("view: wide ground does not coarsen the shadows of what stands on it", "[render]") {
  const ShadowFit fit = fit_shadow(boxes_on_ground().list);

  REQUIRE(fit.any);
  CHECK(fit.texel * 1024 < 20);  // m; the boxes stand 4.5 m apart, and no map is smaller than 16
}

TEST_CASE("view: a wide roof casts its whole shadow", "[render]") {
  PictureScene scene = boxes_on_ground();
  scene.add(ShapeKind::box, {0, 5, -10}, "gray", {}, {20, 0.2, 20});

  CHECK(fit_shadow(scene.list).texel * 1024 > 20);
}

TEST_CASE("view: nothing upright means no shadow map", "[render]") {
  PictureScene scene;
  scene.add(ShapeKind::plane, {}, "gray", {}, {200, 1, 200});

  CHECK_FALSE(fit_shadow(scene.list).any);
}

TEST_CASE("view: the map moves by whole texels, so that shadows stand still under a moving camera", "[render]") {
  const Vec3 corner{-0.5, 1, 0.5};
  const PictureScene at_first = boxes_on_ground();
  const ShadowFit before = fit_shadow(at_first.list);
  const Vec3 start = texels(before, at_first.list.origin, corner, 1024);

  for (int i = 1; i < 50; ++i) {
    const PictureScene moved = boxes_on_ground({0.037 * i, 3 + 0.011 * i, 8});
    const ShadowFit after = fit_shadow(moved.list);
    REQUIRE(after.texel == before.texel);
    const Vec3 step = texels(after, moved.list.origin, corner, 1024) - start;
    CHECK(std::hypot(step.x - std::round(step.x), step.y - std::round(step.y)) < 1e-6);
  }
}
