// Half an hour of everything at once: a tower of ten, a hanging chain, a motor, piles asleep. Nothing may creep, leak
// or fall.
#include <malloc.h>

#include "accuracy/cases/life/verdict.h"

namespace tumble::accuracy {

namespace {

double memory() { return static_cast<double>(mallinfo2().uordblks); }  // bytes in use

struct Everything {
  explicit Everything(Simulation& into) : scene(into) {
    add_floor(scene, 200);
    tower();
    chain();
    motor();
    for (int i = 0; i < 30; ++i) pile({-60.0 + 4 * i, 0, 20});
  }

  void add(const BodyDef& def, const Pose& pose) { moving.push_back(scene.add(def, pose)); }

  void tower() {
    for (int i = 0; i < 10; ++i) add(with(dynamic(box({1, 1, 1}), 1), 0.64), {{0, 0.5 + i, 0}, {}});
    top = moving.back();
  }
  void chain() {
    BodyIndex above = scene.add(fixed(box({0.2, 0.2, 0.2})), {{10, 8, 0}, {}});
    for (int i = 0; i < 10; ++i) {
      add(dynamic(box({0.1, 0.5, 0.1}), 1), {{10, 7.75 - 0.5 * i, 0}, {}});
      scene.add(joint(above, moving.back(), {0, i == 0 ? 0 : -0.25, 0}, BallDef{}));
      above = moving.back();
    }
    chain_end = above;
  }
  void motor() {
    const BodyIndex axle = scene.add(fixed(box({0.2, 0.2, 0.2})), {{-10, 5, 0}, {}});
    rotor = scene.add(dynamic(box({2, 0.2, 0.2}), 5), {{-10, 5, 0}, {}});
    HingeDef hinge;
    hinge.angle.motor.emplace();
    hinge.angle.motor->speed = kRate;
    hinge.angle.motor->strength = 100;
    scene.add(joint(rotor, axle, {}, hinge, {0, 0, 1}));
    moving.push_back(rotor);
  }
  void pile(Vec3 at) {
    for (const double x : {-0.3, 0.3}) add(with(dynamic(box({0.5, 0.5, 0.5}), 1), 0.6), {at + Vec3{x, 0.25, 0}, {}});
    add(with(dynamic(box({0.5, 0.5, 0.5}), 1), 0.6), {at + Vec3{0, 0.76, 0}, {}});
  }
  double energy_now() const {
    double sum = 0;
    for (const BodyIndex body : moving) sum += energy(scene, body);
    return sum;
  }

  static constexpr double kRate = 2;  // rad/s
  Simulation& scene;
  std::vector<BodyIndex> moving;
  BodyIndex top = 0, chain_end = 0, rotor = 0;
};

Outcome soak(Trial& trial) {
  SceneSettings settings;
  settings.sleeping = true;
  Everything all(trial.scene(settings));
  run(all.scene, 3);

  Verdict verdict;
  const double start = all.energy_now(), seconds = trial.shortened(trial.effort() == Effort::soak ? 1800 : 60, 5);
  double lowest = INFINITY, fastest = 0, early = 0;
  run(all.scene, seconds, kFrame, [&](double t) {
    if (t < 0.1 * seconds) early = memory();
    if (std::lround(t / kFrame) % 60 != 0) return true;
    for (const BodyIndex body : all.moving) {
      if (!verdict.require_finite(all.scene, body)) return false;
      lowest = std::min(lowest, all.scene.pose(body).position.y);
      fastest = std::max(fastest, length(all.scene.velocity(body)));
    }
    return verdict.require(lowest > 0, "a body below the floor at " + in_seconds(t));
  });
  if (!verdict.outcome.failed.empty()) return verdict.outcome;

  verdict.outcome.energy_drift = all.energy_now() / start - 1;
  verdict.allow(relative(all.energy_now(), trial.reference(start), start), 0.009);
  verdict.allow(memory() - early, 1e6);
  verdict.allow(fastest, 100);
  verdict.allow(std::abs(all.scene.pose(all.top).position.y - trial.reference(9.5)), 0.09);
  verdict.allow(relative(all.scene.angular_velocity(all.rotor).z, trial.reference(Everything::kRate)), 0.009);
  const double gap = std::abs(all.scene.pose(all.chain_end).position.y - trial.reference(3.25));
  verdict.outcome.max_joint_gap = gap;
  verdict.allow(gap, 0.03);
  return verdict.outcome;
}

}  // namespace

Case b29_soak() {
  return {"B29", "Soak", "half an hour with --soak, else a minute, of a tower of 10, a chain of 10 hanging, a hinge motor and 30 piles asleep",
         "C: energy; F: nothing below the floor, memory flat, tower and chain at their height, the motor at its speed", "worst of measured / allowed",
         {{"", 1, soak}}};
}

}  // namespace tumble::accuracy
