#include "pairs.h"
#include "physics/pairs/nearest.h"

using namespace tumble;
using namespace tumble::pairs;

namespace {

const Polyhedron& pebble() {
  static const Polyhedron solid = [] {
    Random random(11);
    std::vector<Vec3> points;
    for (int i = 0; i < 20; ++i) points.push_back(scaled(random.direction(), {0.5, 0.35, 0.6}));
    return make_polyhedron(convex_hull(points));
  }();
  return solid;
}

std::vector<Convex> one_of_each() {
  return {make_sphere(0.4),        make_capsule(0.2, 0.4),  make_box({0.3, 0.4, 0.5}), make_cylinder(0.35, 0.4),
          make_cone(0.4, 0.45),    make_solid(pebble()),    make_triangle({-0.6, 0, -0.4}, {0.5, 0.1, -0.3}, {0, -0.1, 0.6})};
}

// The distance, or the negative depth, of two shapes: the largest separation over all directions, found by trying many
// and climbing from the best. Never more than the truth.
double brute_separation(const Placed& a, const Placed& b, Random& random) {
  double best = -1e300;
  Vec3 normal;
  for (int i = 0; i < 1500; ++i) {
    const Vec3 n = random.direction();
    if (const double s = separation_along(a, b, n); s > best) best = s, normal = n;
  }
  for (double step = 0.1; step > 1e-7; step *= 0.8)
    for (int i = 0; i < 12; ++i) {
      const Vec3 n = normalized(normal + random.direction() * step);
      if (const double s = separation_along(a, b, n); s > best) best = s, normal = n;
    }
  return best;
}

void check_sound(const Manifold& manifold, double margin) {
  CHECK(length(manifold.normal) == Approx(1));
  REQUIRE(manifold.count >= 1);
  for (int i = 0; i < manifold.count; ++i) {
    const Point& p = manifold.points[i];
    CHECK(p.separation <= margin);
    CHECK(distance(p.on_a, p.on_b + manifold.normal * p.separation) < 1e-9);
  }
}

}  // namespace

TEST_CASE("pairs: the deepest point is as deep, or as far, as brute force finds", "[physics][pairs]") {
  Random random(1);
  const std::vector<Convex> shapes = one_of_each();
  constexpr double kMargin = 0.2;
  int touching = 0, apart = 0;
  for (const Convex& a : shapes)
    for (const Convex& b : shapes) {
      if (a.kind == Convex::triangle || b.kind == Convex::triangle) continue;  // given to its rim: below
      for (int round = 0; round < 12; ++round) {
        const Pose at_a = random.pose(0.5), at_b = random.pose(0.5);
        const double truth = brute_separation({a, at_a}, {b, at_b}, random);
        const Look seen = look(a, at_a, b, at_b, kMargin);
        INFO("kinds " << a.kind << " and " << b.kind << ", round " << round);
        CHECK(seen.found == (truth <= kMargin));
        if (!seen.found) continue;
        check_sound(seen.manifold, kMargin);
        // Brute force is short by its last step's square; a face may be taken for an edge that is 5 % better. Any
        // direction's separation is a lower bound, so that ours may be the better one.
        const double near = 2e-4 + 0.06 * std::abs(truth), ours = separation_along({a, at_a}, {b, at_b}, seen.manifold.normal);
        CHECK(ours >= truth - near);
        CHECK(seen.least() == Approx(ours).margin(near));
        ++(truth < 0 ? touching : apart);
      }
    }
  CHECK(touching > 100);
  CHECK(apart > 50);
}

TEST_CASE("pairs: points lie on both surfaces", "[physics][pairs]") {
  Random random(2);
  for (const Convex& a : one_of_each())
    for (const Convex& b : one_of_each()) {
      if (a.kind == Convex::triangle && b.kind == Convex::triangle) continue;
      for (int round = 0; round < 60; ++round) {
        const Pose at_a = random.pose(0.4), at_b = random.pose(0.4);
        const Look seen = look(a, at_a, b, at_b, 0.05);
        if (!seen.found) continue;
        // Round sides that lie along an edge, within a hundredth radian, meet it halfway at both ends; deep in one another
        // they meet where an expanding polytope ends, good to its last facet.
        const bool flat = has_flat_faces(a) && has_flat_faces(b);
        const double near = flat ? 1e-9 : 3e-3 + 0.02 * std::max(0.0, -seen.least());
        INFO("kinds " << a.kind << " and " << b.kind << ", round " << round << ", separation " << seen.least());
        for (int i = 0; i < seen.manifold.count; ++i) {
          CHECK(off_surface(a, at_a, seen.manifold.points[i].on_a) < near);
          CHECK(off_surface(b, at_b, seen.manifold.points[i].on_b) < near);
        }
      }
    }
}

