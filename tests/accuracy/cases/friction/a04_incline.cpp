// A box on a slope: how far it slides, whether it stays where it should stay, and at which friction it lets go. Gravity
// is tilted instead of the floor, at several azimuths, so that no direction of the solver's is favoured.
#include <algorithm>

#include "accuracy/cases/friction/sliding.h"

namespace tumble::accuracy {

namespace {

constexpr Vec3 kSize{1, 0.5, 1};
constexpr double kMass = 2, kSlide = radians(30), kFriction = 0.3, kSeconds = 2;
constexpr double kStick = radians(20);
const double kWay = kGravity * (std::sin(kSlide) - kFriction * std::cos(kSlide)) * kSeconds * kSeconds / 2;  // 4.712574 m

struct Slope {
  Simulation& scene;
  BodyIndex body;
};

Slope make(Trial& trial, double slope, double azimuth, double friction, Vec3 start = {}) {
  Simulation& scene = trial.scene({on_slope(slope, azimuth)});
  add_floor(scene);
  return {scene, scene.add(with(dynamic(box(kSize), kMass), friction), {start + Vec3{0, kSize.y / 2, 0}, {}})};
}

Outcome slide(Trial& trial, double azimuth) {
  const auto [scene, body] = make(trial, kSlide, azimuth, kFriction);
  run(scene, kSeconds, kFrame);
  Outcome outcome;
  outcome.error = relative(dot(scene.pose(body).position, on_floor(azimuth)), trial.reference(kWay));
  return outcome;
}

// Off the line of fall, by its centre or by a corner that its yaw swings out.
Outcome straight(Trial& trial, double azimuth) {
  const auto [scene, body] = make(trial, kSlide, azimuth, kFriction);
  run(scene, kSeconds, kFrame);
  const Vec3 way = level(scene.pose(body).position);
  const double swing = std::abs(yaw(scene, body)) * std::hypot(kSize.x, kSize.z) / 2;
  Outcome outcome;
  outcome.error = std::max(distance(normalized(way), trial.reference(on_floor(azimuth))), swing / kWay);
  return outcome;
}

Outcome stick(Trial& trial, double azimuth) {
  const Vec3 start{1, 0, 1};
  const auto [scene, body] = make(trial, kStick, azimuth, 0.5, start);
  run(scene, trial.shortened(10, trial.effort() == Effort::test ? 1 : 10), kFrame);
  Outcome outcome;
  outcome.error = distance(level(scene.pose(body).position), trial.reference(start));  // over 1 m, its size
  return outcome;
}

Outcome letting_go(Trial& trial, double azimuth) {
  const double truth = std::tan(kStick);
  const double found = threshold(0.8 * truth, 1.2 * truth, trial.effort() == Effort::test ? 8 : 12, [&](double friction) {
    const auto [scene, body] = make(trial, kStick, azimuth, friction);
    run(scene, kSeconds, kFrame);
    return dot(scene.velocity(body), on_floor(azimuth)) < 1e-3;
  });
  Outcome outcome;
  outcome.error = relative(found, trial.reference(truth));
  return outcome;
}

}  // namespace

Case a04_incline() {
  Case c{"A04", "Slide on an incline", "a box of 1 x 0.5 x 1 m, 2 kg, on a slope: 30 degrees and friction 0.3 for 2 s; 20 degrees and 0.5 for 10 s; 20 degrees and friction found by bisection",
         "F: a = g (sin - mu cos); sticks above mu = tan", "|way - true| / true; off the line of fall over the way; creep in m; |mu - tan| / tan", {}};
  for (const int azimuth : {0, 30, 45}) {
    const std::string name = ", azimuth " + std::to_string(azimuth);
    const double angle = radians(azimuth);
    c.parts.push_back({"way" + name, 2e-3, [angle](Trial& t) { return slide(t, angle); }});
    c.parts.push_back({"straight" + name, 1e-3, [angle](Trial& t) { return straight(t, angle); }});
  }
  for (const int azimuth : {0, 30}) {
    const std::string name = ", azimuth " + std::to_string(azimuth);
    const double angle = radians(azimuth);
    c.parts.push_back({"stick" + name, 1e-4, [angle](Trial& t) { return stick(t, angle); }});
    c.parts.push_back({"threshold" + name, 2e-3, [angle](Trial& t) { return letting_go(t, angle); }});
  }
  return c;
}

}  // namespace tumble::accuracy
