// Steps of every length: none, negative, alternating, random, ten seconds. A step of no time must change nothing, not
// even forget a force; steps that vary must not feed energy into a heap. And frames of every length, as a clock cuts them
// into steps.
#include "accuracy/cases/life/verdict.h"

namespace tumble::accuracy {

namespace {

// Calls step(length) until `seconds` have gone.
void step_by(Simulation& scene, double seconds, const std::function<double()>& length, const std::function<void()>& each) {
  for (double t = 0; t < seconds - 1e-9;) {
    const double dt = std::min(length(), seconds - t);
    scene.step(dt);
    t += dt;
    each();
  }
}

std::function<double()> alternating() {
  return [i = 0]() mutable {
    constexpr double kLengths[] = {1.0 / 240, 1.0 / 15, 1.0 / 60};
    return kLengths[i++ % 3];
  };
}

std::function<double()> random_lengths() {
  return [chance = Chance(25)]() mutable { return chance.between(1e-4, 0.05); };
}

// A force that was given waits through steps of no time, and nothing else moves.
Outcome no_time(Trial& trial, double seconds) {
  Simulation& scene = trial.scene();
  add_floor(scene);
  const BodyIndex resting = scene.add(with(dynamic(box({1, 1, 1}), 1), 0.5), {{0, 0.5, 0}, {}});
  BodyDef def = dynamic(ball(0.5), 2);
  def.gravity_factor = 0;
  def.velocity = {0, 0, 1};
  def.angular_velocity = {1, 2, 3};
  const BodyIndex flying = scene.add(def, {{5, 5, 0}, {}});
  run(scene, 0.1);

  Verdict verdict;
  scene.apply_force(flying, {120, 0, 0});
  const Pose pose = scene.pose(flying), other = scene.pose(resting);
  for (int i = 0; i < 3; ++i) scene.step(seconds);
  verdict.require(scene.pose(flying) == pose && scene.pose(resting) == other, "something moved");
  scene.step(kFrame);
  verdict.allow(relative(scene.velocity(flying).x, trial.reference(60 * kFrame)), 0.005);
  scene.step(kFrame);
  verdict.allow(relative(scene.velocity(flying).x, trial.reference(60 * kFrame)), 0.005);  // it acts through one step
  return verdict.outcome;
}

// 40 boxes fall into a heap: energy never above that of the start by more than 1 % of what the fall gave.
Outcome heap(Trial& trial, const std::function<double()>& length) {
  Simulation& scene = trial.scene();
  add_floor(scene);
  Chance chance(40);
  const int bodies = static_cast<int>(trial.shortened(40, 20));
  for (int i = 0; i < bodies; ++i) {
    const Vec3 at{chance.between(-0.6, 0.6), 1 + 1.1 * (i / 2), (i % 2) * 1.2 - 0.6};
    scene.add(with(dynamic(box({0.6, 0.6, 0.6}), 1), 0.5), {at, chance.rotation()});
  }
  const auto whole = [&] {
    double sum = 0;
    for (BodyIndex body = 1; body <= bodies; ++body) sum += energy(scene, body);
    return sum;
  };

  Verdict verdict;
  const double start = whole(), scale = start - bodies * kGravity * 0.3;
  double highest = start;
  step_by(scene, trial.shortened(20, 5), length, [&] { highest = std::max(highest, whole()); });
  for (BodyIndex body = 1; body <= bodies; ++body) {
    if (!verdict.require_finite(scene, body)) return verdict.outcome;
    verdict.require(scene.pose(body).position.y > 0, "box " + std::to_string(body) + " below the floor");
  }
  verdict.outcome.energy_drift = highest / start - 1;
  verdict.allow(std::abs(highest - trial.reference(start)), 0.01 * scale);
  return verdict.outcome;
}

// The parabola does not care how time is cut.
Outcome flight(Trial& trial, const std::function<double()>& length) {
  Simulation& scene = trial.scene();
  const BodyIndex body = scene.add(dynamic(ball(0.5), 1), {{0, 100, 0}, {}});
  step_by(scene, 2, length, [] {});
  Verdict verdict;
  verdict.allow(relative(100 - scene.pose(body).position.y, trial.reference(2 * kGravity)), 0.009);
  return verdict.outcome;
}

// One step of ten seconds: what rests goes on resting, what flies stays finite.
Outcome ten_seconds(Trial& trial) {
  Simulation& scene = trial.scene();
  add_floor(scene);
  const BodyIndex resting = scene.add(with(dynamic(box({1, 1, 1}), 1), 0.5), {{0, 0.5, 0}, {}});
  const BodyIndex flying = scene.add(dynamic(ball(0.5), 1), {{5, 5, 0}, {}});
  run(scene, 0.5);

  Verdict verdict;
  scene.step(10);
  run(scene, 1);
  verdict.require_finite(scene, flying);
  if (verdict.require_finite(scene, resting)) verdict.allow(distance(scene.pose(resting).position, trial.reference(Vec3{0, 0.5, 0})), 0.004);
  return verdict.outcome;
}

// What is left of a tick where frames end: so much that no rounding takes a tick away, and less than a substep.
constexpr double kRest = 0.03;
constexpr int kMostTicks = 6;

// Boxes in rows above the floor, `ball` beside them in the air with a force that is to act through one step.
struct Crowd {
  Crowd(Trial& trial, int given) : scene(trial.scene({{0, -kGravity, 0}, false, kMostTicks})), boxes(given) {
    add_floor(scene);
    Chance chance(2000);
    const int side = std::max(3, static_cast<int>(std::sqrt(boxes / 5.0)));
    for (int i = 0; i < boxes; ++i) {
      const int x = i % side, z = i / side % side, y = i / (side * side);
      scene.add(with(dynamic(box({0.5, 0.5, 0.5}), 1), 0.5), {{0.6 * x - 0.3 * side, 0.3 + 0.6 * y, 0.6 * z - 0.3 * side}, chance.rotation()});
    }
    BodyDef def = dynamic(ball(0.5), 2);
    def.gravity_factor = 0;
    ball_at = scene.add(def, {{0, 30, 15}, {}});
    scene.apply_force(ball_at, {120, 0, 0});
  }
  void frame(double seconds) {
    const Frame frame = scene.frame(seconds);
    ticks += frame.ticks;
    dropped += frame.dropped;
  }
  Simulation& scene;
  int boxes, ticks = 0;
  double dropped = 0;
  BodyIndex ball_at = 0;
};

// The same to the last bit after as many plain steps, the force included.
void require_same(Verdict& verdict, Trial& trial, const Crowd& framed, double expected_ticks) {
  Crowd plain(trial, framed.boxes);
  for (int i = 0; i < framed.ticks; ++i) plain.scene.step(kFrame);
  verdict.allow(std::abs(framed.ticks - trial.reference(expected_ticks)), 0.5);
  verdict.allow(relative(framed.scene.velocity(framed.ball_at).x, trial.reference(60 * kFrame)), 0.005);
  for (BodyIndex body = 0; body <= framed.ball_at; ++body) {
    if (!verdict.require_finite(framed.scene, body)) return;
    verdict.require(framed.scene.pose(body) == plain.scene.pose(body), "body " + std::to_string(body) + " is not where plain steps take it");
  }
}

// Frames of random lengths, none longer than can be caught up with; the first is too short for a tick.
Outcome catch_up(Trial& trial) {
  Crowd crowd(trial, 40);
  Chance chance(26);
  const double ticks = trial.shortened(600, 300), whole = (ticks + kRest) * kFrame;
  double next = kFrame / 4;
  for (double t = 0; t < whole - 1e-9;) {
    const double length = std::min(next, whole - t);
    crowd.frame(length);
    t += length;
    next = chance.between(0, kMostTicks * kFrame);
  }
  Verdict verdict;
  verdict.require(crowd.dropped == 0, "time was dropped");
  require_same(verdict, trial, crowd, ticks);
  return verdict.outcome;
}

// The computer stops for 3 s while 2000 bodies fall on each other. That frame costs what its most ticks cost, since no more of
// them run; what is left out is told, and the next frame is one as ever.
Outcome hitch(Trial& trial) {
  constexpr int kBefore = 20, kAfter = 20;
  Crowd crowd(trial, static_cast<int>(trial.shortened(2000, 500)));
  crowd.frame((1 + kRest) * kFrame);
  for (int i = 1; i < kBefore; ++i) crowd.frame(kFrame);
  crowd.frame(3);
  Verdict verdict;
  verdict.require(crowd.ticks <= kBefore + kMostTicks, std::to_string(crowd.ticks - kBefore) + " steps in one frame");
  verdict.allow(std::abs(crowd.dropped - trial.reference(3 - kMostTicks * kFrame)), kFrame / 2);
  for (int i = 0; i < kAfter; ++i) crowd.frame(kFrame);
  require_same(verdict, trial, crowd, kBefore + kMostTicks + kAfter);
  return verdict.outcome;
}

}  // namespace

Case b25_time_steps() {
  return {"B25", "Time steps", "a world stepped by 0, -1 and 10 s, by 1/240, 1/15, 1/60 in turn, by random 0 to 50 ms; by its clock",
          "F: no time changes nothing and keeps forces; C: a heap's energy is not above its start by 1 %; F: parabola; frames: as "
          "many plain steps, at most 6 a frame, and the rest told", "worst of measured / allowed",
          {{"dt 0", 1, [](Trial& t) { return no_time(t, 0); }},
           {"dt -1", 1, [](Trial& t) { return no_time(t, -1); }},
           {"dt 10", 1, ten_seconds},
           {"heap, alternating", 1, [](Trial& t) { return heap(t, alternating()); }},
           {"heap, random", 1, [](Trial& t) { return heap(t, random_lengths()); }},
           {"flight, alternating", 1, [](Trial& t) { return flight(t, alternating()); }},
           {"flight, random", 1, [](Trial& t) { return flight(t, random_lengths()); }},
           {"catch-up", 1, catch_up},
           {"hitch of 3 s", 1, hitch}}};
}

}  // namespace tumble::accuracy
