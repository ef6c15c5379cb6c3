// Shapes that are hardly shapes: without size, flat, doubled, mirrored, slivers. An engine may refuse them in words or
// mend them; it may not go on with numbers that are no numbers, nor let good bodies fall through a mesh for their sake.
#include "accuracy/cases/life/process.h"
#include "accuracy/cases/life/verdict.h"

namespace tumble::accuracy {

namespace {

constexpr double kRest = 0.0035;  // m off the right height

// Long enough to fall and to lie still.
double fall_seconds(Trial& trial) { return trial.shortened(2, trial.effort() == Effort::test ? 0.9 : 2); }

// Adds a body, or hears why not.
std::optional<BodyIndex> try_add(Simulation& scene, const BodyDef& def, const Pose& pose) {
  try {
    return scene.add(def, pose);
  } catch (const Error&) {
    return {};
  }
}

// A good cube lies on the floor, the odd body falls on it and beside. Where it has a rest height of its own it is told.
Outcome odd_body(Trial& trial, const Shape& shape, std::optional<double> rest = {}) {
  Simulation& scene = trial.scene();
  add_floor(scene);
  const BodyIndex good = scene.add(with(dynamic(box({1, 1, 1}), 1), 0.5), {{0, 0.5, 0}, {}});
  const std::optional<BodyIndex> above = try_add(scene, with(dynamic(shape, 1), 0.5), {{0.1, 2, 0}, {}});
  const std::optional<BodyIndex> beside = try_add(scene, with(dynamic(shape, 1), 0.5), {{3, 1, 0}, {}});

  Verdict verdict;
  run(scene, fall_seconds(trial), kFrame, [&](double) {
    bool well = verdict.require_finite(scene, good);
    for (const auto& odd : {above, beside})
      if (odd) well = verdict.require_finite(scene, *odd) && well;
    return well;
  });
  if (!verdict.outcome.failed.empty()) return verdict.outcome;
  verdict.allow(std::abs(scene.pose(good).position.y - trial.reference(0.5)), kRest);
  for (const auto& odd : {above, beside})
    if (odd) verdict.allow(-scene.pose(*odd).position.y, 0.05);  // on the floor, not below
  if (rest && verdict.require(beside.has_value(), "a shape that can be mended was refused"))
    verdict.allow(std::abs(scene.pose(*beside).position.y - trial.reference(*rest)), kRest);
  return verdict.outcome;
}

Shape mesh(std::vector<Vec3> points) {
  Shape shape;
  shape.shape = ShapeKind::mesh;
  shape.points = std::move(points);
  return shape;
}

// A cube on a ground made of these triangles; refusing the mesh is right where `may_refuse`.
Outcome odd_ground(Trial& trial, std::vector<Vec3> points, bool may_refuse) {
  Simulation& scene = trial.scene();
  Verdict verdict;
  if (!try_add(scene, fixed(mesh(std::move(points))), {})) {
    verdict.require(may_refuse, "a mesh that can be mended was refused");
    return verdict.outcome;
  }
  const BodyIndex cube = scene.add(with(dynamic(box({1, 1, 1}), 1), 0.5), {{0.2, 0.7, 0.1}, {}});
  run(scene, fall_seconds(trial), kFrame, [&](double) { return verdict.require_finite(scene, cube); });
  if (verdict.outcome.failed.empty()) verdict.allow(std::abs(scene.pose(cube).position.y - trial.reference(0.5)), kRest);
  return verdict.outcome;
}

std::vector<Vec3> square(double a) { return {{-a, 0, -a}, {-a, 0, a}, {a, 0, a}, {-a, 0, -a}, {a, 0, a}, {a, 0, -a}}; }

// Some triangles of a good ground have no area: a point, a line, two corners that are one.
Outcome no_area(Trial& trial) {
  std::vector<Vec3> points = square(5);
  for (const Vec3 p : {Vec3{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {-1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0.2, 0, 0.1}, {0.2, 0, 0.1}, {1, 0, 1}}) points.push_back(p);
  return odd_ground(trial, std::move(points), true);
}

// A ground of slivers 20 m long and some 0.4 mm wide.
Outcome slivers(Trial& trial) {
  const int strips = static_cast<int>(trial.shortened(50000, trial.effort() == Effort::test ? 300 : 2500));
  std::vector<Vec3> points;
  for (int i = 0; i < strips; ++i) {
    const double z = -10 + 20.0 * i / strips, next = -10 + 20.0 * (i + 1) / strips;
    for (const Vec3 p : {Vec3{-10, 0, z}, {-10, 0, next}, {10, 0, next}, {-10, 0, z}, {10, 0, next}, {10, 0, z}}) points.push_back(p);
  }
  return odd_ground(trial, std::move(points), false);
}

// The ground mirrored by a negative scale: its triangles run the other way round.
Outcome mirrored_ground(Trial& trial) {
  std::vector<Vec3> points = square(5);
  for (Vec3& p : points) p = scaled(p, Vec3{-1, 1, 1});
  return odd_ground(trial, std::move(points), true);
}

std::vector<Vec3> corners() {
  std::vector<Vec3> points;
  for (int i = 0; i < 8; ++i) points.push_back({i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, i & 4 ? 0.5 : -0.5});
  return points;
}

// Every corner of a cube three times, one of them a hair away.
Outcome doubled_points(Trial& trial) {
  std::vector<Vec3> points;
  for (const Vec3 p : corners())
    for (const double off : {0.0, 0.0, 1e-12}) points.push_back(p + Vec3{off, 0, 0});
  return odd_body(trial, hull(std::move(points)), 0.5);
}

// An engine may even die of it, so it is tried in another process first.
Part guarded(const char* name, Outcome (*run)(Trial&)) {
  return {name, 1, [run](Trial& trial) {
            if (in_new_process([&] { return run(trial).failed; })) return run(trial);
            Verdict verdict;
            verdict.require(false, "the process died or hung");
            return verdict.outcome;
          }};
}

Outcome flat_hull(Trial& trial) { return odd_body(trial, hull({{-0.5, 0, -0.5}, {0.5, 0, -0.5}, {0.5, 0, 0.5}, {-0.5, 0, 0.5}})); }

}  // namespace

Case b28_degenerate() {
  return {"B28", "Degenerate geometry", "odd bodies fall beside and onto a good cube; a cube falls on odd meshes",
          "F: refused in words, or finite for 2 s and at rest at the right height", "worst of measured / allowed",
          {guarded("box of no size", [](Trial& t) { return odd_body(t, box({0, 0, 0})); }),
           guarded("box of no height", [](Trial& t) { return odd_body(t, box({1, 0, 1})); }),
           guarded("ball of no size", [](Trial& t) { return odd_body(t, ball(0)); }),
           guarded("triangles of no area", no_area),
           guarded("flat hull", flat_hull),
           guarded("doubled hull points", doubled_points),
           guarded("hull of 2 points", [](Trial& t) { return odd_body(t, hull({{-0.5, 0, 0}, {0.5, 0, 0}})); }),
           guarded("hull of no points", [](Trial& t) { return odd_body(t, hull({})); }),
           guarded("sliver mesh", slivers),
           guarded("mesh of no triangles", [](Trial& t) { return odd_ground(t, {}, true); }),
           guarded("capsule of no length", [](Trial& t) { return odd_body(t, upright(ShapeKind::capsule, 0.5, 1), 0.5); }),
           guarded("capsule below a ball", [](Trial& t) { return odd_body(t, upright(ShapeKind::capsule, 0.5, 0.2)); }),
           guarded("negative box", [](Trial& t) { return odd_body(t, box({-1, 1, 1})); }),
           guarded("negative ball", [](Trial& t) { return odd_body(t, ball(-0.5)); }),
           guarded("mirrored mesh", mirrored_ground)}};
}

}  // namespace tumble::accuracy
