#include <random>

#include "physical.h"
#include "physics/solids.h"

using namespace tumble;

namespace {

// Where a ray from outside must hit, by marching along the signed distance to the shape: an independent way.
double box_distance(Vec3 p, Vec3 half) {
  const Vec3 q{std::abs(p.x) - half.x, std::abs(p.y) - half.y, std::abs(p.z) - half.z};
  const Vec3 out{std::max(q.x, 0.0), std::max(q.y, 0.0), std::max(q.z, 0.0)};
  return length(out) + std::min(std::max({q.x, q.y, q.z}), 0.0);
}

double capsule_distance(Vec3 p, double r, double half) {
  return distance(p, {0, std::clamp(p.y, -half, half), 0}) - r;
}

double cylinder_distance(Vec3 p, double r, double half) {
  const double across = std::hypot(p.x, p.z) - r, along = std::abs(p.y) - half;
  return std::min(std::max(across, along), 0.0) + std::hypot(std::max(across, 0.0), std::max(along, 0.0));
}

template <class F>
std::optional<double> march(F distance_to, Vec3 origin, Vec3 direction, double length) {
  double t = 0;
  for (int i = 0; i < 4000 && t < length; ++i) {
    const double gap = distance_to(origin + direction * t);
    if (gap < 1e-11) return t;
    t += gap;
  }
  return {};
}

Vec3 random_direction(std::mt19937& random) {
  const auto number = [&] { return random() / 2147483648.0 - 1; };
  for (;;) {
    const Vec3 v{number(), number(), number()};
    if (length(v) < 1 && length(v) > 0.1) return normalized(v);
  }
}

template <class F>
void check_rays(const Shape& shape, F distance_to) {
  std::mt19937 random(3);
  Scene scene(weightless());
  const Quat turn = axis_angle({1, -2, 0.5}, 1.1);
  const Vec3 place{3, -4, 5};
  scene.add(body(shape, BodyType::fixed), place, turn);
  int hits = 0;
  for (int i = 0; i < 400; ++i) {
    const Vec3 origin = random_direction(random) * 10.0, target = random_direction(random) * 0.9;
    const Vec3 direction = normalized(target - origin);
    const auto expected = march(distance_to, origin, direction, 20);
    const auto hit = scene.world.raycast(place + turn * origin, turn * direction * 7.0, 20);
    // A grazing ray may go either way.
    if (expected.has_value() != hit.has_value()) {
      CHECK(std::abs(distance_to(origin + direction * expected.value_or(hit ? hit->distance : 0))) < 1e-6);
      continue;
    }
    if (!hit) continue;
    ++hits;
    CHECK(hit->distance == Approx(*expected).epsilon(1e-6));
    CHECK(std::abs(distance_to(conjugate(turn) * (hit->point - place))) < 1e-9);
    CHECK(length(hit->normal) == Approx(1));
    CHECK(dot(hit->normal, turn * direction) < 0);
  }
  CHECK(hits > 50);
}

}  // namespace

TEST_CASE("queries: rays hit spheres, boxes, capsules and cylinders where their formulas say", "[physics]") {
  check_rays(ball(0.7), [](Vec3 p) { return length(p) - 0.7; });
  check_rays(box({1, 0.6, 1.4}), [](Vec3 p) { return box_distance(p, {0.5, 0.3, 0.7}); });
  check_rays(upright(ShapeKind::capsule, 0.3, 1.6), [](Vec3 p) { return capsule_distance(p, 0.3, 0.5); });
  check_rays(upright(ShapeKind::cylinder, 0.4, 1.2), [](Vec3 p) { return cylinder_distance(p, 0.4, 0.6); });
}

TEST_CASE("queries: a cone is hit as the limit of a fine hull of it", "[physics]") {
  const double r = 0.5, h = 1.5;
  Shape hull;
  hull.shape = ShapeKind::hull;
  hull.points.push_back({0, h / 2, 0});
  for (int i = 0; i < 360; i += 6) hull.points.push_back({r * std::cos(radians(i)), -h / 2, r * std::sin(radians(i))});
  Scene smooth, edged;
  smooth.add(body(upright(ShapeKind::cone, r, h), BodyType::fixed), {});
  edged.add(body(hull, BodyType::fixed), {});
  std::mt19937 random(5);

  for (int i = 0; i < 200; ++i) {
    const Vec3 origin = random_direction(random) * 5.0, direction = random_direction(random) * 0.3 - origin;
    const auto a = smooth.world.raycast(origin, direction, 20), b = edged.world.raycast(origin, direction, 20);
    if (!a || !b) continue;
    // The sagitta of six degrees is 7e-4 m across the surface.
    CHECK(std::abs(a->distance - b->distance) * std::abs(dot(a->normal, normalized(direction))) < 7e-4);
  }
}

