// Rays and moving balls against closed forms. Bullet asks GJK, which stops at a squared distance of 1e-4 and loses a
// centimetre and more; aiming, placing and standing on things all rest on these numbers.
#include "accuracy/cases/queries/closed_forms.h"
#include "accuracy/scenes.h"

namespace tumble::accuracy {

namespace {

constexpr double kGrazing = 1e-6;  // rays that a shape larger or smaller by this part would answer otherwise do not count
constexpr double kReach = 2.2;     // from the origin to beyond every target, m

struct Target {
  std::string name;
  BodyDef body;
  Truth truth;
};

Target target(std::string name, const Shape& shape) {
  return {std::move(name), fixed(shape), [shape](const Line& line) { return meet(shape, line); }};
}

// A sphere of triangles: 8 faces of an octahedron, divided.
Shape triangle_ball(int divisions) {
  Shape shape;
  shape.shape = ShapeKind::mesh;
  const auto point = [&](Vec3 a, Vec3 b, Vec3 c, int i, int j) {
    return normalized(a * (divisions - i - j) + b * i + c * j);
  };
  for (const double x : {1.0, -1.0})
    for (const double y : {1.0, -1.0})
      for (const double z : {1.0, -1.0}) {
        Vec3 a{x, 0, 0}, b{0, y, 0}, c{0, 0, z};
        if (x * y * z < 0) std::swap(b, c);
        for (int i = 0; i < divisions; ++i)
          for (int j = 0; i + j < divisions; ++j) {
            for (const auto& p : {point(a, b, c, i, j), point(a, b, c, i + 1, j), point(a, b, c, i, j + 1)}) shape.points.push_back(p);
            if (i + j + 1 < divisions)
              for (const auto& p : {point(a, b, c, i + 1, j), point(a, b, c, i + 1, j + 1), point(a, b, c, i, j + 1)}) shape.points.push_back(p);
          }
      }
  return shape;
}

Shape hills() {
  Shape shape;
  shape.shape = ShapeKind::height_field;
  constexpr int kCells = 8;
  const auto point = [](int i, int j) {
    const double x = 2.0 * i / kCells - 1, z = 2.0 * j / kCells - 1;
    return Vec3{x, 0.2 * std::sin(3 * x) * std::cos(2 * z), z};
  };
  for (int i = 0; i < kCells; ++i)
    for (int j = 0; j < kCells; ++j)
      for (const auto& p : {point(i, j), point(i, j + 1), point(i + 1, j + 1), point(i, j), point(i + 1, j + 1), point(i + 1, j)}) shape.points.push_back(p);
  return shape;
}

Target compound() {
  const Pose ball_at{{-0.8, 0.1, 0}, {}}, box_at{{0.6, 0, 0.2}, axis_angle({1, 2, 3}, 0.7)};
  const Shape ball_shape = ball(0.5), box_shape = box({0.8, 1.2, 0.6});
  BodyDef body = fixed(ball_shape);
  body.colliders.push_back(fixed(box_shape).colliders[0]);
  body.colliders[0].offset = ball_at.position;
  body.colliders[1].offset = box_at.position;
  body.colliders[1].rotation = box_at.rotation;
  body.center_of_mass = Vec3{};
  const Truth one = at(ball_at, [=](const Line& line) { return meet(ball_shape, line); });
  const Truth two = at(box_at, [=](const Line& line) { return meet(box_shape, line); });
  return {"compound", body, [one, two](const Line& line) { return nearer(one(line), two(line)); }};
}

// A cone in a node of scale 2, 1.5, 1: round shapes take the larger of x and z across, and y along.
Target scaled_cone() {
  return {"scaled cone", fixed(tumble::scaled(upright(ShapeKind::cone, 0.5, 1), {2, 1.5, 1})),
          [](const Line& line) { return meet(upright(ShapeKind::cone, 1, 1.5), line); }};
}

std::vector<Target> targets() {
  return {target("sphere", ball(1)),
          target("box", box({1, 2, 1.5})),
          target("capsule", upright(ShapeKind::capsule, 0.5, 2)),
          target("cylinder", upright(ShapeKind::cylinder, 0.7, 1.6)),
          target("cone", upright(ShapeKind::cone, 0.8, 1.8)),
          target("mesh", triangle_ball(4)),
          target("height field", hills()),
          compound(),
          scaled_cone()};
}

// The truth for the shape grown by a factor about its centre.
std::optional<Meeting> grown(const Truth& truth, const Line& line, double factor) {
  std::optional<Meeting> found = truth({line.origin / factor, line.direction});
  if (found) found->distance *= factor;
  return found;
}

bool grazing(const Truth& truth, const Line& line) {
  const auto small = grown(truth, line, 1 - kGrazing), large = grown(truth, line, 1 + kGrazing);
  return small.has_value() != large.has_value() || (small && std::abs(small->distance - large->distance) > 1e3 * kGrazing);
}

// Is the normal the same all around? Not so at an edge.
bool smooth(const Truth& truth, const Line& line, Vec3 normal) {
  const Vec3 side = normalized(cross(line.direction, std::abs(line.direction.y) < 0.9 ? Vec3{0, 1, 0} : Vec3{1, 0, 0}));
  for (const Vec3 off : {side, -side, cross(side, line.direction), cross(line.direction, side)}) {
    const auto near = truth({line.origin + off * 1e-3, line.direction});
    if (!near || dot(near->normal, normal) < 0.99) return false;
  }
  return true;
}

// A line from far away to somewhere near the middle.
Line aim(Chance& chance, double distance, double reach) {
  const Vec3 from = chance.direction() * distance;
  const Vec3 to = chance.direction() * (reach * std::cbrt(chance.unit()));
  return {from, normalized(to - from)};
}

// What came of many rays.
struct Tally {
  void count(bool right, bool found) {
    ++rays;
    missed += right && !found;
    false_hits += !right && found;
  }
  Outcome outcome() const {
    Outcome outcome;
    if (error.count) outcome.error = std::max(std::abs(error.low), std::abs(error.high));
    outcome.bias = error.mean();
    outcome.worst = outcome.error;
    if (missed + false_hits == 0) return outcome;
    outcome.failed = std::to_string(missed) + " missed and " + std::to_string(false_hits) + " false of " + std::to_string(rays);
    outcome.error = 1;
    return outcome;
  }
  int rays = 0, missed = 0, false_hits = 0;
  Spread error;  // of rays that hit where they should, signed
};

int ray_count(Trial& trial) { return static_cast<int>(trial.shortened(10000, trial.effort() == Effort::test ? 40 : 300)); }

enum class Measure { distance, normal };

// Everything stands at `place`, turned oddly; the truth is computed about the middle, so it has no trouble there.
Outcome rays(Trial& trial, const Target& target, double distance, Vec3 place, Measure measure) {
  Simulation& scene = trial.scene();
  const Pose pose{place, axis_angle({3, 1, 2}, 0.6)};
  scene.add(target.body, pose);
  const Truth truth = at({{}, pose.rotation}, target.truth);
  Chance chance(25);
  Tally tally;
  for (int i = ray_count(trial); i > 0; --i) {
    const Line line = aim(chance, distance, kReach);
    if (grazing(truth, line)) continue;
    const auto right = truth(line);
    const auto found = scene.raycast(place + line.origin, line.direction, 2 * distance);
    tally.count(right.has_value(), found.has_value());
    if (!right || !found) continue;
    if (measure == Measure::distance) tally.error.add(found->distance / trial.reference(right->distance) - 1);
    else if (smooth(truth, line, right->normal)) tally.error.add(tumble::distance(found->normal, trial.reference(right->normal)));
  }
  return tally.outcome();
}

// A ball of 0.3 m flies at something; its centre meets the thing grown by 0.3 m.
Outcome ball_cast(Trial& trial, const Shape& shape, const Truth& truth, const std::function<Line(Chance&)>& aimed) {
  Simulation& scene = trial.scene();
  scene.add(fixed(shape), {});
  Chance chance(26);
  Tally tally;
  for (int i = ray_count(trial); i > 0; --i) {
    const Line line = aimed(chance);
    if (grazing(truth, line)) continue;
    const auto right = truth(line);
    const auto found = scene.cast(ball(0.3), {line.origin, {}}, line.direction, 30);
    tally.count(right.has_value(), found.has_value());
    if (right && found) tally.error.add(found->distance / trial.reference(right->distance) - 1);
  }
  return tally.outcome();
}

constexpr double kBall = 0.3, kFrom = 10;

// At places of a box of 2 m where `free` coordinates vary and the others are corners.
Outcome ball_at_box(Trial& trial, int free) {
  const Vec3 size{2, 2, 2};
  return ball_cast(trial, box(size), [=](const Line& line) { return meet_rounded_box(size, kBall, line); }, [=](Chance& chance) {
    const double u = chance.between(-0.9, 0.9), v = chance.between(-0.9, 0.9);
    const Vec3 on = free == 2 ? Vec3{u, v, 1} : free == 1 ? Vec3{u, 1, 1} : Vec3{1, 1, 1};
    const Vec3 out = free == 2 ? Vec3{0, 0, 1} : free == 1 ? Vec3{0, 1, 1} : Vec3{1, 1, 1};
    const Vec3 from = on + normalized(normalized(out) + chance.direction() * 0.4) * kFrom;
    return Line{from, normalized(on - from)};
  });
}

Outcome ball_at_ball(Trial& trial) {
  return ball_cast(trial, ball(1), [](const Line& line) { return meet(ball(1 + kBall), line); }, [](Chance& chance) { return aim(chance, kFrom, 1.5); });
}

// A wide box whose top is the plane y = 1.
Outcome ball_at_plane(Trial& trial) {
  const Shape wide = box({60, 2, 60});
  return ball_cast(trial, wide, [](const Line& line) { return meet(box({60.0, 2 + 2 * kBall, 60.0}), line); }, [](Chance& chance) {
    const Vec3 from{chance.between(-5, 5), kFrom, chance.between(-5, 5)};
    return Line{from, normalized(Vec3{chance.between(-1, 1), -1, chance.between(-1, 1)})};
  });
}

}  // namespace

Case a25_casts() {
  Case c{"A25", "Rays and casts", "rays from 10 m, 1 km and 10 km at one shape of some metres, also 10 km from the origin; a ball of 0.3 m cast at plane, ball and box",
         "F: closed forms, of shapes grown by the ball for casts", "worst |distance error| / distance; normals: worst |difference|; 1 where a ray misses or hits nothing", {}};
  const Vec3 origin{}, far{7000, 1000, -7000};
  for (const Target& t : targets()) {
    for (const auto& [name, distance] : {std::pair{", 10 m", 10.0}, {", 1 km", 1e3}, {", 10 km", 1e4}})
      c.parts.push_back({t.name + name, 1e-6, [t, d = distance, origin](Trial& trial) { return rays(trial, t, d, origin, Measure::distance); }});
    c.parts.push_back({t.name + ", normals", 1e-5, [t, origin](Trial& trial) { return rays(trial, t, 10, origin, Measure::normal); }});
    c.parts.push_back({t.name + ", far out", 1e-6, [t, far](Trial& trial) { return rays(trial, t, 10, far, Measure::distance); }});
  }
  c.parts.push_back({"ball cast, plane", 1e-6, ball_at_plane});
  c.parts.push_back({"ball cast, ball", 1e-6, ball_at_ball});
  c.parts.push_back({"ball cast, box face", 1e-6, [](Trial& t) { return ball_at_box(t, 2); }});
  c.parts.push_back({"ball cast, box edge", 1e-6, [](Trial& t) { return ball_at_box(t, 1); }});
  c.parts.push_back({"ball cast, box corner", 1e-6, [](Trial& t) { return ball_at_box(t, 0); }});
  return c;
}

}  // namespace tumble::accuracy
