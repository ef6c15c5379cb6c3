// B10, what is left of the motion of a fast body that hit something.
#include "accuracy/cases/impact/b10_parts.h"

namespace tumble::accuracy {

namespace {

constexpr double kFast = 100;    // m/s
constexpr double kLoss = 0.005;  // of a speed: more is a hitch

}  // namespace

// At e = 1 it is back where a mirror would have it; the error is how many steps of way are lost.
Outcome lost_time(Trial& trial) {
  constexpr double radius = 0.1, thickness = 0.01, seconds = 6 * kFrame;
  Simulation& scene = trial.scene({{0, 0, 0}});
  Spread error;
  std::vector<BodyIndex> balls;
  std::vector<double> starts;
  for (int i = 0; i < trial.phases(); ++i) {
    scene.add(fixed(box({thickness, 4, 4})), {{0, 0, 6.0 * i}, {}});
    BodyDef def = swept(with(dynamic(ball(radius), 1), 0, 1));
    def.velocity = {kFast, 0, 0};
    starts.push_back(-1 - kFast * kFrame * i / trial.phases());
    balls.push_back(scene.add(def, {{starts.back(), 0, 6.0 * i}, {}}));
  }
  run(scene, seconds);
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const double touch = -radius - thickness / 2, back = kFast * seconds - (touch - starts[i]);
    error.add((trial.reference(back) - (touch - scene.pose(balls[i]).position.x)) / (kFast * kFrame));
  }
  Outcome outcome;
  outcome.bias = error.mean();
  outcome.worst = outcome.error = std::max(std::abs(error.low), std::abs(error.high));
  return outcome;
}

// At 80 degrees to the normal it keeps its speed along the wall.
Outcome glancing(Trial& trial) {
  Simulation& scene = trial.scene({{0, 0, 0}});
  const Vec3 velocity = Vec3{std::cos(radians(80)), std::sin(radians(80)), 0} * kFast;
  std::vector<BodyIndex> balls;
  for (int i = 0; i < trial.phases(); ++i) {
    scene.add(fixed(box({0.01, 60, 4})), {{0, 0, 6.0 * i}, {}});
    BodyDef def = swept(dynamic(ball(0.1), 1));
    def.velocity = velocity;
    balls.push_back(scene.add(def, {Vec3{0, 0, 6.0 * i} - velocity * (0.1 + kFrame * i / trial.phases()), {}}));
  }
  run(scene, 10 * kFrame);
  double worst = 0;
  for (const BodyIndex body : balls) worst = std::max(worst, relative(scene.velocity(body).y, trial.reference(velocity.y)));
  Outcome outcome;
  outcome.error = worst / kLoss;
  return outcome;
}

// With four steps a second a ball that falls and slides on goes its way along in every one of them.
Outcome long_steps(Trial& trial) {
  constexpr double frame = 0.25, speed = 5;
  Simulation& scene = trial.scene();
  add_floor(scene, 60);
  std::vector<BodyIndex> balls;
  std::vector<double> last;
  for (int i = 0; i < trial.phases(); ++i) {
    BodyDef def = swept(dynamic(ball(0.25), 1));
    def.velocity = {speed, 0, 0};
    last.push_back(-15);
    balls.push_back(scene.add(def, {{last.back(), 3 + 2.0 * i / trial.phases(), 1.0 * i - 16}, {}}));
  }
  Outcome outcome;
  run(scene, 5, frame, [&](double time) {
    for (std::size_t i = 0; i < balls.size(); ++i) {
      const Vec3 now = scene.pose(balls[i]).position;
      outcome.error = std::max(outcome.error, relative(now.x - last[i], trial.reference(speed * frame)) / kLoss);
      last[i] = now.x;
      if (now.y < 0) outcome.failed = "a ball fell through the floor";
      if (time > 4.9 && now.y > 0.5) outcome.failed = "a ball hangs in the air";
    }
    return true;
  });
  return outcome;
}

}  // namespace tumble::accuracy