TEST_CASE("pairs: swapping the two turns the normal and keeps the points", "[physics][pairs]") {
  Random random(3);
  // Round shapes: to what the search for their nearest points leaves open.
  for (const Convex& a : one_of_each())
    for (const Convex& b : one_of_each())
      for (int round = 0; round < 30; ++round) {
        if (a.kind == Convex::triangle && b.kind == Convex::triangle) continue;  // never met
        const Pose at_a = random.pose(0.4), at_b = random.pose(0.4);
        const Look one = look(a, at_a, b, at_b), two = look(b, at_b, a, at_a);
        INFO("kinds " << a.kind << " and " << b.kind << ", round " << round);
        REQUIRE(one.found == two.found);
        if (!one.found) continue;
        CHECK(distance(one.manifold.normal, -two.manifold.normal) < 1e-4);
        REQUIRE(one.manifold.count == two.manifold.count);
        for (int i = 0; i < one.manifold.count; ++i) {
          const Point& p = one.manifold.points[i];
          double nearest = 1e300;
          for (int k = 0; k < two.manifold.count; ++k)
            nearest = std::min(nearest, distance(p.on_a, two.manifold.points[k].on_b) + distance(p.on_b, two.manifold.points[k].on_a));
          CHECK(nearest < 1e-4);
        }
      }
}

TEST_CASE("pairs: moving and turning both moves and turns what is found", "[physics][pairs]") {
  Random random(5);
  for (const Convex& a : one_of_each())
    for (const Convex& b : one_of_each())
      for (int round = 0; round < 10; ++round) {
        const Pose at_a = random.pose(0.4), at_b = random.pose(0.4);
        const Pose moved{random.vector(1000), random.rotation()};
        const Look here = look(a, at_a, b, at_b), there = look(a, moved * at_a, b, moved * at_b);
        INFO("kinds " << a.kind << " and " << b.kind << ", round " << round);
        REQUIRE(here.found == there.found);
        if (!here.found) continue;
        CHECK(distance(moved.rotation * here.manifold.normal, there.manifold.normal) < 1e-3);
        CHECK(here.least() == Approx(there.least()).margin(1e-6));
      }
}

TEST_CASE("pairs: ten thousand pairs at any place give finite numbers", "[physics][pairs]") {
  Random random(6);
  const std::vector<Convex> shapes = one_of_each();
  for (int round = 0; round < 10000; ++round) {
    const Convex &a = shapes[static_cast<std::size_t>(round) % 7], &b = shapes[static_cast<std::size_t>(round / 7) % 7];
    // Places and turns of few values bring shapes exactly onto one another.
    const auto coarse = [&] { return std::round(random.between(-3, 3)) * 0.1; };
    const bool exact = round % 2 == 0;
    const Quat quarter = axis_angle({0, 0, 1}, kPi / 2 * std::round(random.between(0, 3)));
    const Pose at_a{}, at_b = exact ? Pose{{coarse(), coarse(), coarse()}, quarter} : random.pose(0.6);
    const Look seen = look(a, at_a, b, at_b);
    if (!seen.found) continue;
    const Manifold& m = seen.manifold;
    bool finite = is_finite(m.normal) && std::abs(length(m.normal) - 1) < 1e-9;
    for (int i = 0; i < m.count; ++i)
      finite = finite && is_finite(m.points[i].on_a) && is_finite(m.points[i].on_b) && std::isfinite(m.points[i].separation);
    INFO("round " << round << ", kinds " << a.kind << " and " << b.kind);
    REQUIRE(finite);
  }
}

