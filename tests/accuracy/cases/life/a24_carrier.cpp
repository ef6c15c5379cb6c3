// Kinematic carriers: what stands on a lift, a swaying platform or a turntable goes with it. Engines that put the
// carrier at its end pose before they solve, or move it in the first substep only, let the rider float, lag or slip.
#include "accuracy/scenes.h"

namespace tumble::accuracy {

namespace {

constexpr double kFriction = 0.5;
const Vec3 kPlate{6, 1, 6};
constexpr double kTop = 0.5;   // of the plate, above its middle, m
constexpr double kHalf = 0.5;  // of the rider, a cube of 1 m

struct Ride {
  Simulation& scene;
  BodyIndex plate, rider;
  Vec3 offset() const { return scene.pose(rider).position - scene.pose(plate).position; }
};

Ride board(Simulation& scene, Vec3 velocity) {
  const BodyIndex plate = scene.add(kinematic(box(kPlate)), {});
  BodyDef def = with(dynamic(box({1, 1, 1}), 1), kFriction);
  def.velocity = velocity;
  return {scene, plate, scene.add(def, {{0, kTop + kHalf, 0}, {}})};
}

// Moves the plate along path(t) and calls each(t) after every step.
void drive(const Ride& ride, double seconds, const std::function<Vec3(double)>& path, const std::function<void(double)>& each) {
  const long steps = std::lround(seconds / kFrame);
  for (long i = 1; i <= steps; ++i) {
    const double now = static_cast<double>(i) * kFrame;
    ride.scene.move(ride.plate, {path(now), {}});
    ride.scene.step(kFrame);
    each(now);
  }
}

constexpr double kLift = 2;  // m/s

struct LiftResult {
  double speed = 0, gap = 0;
};
// The mean speed and the largest gap over the second of two seconds.
LiftResult lift(Simulation& scene) {
  const Ride ride = board(scene, {0, kLift, 0});
  Spread speed, gap;
  drive(ride, 2, [](double t) { return Vec3{0, kLift * t, 0}; }, [&](double t) {
    if (t < 1) return;
    speed.add(scene.velocity(ride.rider).y);
    gap.add(std::abs(ride.offset().y - kTop - kHalf));
  });
  return {speed.mean(), gap.high};
}

Outcome lift_speed(Trial& trial) {
  Outcome outcome;
  outcome.error = relative(lift(trial.scene()).speed, trial.reference(kLift));
  return outcome;
}

Outcome lift_substeps(Trial& trial) {
  Outcome outcome;
  for (const int substeps : {1, 2, 4}) {
    const LiftResult result = lift(trial.scene({}, {substeps, trial.knobs().iterations}));
    outcome.error = std::max(outcome.error, relative(result.speed, trial.reference(kLift)));
  }
  return outcome;
}

Outcome lift_gap(Trial& trial) {
  Simulation& scene = trial.scene();
  Outcome outcome;
  const LiftResult result = lift(scene);
  const double height = scene.pose(1).position.y - scene.pose(0).position.y;
  outcome.error = std::max(result.gap, relative(height, trial.reference(kTop + kHalf), 1));
  return outcome;
}

// Starts at rest, at the lowest point: A (1 - cos wt).
Outcome up_and_down(Trial& trial) {
  constexpr double kWay = 0.1, kRate = 2 * kPi * 0.5;
  const Ride ride = board(trial.scene(), {});
  double square = 0;
  int count = 0;
  drive(ride, trial.shortened(10, 4), [](double t) { return Vec3{0, kWay * (1 - std::cos(kRate * t)), 0}; }, [&](double) {
    const double off = ride.offset().y - trial.reference(kTop + kHalf);
    square += off * off;
    ++count;
  });
  Outcome outcome;
  outcome.error = std::sqrt(square / count) / kWay;
  return outcome;
}

Outcome to_and_fro(Trial& trial) {
  constexpr double kWay = 0.5, kRate = 2 * kPi * 0.3;
  const Ride ride = board(trial.scene(), {});
  const auto path = [](double t) { return Vec3{kWay * (1 - std::cos(kRate * t)), 0, 0}; };
  Outcome outcome;
  drive(ride, trial.shortened(10, 10.0 / 3), path, [&](double t) {
    const double slip = std::abs(ride.scene.pose(ride.rider).position.x - trial.reference(path(t).x));
    outcome.error = std::max(outcome.error, slip);
  });
  return outcome;
}

const Vec3 kOnTable{1, kTop + 0.1, 0};

// How far a small box has slipped on a plate that turns under it, m.
double slip_on_turntable(Simulation& scene, double rate, double seconds, Vec3 expected) {
  const BodyIndex table = scene.add(kinematic(box(kPlate)), {});
  BodyDef def = with(dynamic(box({0.2, 0.2, 0.2}), 1), kFriction);
  def.velocity = {0, 0, -rate};
  def.angular_velocity = {0, rate, 0};
  const BodyIndex rider = scene.add(def, {kOnTable, {}});
  double slip = 0;
  const long steps = std::lround(seconds / kFrame);
  for (long i = 1; i <= steps && slip < 0.3; ++i) {
    const Quat turn = axis_angle({0, 1, 0}, rate * static_cast<double>(i) * kFrame);
    scene.move(table, {{}, turn});
    scene.step(kFrame);
    const Vec3 off = scene.pose(rider).position - turn * expected;
    slip = std::max(slip, std::hypot(off.x, off.z));
  }
  return slip;
}

Outcome turntable_holds(Trial& trial) {
  Outcome outcome;
  outcome.error = slip_on_turntable(trial.scene(), 2.0, trial.shortened(10, 3), trial.reference(kOnTable));
  return outcome;
}

// The rate at which it slips away, by 0.25 m within 4 s and not just by an integrator's creep: w = sqrt(mu g / r).
Outcome turntable_limit(Trial& trial) {
  double low = 2.0, high = 2.4;
  const int halvings = trial.full() ? 9 : 7;
  for (int i = 0; i < halvings; ++i) {
    const double middle = (low + high) / 2;
    (slip_on_turntable(trial.scene(), middle, 4, kOnTable) > 0.25 ? high : low) = middle;
  }
  Outcome outcome;
  outcome.error = relative((low + high) / 2, trial.reference(std::sqrt(kFriction * kGravity)));
  return outcome;
}

}  // namespace

Case a24_carrier() {
  Case c{"A24", "Kinematic carrier", "a cube on a lift, on swaying platforms and on a turntable, friction 0.5",
         "F: the rider goes with its carrier; slips on a turntable above sqrt(mu g / r)",
         "lift: |v - 2| / 2, gap in m; up and down: RMS offset / 0.1 m; to and fro, turntable: slip in m, |w - w_limit| / w_limit", {}};
  c.parts = {{"lift, speed", 1e-4, lift_speed},
             {"lift, gap", 1e-3, lift_gap},
             {"lift, 1 2 4 substeps", 1e-4, lift_substeps},
             {"up and down", 1e-2, up_and_down},
             {"to and fro", 1e-3, to_and_fro},
             {"turntable 2.0", 1e-3, turntable_holds},
             {"turntable limit", 2e-3, turntable_limit}};
  return c;
}

}  // namespace tumble::accuracy
