#include "scene/node.h"

#include <catch2/catch.hpp>

using namespace tumble;

namespace {

// The same chain by 3x3 matrices: p -> position + R S p.
Vec3 by_hand(const Transform& t, Vec3 p) { return t.position + t.rotation * Vec3{p.x * t.scale.x, p.y * t.scale.y, p.z * t.scale.z}; }

const Transform kParent{{1, 2, 3}, axis_angle({1, 2, 3}, 0.7), {2, 2, 2}};
const Transform kChild{{-4, 0.5, 2}, axis_angle({0, 1, 1}, -1.2), {1, 3, 0.5}};

}  // namespace

TEST_CASE("transform: a child's point goes through its own transform and then its parent's", "[scene]") {
  const Vec3 point{0.3, -0.7, 1.1};

  const Vec3 expected = by_hand(kParent, by_hand(kChild, point));

  CHECK(distance(to_parent(kParent * kChild, point), expected) < 1e-12);
}

TEST_CASE("transform: an unturned child under unequal scale is stretched exactly", "[scene]") {
  const Transform stretched{{0, 1, 0}, axis_angle({1, 0, 0}, 0.4), {2, 3, 5}};
  const Transform child{{1, 1, 1}, {}, {7, 1, 1}};
  const Vec3 point{0.2, 0.4, -0.6};

  CHECK(distance(to_parent(stretched * child, point), by_hand(stretched, by_hand(child, point))) < 1e-12);
  CHECK((stretched * child).scale == Vec3{14, 3, 5});
}

TEST_CASE("transform: a turned child under unequal scale keeps its axes at right angles and their stretched lengths", "[scene]") {
  const Transform wide{{}, {}, {3, 1, 1}};
  const Transform turned{{}, axis_angle({0, 0, 1}, kPi / 2), {1, 1, 1}};

  // The child's y axis lies along the parent's x, which is three times as long.
  CHECK(distance((wide * turned).scale, {1, 3, 1}) < 1e-12);
}

TEST_CASE("transform: relative is the inverse of the product", "[scene]") {
  const Transform parent{{1, 2, 3}, axis_angle({1, 2, 3}, 0.7), {2, 0.5, 4}};

  const Transform back = relative(parent, parent * kChild);

  CHECK(distance(back.position, kChild.position) < 1e-12);
  CHECK(distance(back.scale, kChild.scale) < 1e-12);
  CHECK(std::abs(dot(back.rotation, kChild.rotation)) == Approx(1).epsilon(1e-12));
}

TEST_CASE("transform: from_parent undoes to_parent", "[scene]") {
  const Vec3 point{5, -6, 7};

  CHECK(distance(from_parent(kChild, to_parent(kChild, point)), point) < 1e-12);
}

TEST_CASE("transform: halfway between two turns is half the turn", "[scene]") {
  const Transform from, to{{2, 0, 0}, axis_angle({0, 1, 0}, 1.0), {3, 1, 1}};

  const Transform half = between(from, to, 0.5);

  CHECK(half.position == Vec3{1, 0, 0});
  CHECK(half.scale == Vec3{2, 1, 1});
  CHECK(dot(half.rotation, axis_angle({0, 1, 0}, 0.5)) == Approx(1).epsilon(1e-12));
}

TEST_CASE("camera: near must be below far", "[scene]") {
  Camera camera;

  CHECK_THROWS_WITH(assign(camera, Map{{"near", 10}, {"far", 2}}, "scene.add: camera"),
                    "scene.add: camera: near must be below far (got near 10, far 2)");
}
