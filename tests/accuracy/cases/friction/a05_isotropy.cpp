// Friction alike in all directions: boxes pushed over a floor in 32 directions stop equally far away, on a straight line.
// Friction per axis (a pyramid instead of a cone) brakes a diagonal push too hard.
#include <algorithm>

#include "accuracy/cases/friction/sliding.h"

namespace tumble::accuracy {

namespace {

constexpr Vec3 kSize{1, 0.5, 1};
constexpr double kFriction = 0.5, kSpeed = 8;
constexpr double kWay = kSpeed * kSpeed / (2 * kFriction * kGravity);  // 6.524 m
struct Ways {
  Spread distance;
  double lateral = 0;  // m, the worst
};

// Each from the same place in a world of its own.
Ways pushed(Trial& trial, bool aligned) {
  const int directions = trial.full() ? 32 : trial.effort() == Effort::quick ? 16 : 3;
  Ways ways;
  for (int i = 0; i < directions; ++i) {
    const double azimuth = 2 * kPi * i / directions;
    Simulation& scene = trial.scene();
    add_floor(scene);
    BodyDef def = with(dynamic(box(kSize), 2), kFriction);
    def.velocity = on_floor(azimuth) * kSpeed;
    const BodyIndex body = scene.add(def, {{0, kSize.y / 2, 0}, axis_angle({0, 1, 0}, aligned ? -azimuth : 0)});
    run(scene, 2, kFrame);
    const Vec3 way = level(scene.pose(body).position);
    ways.distance.add(length(way));
    ways.lateral = std::max(ways.lateral, length(cross(on_floor(azimuth), way)));
  }
  return ways;
}

Outcome mean_way(Trial& trial, bool aligned) {
  Outcome outcome;
  outcome.error = relative(pushed(trial, aligned).distance.mean(), trial.reference(kWay));
  return outcome;
}

Outcome between_directions(Trial& trial, bool aligned) {
  const Spread distance = pushed(trial, aligned).distance;
  Outcome outcome;
  outcome.error = std::abs(distance.high - trial.reference(distance.low)) / kWay;
  return outcome;
}

// Off the line, over the way.
Outcome lateral(Trial& trial, bool aligned) {
  Outcome outcome;
  outcome.error = std::abs(kWay + pushed(trial, aligned).lateral - trial.reference(kWay)) / kWay;
  return outcome;
}

}  // namespace

Case a05_isotropy() {
  Case c{"A05", "Isotropic friction", "boxes of 1 x 0.5 x 1 m, 2 kg, friction 0.5, pushed at 8 m/s in 32 directions", "F: v^2 / (2 mu g) in each direction",
         "|mean - true|, longest less shortest, and worst aside, each over the true way", {}};
  for (const bool aligned : {false, true}) {
    const std::string name = aligned ? ", turned along" : ", axis aligned";
    c.parts.push_back({"way" + name, 2e-3, [=](Trial& t) { return mean_way(t, aligned); }});
    c.parts.push_back({"spread" + name, 1e-3, [=](Trial& t) { return between_directions(t, aligned); }});
    c.parts.push_back({"aside" + name, 1e-3, [=](Trial& t) { return lateral(t, aligned); }});
  }
  return c;
}

}  // namespace tumble::accuracy