TEST_CASE("queries: a ray from inside hits at once, against its direction", "[physics]") {
  Scene scene;
  const BodyId id = scene.add(body(box({2, 2, 2}), BodyType::fixed), {});

  const auto hit = scene.world.raycast({0.2, 0, 0}, {1, 0, 0}, 5);

  REQUIRE(hit);
  CHECK(hit->body == id);
  CHECK(hit->inside);
  CHECK(hit->distance == 0);
  CHECK(hit->normal.x == -1);
}

TEST_CASE("queries: a ray is exact from a thousand kilometres, and has no end where none is given", "[physics]") {
  Scene scene;
  scene.add(body(ball(0.5), BodyType::fixed), {});

  const auto near = scene.world.raycast({-1e6, 0.3, 0}, {1, 0, 0}, kInfinity);

  REQUIRE(near);
  CHECK(near->point.x == Approx(-0.4).margin(1e-6));
  CHECK_FALSE(scene.world.raycast({-1e6, 0.3, 0}, {-1, 0, 0}, kInfinity));
  CHECK_FALSE(scene.world.raycast({-2, 0, 0}, {1, 0, 0}, 1.49));
  CHECK(scene.world.raycast({-2, 0, 0}, {1, 0, 0}, 1.51));
}

TEST_CASE("queries: the nearest comes first, and filters leave bodies out", "[physics]") {
  WorldSettings settings;
  settings.groups = {"glass"};
  Scene scene(settings);
  BodyDef glass = body(box({1, 1, 1}), BodyType::fixed), zone = glass;
  glass.group = "glass";
  zone.trigger = true;
  const BodyId far = scene.add(body(box({1, 1, 1}), BodyType::fixed), {0, 0, -9}), pane = scene.add(glass, {0, 0, -6});
  const BodyId trigger = scene.add(zone, {0, 0, -3});
  const auto order = [&](const QueryFilter& filter) {
    std::vector<BodyId> ids;
    for (const QueryHit& hit : scene.world.raycast_all({}, {0, 0, -1}, 20, filter)) ids.push_back(hit.body);
    return ids;
  };
  QueryFilter no_glass, all, not_far;
  no_glass.groups = ~scene.world.group_bit("glass");
  all.triggers = true;
  not_far.accept = [&](BodyId id) { return !(id == far); };

  CHECK(order({}) == std::vector<BodyId>{pane, far});
  CHECK(order(no_glass) == std::vector<BodyId>{far});
  CHECK(order(all) == std::vector<BodyId>{trigger, pane, far});
  CHECK(order(not_far) == std::vector<BodyId>{pane});
  CHECK(scene.world.raycast_any({}, {0, 0, -1}, 20));
  CHECK_FALSE(scene.world.raycast_any({}, {0, 1, 0}, 20));
}

TEST_CASE("queries: a cast ball meets a box after the way that geometry says", "[physics]") {
  Scene scene;
  scene.add(body(box({2, 2, 2}), BodyType::fixed), {5, 0, 0});

  const auto face = scene.world.cast(ball(0.5), {{0, 0.3, 0}, {}}, {1, 0, 0}, 10);
  REQUIRE(face);
  CHECK(face->distance == Approx(3.5).margin(1e-9));
  CHECK(face->normal.x == Approx(-1).margin(1e-9));

  // Past the upper edge by 0.3 m: touches where the circle of 0.5 m about the edge is 0.4 m before it.
  const auto edge = scene.world.cast(ball(0.5), {{0, 1.3, 0}, {}}, {1, 0, 0}, 10);
  REQUIRE(edge);
  CHECK(edge->distance == Approx(4 - 0.4).margin(1e-9));
  CHECK_FALSE(scene.world.cast(ball(0.5), {{0, 1.51, 0}, {}}, {1, 0, 0}, 10));
  CHECK(scene.world.cast(ball(0.5), {{4.2, 0, 0}, {}}, {1, 0, 0}, 10)->inside);
}

