// Bounce height and count: what a restitution of e gives back, and when a ball that bounces ever lower comes to rest.
//
// The first contact falls anywhere in a step, and an engine that takes the gap before it off the speed shows that only
// over many shifted starts. So does one that repairs an overlap with speed, at e = 1 over many bounces.
#include "accuracy/cases/impact/arc.h"
#include "accuracy/scenes.h"

namespace tumble::accuracy {

namespace {

constexpr double kGoal = 0.005;      // at 60 Hz
constexpr double kGoalFine = 0.001;  // at 240 Hz
constexpr double kHeight = 2;        // m below the body at the start
constexpr double kHalf = 0.2;        // m: radius of the ball, half the edge of the box

// As many bodies side by side as there are phases, each from another height; fewer ones spread over a step as well.
struct Row {
  std::vector<BodyIndex> bodies;
  std::vector<double> starts;  // clearance, m
};

Row add_row(Simulation& scene, int count, const Shape& shape, double e) {
  add_floor(scene);
  Row row;
  for (int i = 0; i < count; ++i) {
    row.starts.push_back(kHeight + 0.0071 * (i * 5 % 32));
    const Vec3 at{2.0 * (i % 8) - 7, row.starts.back() + kHalf, 2.0 * (i / 8) - 3};
    row.bodies.push_back(scene.add(with(dynamic(shape, 1), 0, e), {at, {}}));
  }
  return row;
}

Sample sample(const Simulation& scene, BodyIndex body) { return {scene.pose(body).position.y - kHalf, scene.velocity(body).y}; }

Outcome first_bounce(Trial& trial, const Shape& shape, double e, double frame) {
  Simulation& scene = trial.scene();
  const Row row = add_row(scene, trial.phases(), shape, e);
  const std::size_t count = row.bodies.size();
  std::vector<Sample> last;
  for (const BodyIndex body : row.bodies) last.push_back(sample(scene, body));
  std::vector<double> highest(count, -1);  // since it left the floor
  std::vector<bool> bounced(count, false);

  // At e = 1 the highest one is up again after 1.36 s.
  run(scene, 1.4, frame, [&](double) {
    for (std::size_t i = 0; i < count; ++i) {
      const Sample now = sample(scene, row.bodies[i]);
      if (bounced[i]) highest[i] = std::max(highest[i], Arc{last[i], now, frame}.highest());
      // In flight a speed only falls.
      else if (now.speed > last[i].speed) bounced[i] = true, highest[i] = now.place;
      last[i] = now;
    }
    return true;
  });

  Spread ratio;
  Outcome outcome;
  for (std::size_t i = 0; i < count; ++i) {
    ratio.add(highest[i] / row.starts[i]);
    if (highest[i] < -kHalf) outcome.failed = "fell through the floor";
  }
  // Both heights together, so that e = 0 too has a reference to miss.
  const double whole = trial.reference(1 + e * e);
  outcome.bias = 1 + ratio.mean() - whole;
  outcome.worst = std::max(std::abs(1 + ratio.low - whole), std::abs(1 + ratio.high - whole));
  outcome.error = *outcome.worst;
  return outcome;
}

// The last bounces are below every engine's threshold. So the time is that at which the ball for the last time falls
// through a level between the heights of two bounces that leave at about 0.3 m/s, as a part of the time of all bounces.
Outcome rest(Trial& trial, double e) {
  const auto all = [e](double height) { return std::sqrt(2 * height / kGravity) * (1 + e) / (1 - e); };
  Simulation& scene = trial.scene();
  const Row row = add_row(scene, trial.phases(), ball(kHalf), e);
  const std::size_t count = row.bodies.size();
  std::vector<double> levels, truths, times(count, 0);
  for (const double start : row.starts) {
    double leaves = e * std::sqrt(2 * kGravity * start), time = std::sqrt(2 * start / kGravity);
    for (; leaves * e >= 0.3; leaves *= e) time += 2 * leaves / kGravity;
    const double level_speed = leaves * std::sqrt(e);  // of leaving, that would just reach it
    levels.push_back(level_speed * level_speed / (2 * kGravity));
    truths.push_back(time + leaves * (1 + std::sqrt(1 - e)) / kGravity);
  }
  std::vector<Sample> last;
  for (const BodyIndex body : row.bodies) last.push_back(sample(scene, body));

  run(scene, all(kHeight + 0.25) + 0.5, kFrame, [&](double time) {
    for (std::size_t i = 0; i < count; ++i) {
      const Sample now = sample(scene, row.bodies[i]);
      if (last[i].place > levels[i] && now.place <= levels[i]) times[i] = time - kFrame + Arc{last[i], now, kFrame}.falls_to(levels[i]);
      last[i] = now;
    }
    return true;
  });

  Spread error;
  for (std::size_t i = 0; i < count; ++i) error.add((times[i] - trial.reference(truths[i])) / all(row.starts[i]));
  Outcome outcome;
  outcome.bias = error.mean();
  outcome.worst = outcome.error = std::max(std::abs(error.low), std::abs(error.high));
  return outcome;
}

// 49 balls of 10 kg from 5 m, as in SimBenchmark: they should bounce for ever.
Outcome endless(Trial& trial) {
  Simulation& scene = trial.scene();
  add_floor(scene);
  std::vector<BodyIndex> balls;
  std::vector<double> starts;
  for (int i = 0; i < 49; ++i) {
    balls.push_back(scene.add(with(dynamic(ball(0.1), 10), 0, 1), {{2.0 * (i % 7) - 6, 5 + 0.0071 * i, 2.0 * (i / 7) - 6}, {}}));
    starts.push_back(energy(scene, balls.back()));
  }

  double squares = 0, drift = 0;
  int count = 0;
  run(scene, trial.shortened(20, trial.effort() == Effort::test ? 2 : 6), kFrame, [&](double) {
    drift = 0;
    for (std::size_t i = 0; i < balls.size(); ++i) {
      const double now = energy(scene, balls[i]), off = now / trial.reference(starts[i]) - 1;
      squares += off * off;
      drift += (now / starts[i] - 1) / static_cast<double>(balls.size());
      ++count;
    }
    return true;
  });

  Outcome outcome;
  outcome.error = std::sqrt(squares / count);
  outcome.energy_drift = drift;
  return outcome;
}

}  // namespace

Case a03_bounce() {
  Case c{"A03", "Bounce height and count", "balls (and boxes) fall from 2 m and a little more each on a floor; 49 balls from 5 m",
         "F: h1 / h0 = e^2; all bounces take sqrt(2 h0 / g) (1 + e) / (1 - e)",
         "|h1 / h0 - e^2|, worst of the phases; rest: error of the last falls' time over all bounces' time; endless: RMS error of the energy", {}};
  const auto number = [](double x) { return std::to_string(x).substr(0, x == 0 || x == 1 ? 1 : x == 0.95 ? 4 : 3); };
  for (const double e : {0.0, 0.3, 0.5, 0.8, 0.95, 1.0})
    c.parts.push_back({"e " + number(e), kGoal, [e](Trial& t) { return first_bounce(t, ball(kHalf), e, kFrame); }});
  for (const double e : {0.8, 1.0})
    c.parts.push_back({"e " + number(e) + ", 240 Hz", kGoalFine, [e](Trial& t) { return first_bounce(t, ball(kHalf), e, kFrame / 4); }});
  c.parts.push_back({"e 1, box", kGoal, [](Trial& t) { return first_bounce(t, box({2 * kHalf, 2 * kHalf, 2 * kHalf}), 1, kFrame); }});
  for (const double e : {0.5, 0.8, 0.9}) c.parts.push_back({"rest, e " + number(e), kGoal, [e](Trial& t) { return rest(t, e); }});
  c.parts.push_back({"endless, e 1", kGoal, endless});
  return c;
}

}  // namespace tumble::accuracy
