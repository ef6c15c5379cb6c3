// A collider that changes its size while it rests, in a stack, asleep, on a joint, as a compound, or as the mesh below.
// Bullet keeps contact points of the old size; a body then hangs on nothing, or leaps out of what it overlaps.
#include "accuracy/cases/life/verdict.h"

namespace tumble::accuracy {

namespace {

constexpr double kLeap = 3;         // m/s, the fastest that growth may throw it; falling does not count
constexpr double kSettled = 0.007;  // of the rest height, at most that many m

BodyDef cube(double scale) { return with(dynamic(box(Vec3{1, 1, 1} * scale), scale * scale * scale), 0.6); }

void watch(Simulation& scene, Verdict& verdict, double seconds) {
  run(scene, seconds, kFrame, [&](double) {
    for (BodyIndex body = 1; body < static_cast<Recorder&>(scene).bodies(); ++body) {
      if (!verdict.require_finite(scene, body)) return false;
      const Vec3 v = scene.velocity(body);
      verdict.allow(length(Vec3{v.x, std::max(0.0, v.y), v.z}), kLeap);
    }
    return true;
  });
}

void check_height(Trial& trial, Verdict& verdict, const Simulation& scene, BodyIndex body, double height) {
  verdict.allow(std::abs(scene.pose(body).position.y - trial.reference(height)), kSettled * std::min(1.0, height));
}

void check_mass(Trial& trial, Verdict& verdict, const Simulation& scene, BodyIndex body, double scale) {
  const MassProperties mass = scene.mass_properties(body);
  const double cubed = scale * scale * scale;
  verdict.allow(relative(mass.mass, trial.reference(cubed)), 1e-3);
  verdict.allow(relative(mass.inertia.x, trial.reference(cubed * scale * scale / 6)), 1e-3);
}

Outcome resting(Trial& trial, double scale) {
  Simulation& scene = trial.scene();
  add_floor(scene);
  const BodyIndex body = scene.add(cube(1), {{0, 0.5, 0}, {}});
  run(scene, 0.5);

  Verdict verdict;
  scene.configure(body, cube(scale));
  watch(scene, verdict, 1);
  check_height(trial, verdict, scene, body, scale / 2);
  check_mass(trial, verdict, scene, body, scale);
  return verdict.outcome;
}

// The middle one of three.
Outcome stacked(Trial& trial, double scale) {
  Simulation& scene = trial.scene();
  add_floor(scene);
  for (const double y : {0.5, 1.5, 2.5}) scene.add(cube(1), {{0, y, 0}, {}});
  run(scene, 0.5);

  Verdict verdict;
  scene.configure(2, cube(scale));
  watch(scene, verdict, 1);
  check_height(trial, verdict, scene, 1, 0.5);
  check_height(trial, verdict, scene, 2, 1 + scale / 2);
  check_height(trial, verdict, scene, 3, 1 + scale + 0.5);
  return verdict.outcome;
}

Outcome asleep(Trial& trial, double scale) {
  SceneSettings settings;
  settings.sleeping = true;
  Simulation& scene = trial.scene(settings);
  add_floor(scene);
  const BodyIndex body = scene.add(cube(1), {{0, 0.5, 0}, {}});
  run(scene, 5, kFrame, [&](double) { return !scene.asleep(body); });

  Verdict verdict;
  verdict.require(scene.asleep(body), "never fell asleep");
  scene.configure(body, cube(scale));
  scene.step(kFrame);
  verdict.require(!scene.asleep(body), "was not woken");
  watch(scene, verdict, 1);
  check_height(trial, verdict, scene, body, scale / 2);
  return verdict.outcome;
}

// Hung by the middle of its top from a fixed block, swinging: the anchor is a place of the body and stays where it is.
Outcome jointed(Trial& trial, double scale) {
  Simulation& scene = trial.scene();
  const BodyIndex block = scene.add(fixed(box({0.2, 0.2, 0.2})), {{0, 3, 0}, {}});
  const BodyIndex body = scene.add(cube(1), {{0, 2.5, 0}, {}});
  scene.add(joint(block, body, {}, BallDef{}));
  scene.set_velocity(body, {0, 0, -0.5});
  scene.set_angular_velocity(body, {1, 0, 0});
  run(scene, 0.5);

  Verdict verdict;
  scene.configure(body, cube(scale));
  watch(scene, verdict, 1);
  const double gap = distance(scene.pose(body) * Vec3{0, trial.reference(0.5), 0}, {0, 3, 0});
  verdict.outcome.max_joint_gap = gap;
  verdict.allow(gap, 0.004);
  return verdict.outcome;
}

BodyDef dumbbell(double scale) {
  BodyDef def = cube(scale);
  def.mass = 2 * scale * scale * scale;
  def.colliders.push_back(def.colliders[0]);
  def.colliders[0].offset = Vec3{-0.75, 0, 0} * scale;
  def.colliders[1].offset = Vec3{0.75, 0, 0} * scale;
  return def;
}

Outcome compound(Trial& trial, double scale) {
  Simulation& scene = trial.scene();
  add_floor(scene);
  const BodyIndex body = scene.add(dumbbell(1), {{0, 0.5, 0}, {}});
  run(scene, 0.5);

  Verdict verdict;
  scene.configure(body, dumbbell(scale));
  watch(scene, verdict, 1);
  check_height(trial, verdict, scene, body, scale / 2);
  verdict.allow(relative(scene.mass_properties(body).mass, trial.reference(2 * scale * scale * scale)), 1e-3);
  return verdict.outcome;
}

// Two triangles, a square of 10 m times scale.
BodyDef ground(double scale) {
  Shape mesh;
  mesh.shape = ShapeKind::mesh;
  const double a = 5 * scale;
  mesh.points = {{-a, 0, -a}, {-a, 0, a}, {a, 0, a}, {-a, 0, -a}, {a, 0, a}, {a, 0, -a}};
  return fixed(mesh);
}

// One cube in the middle stays; one near the border goes on standing where the mesh grew, and falls where it shrank.
Outcome mesh(Trial& trial, double scale) {
  Simulation& scene = trial.scene();
  const BodyIndex floor = scene.add(ground(1), {});
  scene.add(cube(1), {{0.3, 0.5, 0.2}, {}});
  scene.add(cube(1), {{4, 0.5, 0.2}, {}});
  run(scene, 0.5);

  Verdict verdict;
  scene.configure(floor, ground(scale));
  constexpr double kSeconds = 0.25;  // of a fall of 0.3 m
  watch(scene, verdict, kSeconds);
  const double fall = scale < 1 ? kGravity * kSeconds * kSeconds / 2 : 0;
  check_height(trial, verdict, scene, 1, 0.5);
  verdict.allow(std::abs(scene.pose(2).position.y - trial.reference(0.5 - fall)), fall > 0 ? 0.05 : 0.0035);
  return verdict.outcome;
}

}  // namespace

Case b21_scaling() {
  Case c{"B21", "Scaling", "a collider is scaled while it rests, in a stack, asleep, on a joint, as compound, as mesh below",
         "F: speed at most 3 m/s, rest height right within 1 s, mass and inertia those of the new size, sleepers woken", "worst of measured / allowed", {}};
  const struct {
    const char* name;
    Outcome (*run)(Trial&, double);
  } scenes[] = {{"resting", resting}, {"stacked", stacked}, {"asleep", asleep}, {"jointed", jointed}, {"compound", compound}, {"mesh", mesh}};
  const struct {
    const char* name;
    double factor;
  } scales[] = {{" x1.5", 1.5}, {" x2", 2}, {" x0.5", 0.5}};
  for (const auto& scene : scenes)
    for (const auto& scale : scales)
      c.parts.push_back({std::string(scene.name) + scale.name, 1, [run = scene.run, s = scale.factor](Trial& t) { return run(t, s); }});
  return c;
}

}  // namespace tumble::accuracy
