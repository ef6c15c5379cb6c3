// Planks, sticks and dominoes: long bodies on edges and faces. They must stand where they stand, lie where they fall,
// and not tremble.
#include <algorithm>

#include "accuracy/cases/friction/sliding.h"

namespace tumble::accuracy {

namespace {

constexpr double kTremble = 0.02;              // m/s after half the time
constexpr double kSink = 0.02, kShift = 0.25;  // of a thickness, of what stands
constexpr double kRough = 0.5;

struct Thing {
  BodyIndex body;
  Vec3 size;
};

constexpr double kThick = 0.2;
constexpr Vec3 kPlank{2, kThick, kThick}, kAcross{kThick, kThick, 2}, kStick{2, 0.1, 0.1}, kDomino{0.2, 2, 1};

// All pairs have the same friction.
void add_rough_floor(Simulation& scene) { scene.add(with(fixed(box({40, 2, 40})), std::sqrt(kRough)), {{0, -1, 0}, {}}); }
Thing add(Simulation& scene, Vec3 size, const Pose& pose, Vec3 spin = {}) {
  BodyDef def = with(dynamic(box(size), 1), std::sqrt(kRough));
  def.angular_velocity = spin;
  return {scene.add(def, pose), size};
}

// The speed of the fastest corner of all in the second half, when they should be calm.
double tremble(Trial& trial, Simulation& scene, const std::vector<Thing>& things) {
  const double seconds = trial.shortened(10, trial.effort() == Effort::test ? 2.5 : 10);
  double speed = 0;
  run(scene, seconds, kFrame, [&](double t) {
    if (t > seconds / 2)
      for (const Thing& thing : things) speed = std::max(speed, fastest_corner(scene, thing.body, thing.size));
    return std::isfinite(speed);
  });
  return speed;
}

Outcome judged(Trial& trial, Simulation& scene, const std::vector<Thing>& things) {
  Outcome outcome;
  outcome.error = tremble(trial, scene, things) / kTremble;
  for (const Thing& thing : things) {
    if (!finite(scene, thing.body)) outcome.failed = "not finite";
    if (scene.pose(thing.body).position.y < 0) outcome.failed = "fell through the floor";
  }
  return outcome;
}

// Adds to the error how far a body has fallen against how far it should, over what is allowed of its thickness.
void check_fall(Trial& trial, Simulation& scene, Outcome& outcome, BodyIndex body, double from, double to, double thickness) {
  outcome.error = std::max(outcome.error, std::abs(from - scene.pose(body).position.y - trial.reference(from - to)) / (kSink * thickness));
}

// Likewise where it should stay as high as it is.
void check_height(Trial& trial, Simulation& scene, Outcome& outcome, BodyIndex body, double height, double thickness) {
  outcome.error = std::max(outcome.error, std::abs(scene.pose(body).position.y - trial.reference(height)) / (kSink * thickness));
}

Outcome crossed_layers(Trial& trial) {
  Simulation& scene = trial.scene();
  add_rough_floor(scene);
  std::vector<Thing> things;
  std::vector<Vec3> starts;
  for (int layer = 0; layer < 5; ++layer)
    for (const double side : {-0.9, 0.9}) {
      const bool along = layer % 2 == 0;
      starts.push_back({along ? 0 : side, kThick * (layer + 0.5), along ? side : 0});
      things.push_back(add(scene, along ? kPlank : kAcross, {starts.back(), {}}));
    }
  Outcome outcome = judged(trial, scene, things);
  for (std::size_t i = 0; i < things.size(); ++i) {
    const Vec3 now = scene.pose(things[i].body).position;
    outcome.error = std::max(outcome.error, length(level(now - starts[i])) / (kShift * kThick));
    if (now.y < starts[i].y - kThick / 2 && outcome.failed.empty()) outcome.failed = "plank " + std::to_string(i) + " fell";
  }
  for (const std::size_t top : {things.size() - 2, things.size() - 1}) check_height(trial, scene, outcome, things[top].body, starts[top].y, kThick);
  return outcome;
}

// Dropped 0.5 m onto a long edge: it rolls over to a face.
Outcome stick_on_edge(Trial& trial) {
  Simulation& scene = trial.scene();
  add_rough_floor(scene);
  const double start = 0.5 + kStick.y * std::sqrt(0.5);
  const Thing stick = add(scene, kStick, {{0, start, 0}, axis_angle({1, 0, 0}, radians(40))});
  Outcome outcome = judged(trial, scene, {stick});
  check_fall(trial, scene, outcome, stick.body, start, kStick.y / 2, kStick.y);
  return outcome;
}

std::vector<Thing> add_dominoes(Simulation& scene, int count) {
  add_rough_floor(scene);
  std::vector<Thing> row;
  for (int i = 0; i < count; ++i) row.push_back(add(scene, kDomino, {{i * 0.8, 1, 0}, {}}));
  return row;
}

double lean(const Simulation& scene, const Thing& thing) { return std::acos(std::clamp((scene.pose(thing.body).rotation * Vec3{0, 1, 0}).y, -1.0, 1.0)); }

Outcome dominoes_stand(Trial& trial) {
  Simulation& scene = trial.scene();
  const std::vector<Thing> row = add_dominoes(scene, 6);
  Outcome outcome = judged(trial, scene, row);
  for (std::size_t i = 0; i < row.size(); ++i) {
    check_height(trial, scene, outcome, row[i].body, kDomino.y / 2, kDomino.x);
    if (lean(scene, row[i]) > radians(5)) outcome.failed = "domino " + std::to_string(i) + " fell";
  }
  return outcome;
}

// The first is pushed at its top; the last has nothing to lean on.
Outcome dominoes_fall(Trial& trial) {
  Simulation& scene = trial.scene();
  const std::vector<Thing> row = add_dominoes(scene, 6);
  scene.apply_impulse(row.front().body, {1, 0, 0}, Vec3{-0.1, 1.9, 0});
  Outcome outcome = judged(trial, scene, row);
  check_fall(trial, scene, outcome, row.back().body, kDomino.y / 2, kDomino.x / 2, kDomino.x);
  for (std::size_t i = 0; i < row.size(); ++i)
    if (lean(scene, row[i]) < radians(30)) outcome.failed = "domino " + std::to_string(i) + " still stands";
  return outcome;
}

Outcome spun(Trial& trial) {
  Simulation& scene = trial.scene();
  add_rough_floor(scene);
  const Thing plank = add(scene, kPlank, {{0, kThick / 2, 0}, {}}, {0, 10, 0});
  Outcome outcome = judged(trial, scene, {plank});
  check_height(trial, scene, outcome, plank.body, kThick / 2, kThick);
  return outcome;
}

}  // namespace

Case b20_planks() {
  Case c{"B20", "Planks", "long bodies, friction 0.5: five crossed layers of planks, a 20:1 stick dropped on an edge, six dominoes of 1 x 2 x 0.2 m, a plank spun at 10 rad/s, 10 s",
         "stands or lies, and is still after 5 s", "the worst of speed after 5 s over 0.02 m/s, sinking over 2 % and shift over 25 % of a thickness", {}};
  c.parts = {{"crossed layers", 1, crossed_layers}, {"stick on edge", 1, stick_on_edge}, {"dominoes stand", 1, dominoes_stand},
             {"dominoes fall", 1, dominoes_fall},   {"spun plank", 1, spun}};
  return c;
}

}  // namespace tumble::accuracy
