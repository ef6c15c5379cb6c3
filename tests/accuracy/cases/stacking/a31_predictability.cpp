// How far an engine is from its own limit. Where contacts come and go no shared truth exists, but an engine with ever
// smaller steps converges on one of its own: a pile, a jointed figure and a row of dominoes are played for a tenth of
// a second from many moments of a run, at the step under test and at a 64th of it (after Erez, Tassa and Todorov 2015).
// And how fast a difference of a micrometre grows is a quality of its own (Chung and Pollard 2016).
#include <algorithm>

#include "accuracy/cases/stacking/pile.h"

namespace tumble::accuracy {

namespace {

constexpr double kHorizon = 0.1;  // s
constexpr double kNudge = 1e-6;   // m
constexpr double kRoot = 0.70710678118654752;  // of the pairs' friction, 0.5

struct State {
  Pose pose;
  Vec3 velocity, angular_velocity;
};
using States = std::vector<State>;

// A scene as plain data, so that it can be begun anew from any of its moments.
struct Stage {
  std::vector<BodyDef> fixed;
  std::vector<Pose> fixed_at;
  std::vector<BodyDef> bodies;
  States start;
  std::vector<JointSpec> joints;  // partners by place in `bodies`, made where the bodies stand in `start`

  void put(const BodyDef& body, const Pose& pose) {
    bodies.push_back(with(body, kRoot));
    start.push_back({pose, {}, {}});
  }
  void put_fixed(const BodyDef& body, const Pose& pose) {
    fixed.push_back(with(body, kRoot));
    fixed_at.push_back(pose);
  }
};

Simulation& begin(Trial& trial, const Stage& stage, const States& states) {
  Simulation& scene = trial.scene();
  for (std::size_t i = 0; i < stage.bodies.size(); ++i) scene.add(stage.bodies[i], stage.start[i].pose);
  for (std::size_t i = 0; i < stage.fixed.size(); ++i) scene.add(stage.fixed[i], stage.fixed_at[i]);
  for (const JointSpec& joint : stage.joints) scene.add(joint);
  for (std::size_t i = 0; i < states.size(); ++i) {
    const BodyIndex body = static_cast<BodyIndex>(i);
    scene.teleport(body, states[i].pose);
    scene.set_velocity(body, states[i].velocity);
    scene.set_angular_velocity(body, states[i].angular_velocity);
  }
  return scene;
}

States read(const Simulation& scene, std::size_t count) {
  States states;
  for (std::size_t i = 0; i < count; ++i) {
    const BodyIndex body = static_cast<BodyIndex>(i);
    states.push_back({scene.pose(body), scene.velocity(body), scene.angular_velocity(body)});
  }
  return states;
}

States play(Trial& trial, const Stage& stage, const States& from, double frame) {
  Simulation& scene = begin(trial, stage, from);
  run(scene, kHorizon, frame);
  return read(scene, from.size());
}

// Moments of one run, evenly over its time.
std::vector<States> moments(Trial& trial, const Stage& stage, double seconds, int count) {
  Simulation& scene = begin(trial, stage, stage.start);
  std::vector<States> found;
  double next = seconds / count;
  run(scene, seconds, kFrame, [&](double time) {
    if (time < next - kFrame / 2) return true;
    next += seconds / count;
    found.push_back(read(scene, stage.bodies.size()));
    return true;
  });
  return found;
}

// Root mean squares over all bodies and moments: of the difference of two ways, and of the second.
struct Difference {
  double off = 0, way = 0;
  void add(Trial& trial, const States& from, const States& a, const States& b) {
    for (std::size_t i = 0; i < from.size(); ++i) {
      const Vec3 start = from[i].pose.position, right = trial.reference(b[i].pose.position - start);
      const Vec3 d = a[i].pose.position - start - right;
      off += dot(d, d);
      way += dot(right, right);
    }
  }
  double ratio() const { return std::sqrt(off / way); }
};

Outcome against_limit(Trial& trial, const Stage& stage, double seconds) {
  const int count = as_many(trial, 20, 3, 1);
  const double finer = lasting(trial, 64, 16, 4);
  Difference difference;
  Outcome outcome;
  outcome.worst = 0;
  for (const States& from : moments(trial, stage, seconds, count)) {
    const States coarse = play(trial, stage, from, kFrame), fine = play(trial, stage, from, kFrame / finer);
    difference.add(trial, from, coarse, fine);
    Difference here;
    here.add(trial, from, coarse, fine);
    outcome.worst = std::max(*outcome.worst, here.ratio());
  }
  outcome.error = difference.ratio();
  return outcome;
}

Outcome growth(Trial& trial, const Stage& stage, double seconds) {
  Difference difference;
  Chance chance(31);
  for (const States& from : moments(trial, stage, seconds, as_many(trial, 20, 4, 2))) {
    States nudged = from;
    for (State& state : nudged) state.pose.position += chance.direction() * kNudge;
    difference.add(trial, from, play(trial, stage, nudged, kFrame), play(trial, stage, from, kFrame));
  }
  Outcome outcome;
  outcome.error = difference.ratio();
  return outcome;
}

Stage pile() {
  Stage stage;
  stage.put_fixed(fixed(box({40, 2, 40})), {{0, -1, 0}, {}});
  Chance chance(30);
  for (int i = 0; i < 30; ++i)
    stage.put(dynamic(mixed_shape(Mix::simple, i), 1), {{chance.between(-0.6, 0.6), 0.7 + 0.9 * i, chance.between(-0.6, 0.6)}, chance.rotation()});
  return stage;
}

// Trunk, head, two arms and two legs of two capsules each: balls at neck, shoulders and hips, hinges at elbows and knees.
Stage figure() {
  Stage stage;
  stage.put_fixed(fixed(box({40, 2, 40})), {{0, -1, 0}, {}});
  const double up = 1.2;
  stage.put(dynamic(box({0.4, 0.6, 0.2}), 30), {{0, up + 1.2, 0}, {}});
  const auto hang = [&](int from, const JointKind& kind, Vec3 anchor, const Shape& shape, double mass, Vec3 place) {
    stage.put(dynamic(shape, mass), {place + Vec3{0, up, 0}, {}});
    const Vec3 in_from = anchor + Vec3{0, up, 0} - stage.start[static_cast<std::size_t>(from)].pose.position;
    stage.joints.push_back(joint(from, static_cast<BodyIndex>(stage.bodies.size()) - 1, in_from, kind, {1, 0, 0}));
  };
  hang(0, BallDef{}, {0, 1.55, 0}, ball(0.12), 5, {0, 1.7, 0});
  for (const double side : {-1.0, 1.0}) {
    const int arm = static_cast<int>(stage.bodies.size());
    hang(0, BallDef{}, {0.27 * side, 1.45, 0}, upright(ShapeKind::capsule, 0.05, 0.34), 3, {0.27 * side, 1.28, 0});
    hang(arm, HingeDef{}, {0.27 * side, 1.1, 0}, upright(ShapeKind::capsule, 0.045, 0.34), 2, {0.27 * side, 0.93, 0});
    hang(0, BallDef{}, {0.11 * side, 0.88, 0}, upright(ShapeKind::capsule, 0.08, 0.44), 8, {0.11 * side, 0.66, 0});
    hang(arm + 2, HingeDef{}, {0.11 * side, 0.44, 0}, upright(ShapeKind::capsule, 0.06, 0.44), 5, {0.11 * side, 0.22, 0});
  }
  for (State& state : stage.start) state.angular_velocity = {0.5, 0, 1};
  return stage;
}

// Dominoes of 1 x 2 x 0.2 m in a row along x, the first given a push.
constexpr double kDominoHeight = 2, kDominoApart = 1;
Stage dominoes(int count) {
  Stage stage;
  stage.put_fixed(fixed(box({kDominoApart * count + 40, 2, 20})), {{kDominoApart * count / 2, -1, 0}, {}});
  for (int i = 0; i < count; ++i) stage.put(dynamic(box({0.2, kDominoHeight, 1}), 1), {{kDominoApart * i, kDominoHeight / 2, 0}, {}});
  stage.start[0].angular_velocity = {0, 0, -1.5};
  stage.start[0].velocity = {1.5, 0, 0};
  return stage;
}

// Dominoes a second between the fifth and the fifth from the end: each is passed when it leans by 15 degrees.
double wave_speed(Trial& trial, const Stage& stage, double frame) {
  Simulation& scene = begin(trial, stage, stage.start);
  const int last = static_cast<int>(stage.bodies.size()) - 5;
  constexpr int kFirst = 5;
  const double passed_at = std::cos(radians(15));
  double before = 0, times[2] = {0, 0};
  int passed = 0;
  run(scene, 0.5 * last + 3, frame, [&](double time) {
    const int watched = passed == 0 ? kFirst : last;
    const double now = (scene.pose(watched).rotation * Vec3{0, 1, 0}).y;
    if (now < passed_at && before > now) times[passed++] = time - frame * (passed_at - now) / (before - now);
    before = passed == 1 && watched == kFirst ? 1 : now;
    return passed < 2;
  });
  return passed == 2 ? (last - kFirst) / (times[1] - times[0]) : 0;
}

Outcome domino_wave(Trial& trial) {
  const Stage stage = dominoes(as_many(trial, 50, 14, 11));
  const double speed = wave_speed(trial, stage, kFrame);
  const double limit = trial.reference(wave_speed(trial, stage, 1 / lasting(trial, 960, 960, 480)));
  Outcome outcome;
  if (!(speed > 0) || !(limit > 0)) {
    outcome.error = 1;
    outcome.failed = "the wave did not arrive";
    return outcome;
  }
  outcome.bias = (speed - limit) / limit;
  outcome.error = std::abs(*outcome.bias);
  return outcome;
}

}  // namespace

Case a31_predictability() {
  return {"A31", "Self-consistency", "a pile of 30 mixed bodies, a jointed figure that falls, dominoes; each played 0.1 s from 20 moments of a run",
          "S: the same engine at a 64th of the step; dominoes: at 960 Hz", "RMS difference over RMS way of all bodies; after a nudge of 1e-6 m likewise; relative wave speed",
          {{"pile", 1e-2, [](Trial& t) { return against_limit(t, pile(), lasting(t, 4, 4, 2)); }},
           {"figure", 1e-2, [](Trial& t) { return against_limit(t, figure(), 2); }},
           {"dominoes", 1e-2, [](Trial& t) { return against_limit(t, dominoes(as_many(t, 50, 15, 8)), 2); }},
           {"pile, nudged", 1e-4, [](Trial& t) { return growth(t, pile(), lasting(t, 4, 4, 2)); }},
           {"domino wave", 2e-2, domino_wave}}};
}

}  // namespace tumble::accuracy
