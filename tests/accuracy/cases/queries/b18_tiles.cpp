// Flat ground made of tiles: what rolls or slides over it must not feel the edges between them. Bullet's contacts with
// a triangle know nothing of its neighbours, so bodies are braked, kicked and turned aside.
#include "accuracy/cases/life/verdict.h"
#include "accuracy/cases/queries/grounds.h"

namespace tumble::accuracy {

namespace {

constexpr double kSpeed = 5, kAside = 0.23;  // m/s, m: not on an edge

// A runner goes in x; half of its way is behind it in the middle. Rolling ones have friction 0.5, sliding ones none.
struct Runner {
  const char* name;
  BodyDef body;
  Pose start;
};

Runner sphere() {
  Runner r{"sphere", with(dynamic(ball(0.5), 1), 0.5), {{0, 0.5, 0}, {}}};
  r.body.angular_velocity = {0, 0, -kSpeed / 0.5};
  return r;
}
Runner cube() { return {"box", dynamic(box({1, 1, 1}), 1), {{0, 0.5, 0}, {}}}; }
// That fits on one tile beside its edge: a cube of 1 m would stand on the rising tile there, and rightly slide to the middle.
Runner small_cube() { return {"box of 0.4 m", dynamic(box({0.4, 0.4, 0.4}), 1), {{0, 0.2, 0}, {}}}; }
Runner capsule() {
  Runner r{"capsule", dynamic(upright(ShapeKind::capsule, 0.3, 1.8), 1), {{0, 0.9, 0}, {}}};
  r.body.lock_rotation = "xyz";
  return r;
}
// On its side.
Runner cylinder() {
  Runner r{"cylinder", with(dynamic(upright(ShapeKind::cylinder, 0.5, 1), 1), 0.5), {{0, 0.5, 0}, axis_angle({1, 0, 0}, kPi / 2)}};
  r.body.angular_velocity = {0, 0, -kSpeed / 0.5};
  return r;
}

using Ground = std::function<void(Simulation&, const Pose&)>;

Ground of_shape(Shape shape) {
  return [shape](Simulation& scene, const Pose& at) { scene.add(fixed(shape), at); };
}

// Two bodies, or 40, or one of 40 colliders; 1 m thick, side by side along x.
void two_boxes(Simulation& scene, const Pose& at) {
  for (const double x : {-10.0, 10.0}) scene.add(fixed(box({20, 1, 40})), at * Pose{{x, -0.5, 0}, {}});
}
void compound(Simulation& scene, const Pose& at) {
  BodyDef def = fixed(box({1, 1, 10}));
  for (int i = 1; i < 40; ++i) def.colliders.push_back(def.colliders[0]);
  for (int i = 0; i < 40; ++i) def.colliders[static_cast<std::size_t>(i)].offset = {i - 19.5, -0.5, 0};
  scene.add(def, at);
}

// A valley along x, of radius 20 m: the way at its bottom is straight.
double valley(double, double z) {
  const double across = std::abs(z - 0.5) - 0.5;  // the bottom tile is level
  return across <= 0 ? 0 : 20 - std::sqrt(400 - across * across);
}

// The whole scene, gravity too, may lie a little aslant: numbers that happen to be exact then are not.
Outcome cross_ground(Trial& trial, const Runner& runner, const Ground& ground, double tilt) {
  const Quat turn = axis_angle({1, 0.3, 0.7}, tilt);
  SceneSettings settings;
  settings.gravity = turn * settings.gravity;
  Simulation& scene = trial.scene(settings);
  ground(scene, {{}, turn});
  const double seconds = trial.shortened(5, trial.effort() == Effort::test ? 1 : 2.5), start = -0.3 - kSpeed * seconds / 2;
  BodyDef body = runner.body;
  body.velocity = turn * Vec3{kSpeed, 0, 0};
  body.angular_velocity = turn * body.angular_velocity;
  const BodyIndex index = scene.add(body, Pose{{}, turn} * Pose{{start, 0, kAside}, {}} * runner.start);

  Verdict verdict;
  const auto level = [&](Vec3 v) { return conjugate(turn) * v; };
  run(scene, seconds, kFrame, [&](double) {
    const Vec3 v = level(scene.velocity(index)), at = level(scene.pose(index).position);
    verdict.allow(std::abs(v.y), 0.02);
    verdict.allow(std::abs(at.z - kAside), 0.02);
    return verdict.require_finite(scene, index);
  });
  const double way = level(scene.pose(index).position).x - start, speed = level(scene.velocity(index)).x;
  verdict.allow(std::abs(way - trial.reference(kSpeed * seconds)), 0.05);
  verdict.allow(relative(speed, trial.reference(kSpeed)), 0.0099);
  return verdict.outcome;
}

}  // namespace

Case b18_tiles() {
  Case c{"B18", "Edges of flat ground", "a ball and a cylinder that roll, a box and a capsule that slide, at 5 m/s over ground of 1 m tiles",
         "F: x = v t on a plane", "worst of |x error| / 0.05 m, |v - 5| / 0.05, |vy| / 0.02, aside / 0.02 m", {}};
  const auto add = [&](const Runner& runner, const char* name, const Ground& ground, double tilt = 0) {
    c.parts.push_back({std::string(runner.name) + ", " + name, 1, [=](Trial& t) { return cross_ground(t, runner, ground, tilt); }});
  };
  const Ground mesh = of_shape(tiled(ShapeKind::mesh, 20));
  for (const Runner& runner : {sphere(), cube(), capsule(), cylinder()}) {
    add(runner, "mesh", mesh);
    add(runner, "mesh aslant", mesh, 1e-3);
  }
  for (const Runner& runner : {sphere(), cube()}) {
    add(runner, "height field", of_shape(tiled(ShapeKind::height_field, 20)));
    add(runner, "two boxes", two_boxes);
    add(runner, "compound", compound);
    add(runner, "T junctions", of_shape(tiled_with_t_junctions(20)));
  }
  for (const Runner& runner : {sphere(), small_cube()}) add(runner, "valley", of_shape(tiled(ShapeKind::mesh, 20, valley)));
  return c;
}

}  // namespace tumble::accuracy