TEST_CASE("pairs: a box as such and as a polyhedron give the same points", "[physics][pairs]") {
  Random random(8);
  const Vec3 half{0.3, 0.4, 0.5};
  const Polyhedron solid = make_box_polyhedron(half);
  const Convex box = make_box(half), same = make_solid(solid);
  int found = 0;
  for (int round = 0; round < 500; ++round) {
    const Pose at_a = random.pose(0.4), at_b = random.pose(0.4);
    const Look one = look(box, at_a, box, at_b), two = look(same, at_a, same, at_b);
    INFO("round " << round);
    REQUIRE(one.found == two.found);
    if (!one.found) continue;
    ++found;
    CHECK(one.least() == Approx(two.least()).margin(1e-9));
    CHECK(distance(one.manifold.normal, two.manifold.normal) < 1e-6);
    CHECK(one.manifold.count == two.manifold.count);
  }
  CHECK(found > 200);
}

TEST_CASE("pairs: what is remembered of the pass before does not change what is found", "[physics][pairs]") {
  Random random(9);
  int found = 0;
  for (const Convex& a : one_of_each())
    for (const Convex& b : one_of_each()) {
      if (a.kind == Convex::triangle || b.kind == Convex::triangle) continue;
      Pose at_a = random.pose(0.4);
      const Pose at_b = random.pose(0.4);
      Cache cache;
      // Wanders, drawn to a distance at which the two just touch.
      for (int pass = 0; pass < 150; ++pass) {
        Look kept;
        kept.found = collide(a, at_a, b, at_b, 0.1, cache, kept.manifold);
        const Look fresh = look(a, at_a, b, at_b);
        INFO("kinds " << a.kind << " and " << b.kind << ", pass " << pass);
        REQUIRE(kept.found == fresh.found);
        if (kept.found) {
          ++found;
          // While shapes overlap a little, a direction is kept though another may become somewhat less deep.
          REQUIRE(kept.least() == Approx(fresh.least()).margin(1e-4 + 0.2 * std::abs(fresh.least())));
          at_a.position += fresh.manifold.normal * (-0.5 * fresh.least());
        } else {
          at_a.position = lerp(at_a.position, at_b.position, 0.1);
        }
        at_a.position += random.vector(0.004);
        at_a.rotation = normalized(axis_angle(random.direction(), 0.02) * at_a.rotation);
      }
    }
  CHECK(found > 3000);
}

// One point would let them turn about it, and sink in further on all sides of it.
TEST_CASE("pairs: what was driven deep into each other is held apart all over", "[physics][pairs]") {
  Random random(5);
  const Convex cylinder = make_cylinder(0.4, 0.4);
  int deep = 0, wide = 0;
  for (const Convex& other : {make_box({0.45, 0.35, 0.4}), make_cylinder(0.35, 0.3), make_cone(0.5, 0.4)})
    for (int trial = 0; trial < 500; ++trial) {
      const Pose at_a{{}, random.rotation()}, at_b{random.direction() * 0.5, random.rotation()};
      Cache cache;
      Manifold found;
      Nearest out;
      if (!collide(cylinder, at_a, other, at_b, 0, cache, found) || !closest(cylinder, at_a, other, at_b, 0, out)) continue;
      if (out.separation > -0.05) continue;
      check_sound(found, 0);
      double deepest = 0;
      for (int i = 0; i < found.count; ++i) deepest = std::min(deepest, found.points[i].separation);
      CHECK(deepest == Approx(out.separation).margin(1e-4));
      ++deep;
      wide += found.count >= 2;
    }
  REQUIRE(deep > 500);
  CHECK(wide > 0.6 * deep);  // along an edge and a side that cross there is but one
}

// Their lines stay along each other as it goes, so that the direction of before seems to hold: it would stop what slides past.
TEST_CASE("pairs: an upright capsule that comes along an edge is told where the edge now is", "[physics][pairs]") {
  const Convex capsule = make_capsule(0.3, 0.6), tile = make_box({0.5, 0.5, 0.5});
  Cache cache;
  for (double x = -0.3; x < 0; x += 0.02) {
    const Pose at{{x, 0, 0.3}, {}}, beside{{0.5, 0, -0.5}, {}};
    Manifold found;
    REQUIRE(collide(capsule, at, tile, beside, 0.2, cache, found));
    const double way = std::hypot(x, 0.3);
    CHECK(found.normal.x == Approx(x / way).margin(1e-3));
    CHECK(found.points[0].separation == Approx(way - 0.3).margin(1e-6));
    CHECK(found.count == 2);
  }
}
