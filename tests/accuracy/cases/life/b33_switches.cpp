// Materials, belts, filters and joints that change under load. The change must show within one step, and no contact
// may answer with more than twice the impulse that it had before.
#include "accuracy/cases/life/verdict.h"

namespace tumble::accuracy {

namespace {

constexpr double kPerStep = 2;       // times the impulse before the change
constexpr double kWatched = 0.25;    // s after the change: one step late shows as 7 %
constexpr double kAllowed = 0.0065;  // of the speed that the change should have given by then

BodyDef slab() { return fixed(box({40, 1, 40})); }
BodyDef block(double friction) { return with(dynamic(box({1, 0.5, 1}), 2), friction); }
const Pose kSlab{{0, -0.5, 0}, {}}, kBlock{{0, 0.25, 0}, {}};

double impulse(const Simulation& scene) {
  double sum = 0;
  for (const Touch& touch : scene.touches()) sum += touch.impulse;
  return sum;
}

// After the change: runs on, and holds the impulses against that of before.
void watch(Simulation& scene, Verdict& verdict, double before) {
  run(scene, kWatched, kFrame, [&](double) {
    verdict.allow(impulse(scene), kPerStep * before);
    return true;
  });
}

// The friction changes, and with it the acceleration: down a slope (gravity is tilted), or braking on the level.
Outcome friction(Trial& trial, double from, double to, double slope, double start) {
  SceneSettings settings;
  settings.gravity = Vec3{std::sin(slope), -std::cos(slope), 0} * kGravity;
  Simulation& scene = trial.scene(settings);
  scene.add(slab(), kSlab);
  const BodyIndex body = scene.add(block(from), kBlock);
  scene.set_velocity(body, {start, 0, 0});
  run(scene, 1);

  Verdict verdict;
  const double before = impulse(scene), speed = scene.velocity(body).x;
  scene.configure(body, block(to));
  watch(scene, verdict, before);
  const double gain = kGravity * (std::sin(slope) - to * std::cos(slope)) * kWatched;
  verdict.allow(relative(scene.velocity(body).x - speed, trial.reference(gain)), kAllowed);
  return verdict.outcome;
}

// A belt of 3 m/s starts under a block at rest: it gains mu g until it has the speed of the belt.
Outcome belt(Trial& trial) {
  constexpr double kBelt = 3, kFriction = 0.5;
  Simulation& scene = trial.scene();
  const BodyIndex ground = scene.add(slab(), kSlab);
  const BodyIndex body = scene.add(block(kFriction), kBlock);
  run(scene, 1);

  Verdict verdict;
  const double before = impulse(scene);
  BodyDef moving = slab();
  moving.surface_velocity = {kBelt, 0, 0};
  scene.configure(ground, moving);
  watch(scene, verdict, before);
  verdict.allow(relative(scene.velocity(body).x, trial.reference(kFriction * kGravity * kWatched)), kAllowed);
  run(scene, 1);
  verdict.allow(relative(scene.velocity(body).x, trial.reference(kBelt)), kAllowed);
  return verdict.outcome;
}

// The block stops meeting the slab it lies on, and falls through.
Outcome filter(Trial& trial) {
  Simulation& scene = trial.scene();
  BodyDef ground = slab();
  ground.group = "ground";
  scene.add(ground, kSlab);
  const BodyIndex body = scene.add(block(0.5), kBlock);
  run(scene, 1);

  Verdict verdict;
  const double before = impulse(scene);
  BodyDef alone = block(0.5);
  alone.collides_with = {"default"};
  scene.configure(body, alone);
  watch(scene, verdict, before);
  verdict.allow(relative(-scene.velocity(body).y, trial.reference(kGravity * kWatched)), kAllowed);
  return verdict.outcome;
}

// A weight of 2 kg on a string, over a slab that it does not touch. The string is cut, or tears when pulled.
struct Hung {
  explicit Hung(Trial& trial, double strength) : scene(trial.scene()) {
    const BodyIndex hook = scene.add(fixed(box({0.2, 0.2, 0.2})), {{0, 5, 0}, {}});
    body = scene.add(block(0), {{0, 4, 0}, {}});
    JointSpec spec = joint(hook, body, {}, BallDef{});
    spec.def.break_force = strength;
    string = scene.add(spec);
    run(scene, 1);
  }
  Simulation& scene;
  BodyIndex body = 0;
  JointIndex string = 0;
};

Outcome cut(Trial& trial) {
  Hung hung(trial, kInfinity);
  Verdict verdict;
  hung.scene.remove_joint(hung.string);
  run(hung.scene, kWatched);
  verdict.allow(relative(-hung.scene.velocity(hung.body).y, trial.reference(kGravity * kWatched)), kAllowed);
  return verdict.outcome;
}

// It holds 50 N and gets 19.62 N and 100 N more: it gives way in that step or the next, having pulled no harder than its due.
Outcome torn(Trial& trial) {
  Hung hung(trial, 50);
  Verdict verdict;
  if (!verdict.require(!hung.scene.joint_state(hung.string).broken, "broke under its own weight")) return verdict.outcome;
  hung.scene.apply_force(hung.body, {0, -100, 0});
  hung.scene.step(kFrame);
  verdict.require(hung.scene.joint_state(hung.string).broken, "did not break within one step");
  const double speed = hung.scene.velocity(hung.body).y;
  verdict.allow(std::abs(speed), (50 + kGravity) * kFrame);  // as if nothing had held it, at most
  run(hung.scene, kWatched);
  verdict.allow(relative(speed - hung.scene.velocity(hung.body).y, trial.reference(kGravity * kWatched)), kAllowed);
  return verdict.outcome;
}

}  // namespace

Case b33_switches() {
  return {"B33", "Changes under load", "a block on a slope or a belt whose material changes, one whose filter changes, a weight whose string is cut or tears",
          "F: velocity after 0.25 s as if the change took no step; impulses at most twice those before", "worst of measured / allowed",
          {{"friction 0.5 to 0", 1, [](Trial& t) { return friction(t, 0.5, 0, radians(20), 0); }},
           {"friction 0 to 0.6", 1, [](Trial& t) { return friction(t, 0, 0.6, 0, 3); }},
           {"belt starts", 1, belt},
           {"filter", 1, filter},
           {"joint cut", 1, cut},
           {"joint torn", 1, torn}}};
}

}  // namespace tumble::accuracy