TEST_CASE("queries: a cast capsule stands on a ramp where geometry says", "[physics]") {
  Scene scene;
  const double slope = radians(30);
  scene.add(body(box({20, 1, 20}), BodyType::fixed), {}, axis_angle({0, 0, 1}, slope));

  const auto hit = scene.world.cast(upright(ShapeKind::capsule, 0.3, 1.8), {{0, 5, 0}, {}}, {0, -1, 0}, 10);

  // The lower ball's centre is r / cos(slope) above the surface, which is 0.5 / cos(slope) above the middle.
  REQUIRE(hit);
  CHECK(hit->distance == Approx(5 - 0.6 - (0.3 + 0.5) / std::cos(slope)).margin(1e-9));
  CHECK(hit->normal.y == Approx(std::cos(slope)).margin(1e-9));
}

TEST_CASE("queries: penetrations push a capsule out of every shape", "[physics]") {
  const Shape capsule = upright(ShapeKind::capsule, 0.3, 1.8);
  struct Case {
    Shape obstacle;
    Quat turn;
    Vec3 place;  // of the capsule
    double depth;  // by hand; 0: only that it comes out
  };
  const std::vector<Case> cases = {
      {box({4, 1, 4}), {}, {0.3, 1.3, 0}, 0.1},
      {box({4, 1, 4}), axis_angle({0, 0, 1}, 0.5), {0, 1.35, 0}, 0},
      {ball(1), {}, {1.2, 0, 0}, 0.1},
      {upright(ShapeKind::cylinder, 1, 4), {}, {1.2, 0, 0}, 0.1},
      {upright(ShapeKind::capsule, 1, 4), {}, {0, 0, 1.25}, 0.05},
      {ring(1, 0.4), {}, {1.4, 0, 0}, 0.1},
      {upright(ShapeKind::cone, 1, 2), {}, {0.7, 0.3, 0}, 0},
  };
  for (const Case& c : cases) {
    Scene scene;
    scene.add(body(c.obstacle, BodyType::fixed), {}, c.turn);
    Pose pose{c.place, {}};

    const auto hits = scene.world.penetrations(capsule, pose, 0.05);
    REQUIRE(!hits.empty());
    // The torus is a ring of capsules, within 2 % of its tube; all others to 1e-4.
    if (c.depth > 0) CHECK(hits[0].distance == Approx(-c.depth).margin(c.obstacle.shape == ShapeKind::torus ? 0.01 : 1e-4));
    for (int round = 0; round < 4; ++round)
      for (const QueryHit& hit : scene.world.penetrations(capsule, pose, 0))
        pose.position += hit.normal * std::max(0.0, -hit.distance);

    for (const QueryHit& hit : scene.world.penetrations(capsule, pose, 0.05)) CHECK(hit.distance > -1e-3);
  }
}

TEST_CASE("queries: overlap tells shapes from boxes, in order of age", "[physics]") {
  Scene scene;
  const BodyId late = scene.add(body(ball(1)), {2, 0, 0});
  const BodyId first = scene.add(body(ball(1)), {-1, 0, 0});
  scene.add(body(ball(1)), {1.2, 1.2, 1.2});  // its box overlaps, it does not

  CHECK(scene.world.overlap(ball(1.01), {{}, {}}) == std::vector<BodyId>{late, first});
}

TEST_CASE("queries: a mesh of triangles answers rays, casts and bodies", "[physics]") {
  Shape mesh;
  mesh.shape = ShapeKind::mesh;
  mesh.points = {{-5, 0, -5}, {-5, 0, 5}, {5, 0, 5}, {-5, 0, -5}, {5, 0, 5}, {5, 0, -5}};
  Scene scene;
  scene.add(body(mesh, BodyType::fixed), {0, 1, 0});
  const BodyId id = scene.add(body(ball(0.5)), {1, 3, 2});

  CHECK(scene.world.raycast({2, 5, -2}, {0, -1, 0}, 10)->distance == Approx(4).epsilon(1e-9));
  CHECK(scene.world.cast(ball(0.5), {{2, 5, -2}, {}}, {0, -1, 0}, 10)->distance == Approx(3.5).margin(2e-3));
  scene.run(2);
  CHECK(scene.at(id).y == Approx(1.5).margin(0.01));
  CHECK_THROWS_WITH(scene.add(body(mesh), {}), Catch::Contains("static and kinematic bodies only"));
}

TEST_CASE("queries: a torus lets a smaller ball through its rim and holds a bigger one", "[physics]") {
  Scene scene;
  scene.add(body(ring(0.24, 0.02), BodyType::fixed), {0, 3, 0});
  BodyDef small = body(ball(0.225)), big = body(ball(0.235));
  const BodyId through = scene.add(small, {0, 4, 0});
  scene.run(1.5);
  CHECK(scene.at(through).y < 2);

  const BodyId held = scene.add(big, {0, 4, 0});
  scene.run(1.5);
  CHECK(scene.at(held).y > 2.9);
}
