// Toppling: a tall box tips where its weight leaves its base, on a slope or under a push above a certain height, and not
// before. Shows whether a contact's pressure can move to an edge.
#include "accuracy/cases/friction/sliding.h"

namespace tumble::accuracy {

namespace {

constexpr double kWidth = 1, kHeight = 2, kMass = 1;
constexpr double kSeconds = 3, kTipped = 0.1;  // s, rad: the motion away from balance grows by e in 0.4 s

// Whether it has tipped after a while under gravity and, at each step, a push along x at a height over the floor.
bool tips(Trial& trial, Vec3 gravity, double friction, double push, double height) {
  Simulation& scene = trial.scene({gravity});
  add_floor(scene);
  const BodyIndex body = scene.add(with(dynamic(box({kWidth, kHeight, kWidth}), kMass), friction), {{0, kHeight / 2, 0}, {}});
  bool tipped = false;
  run(scene, kSeconds, kFrame, [&](double) {
    tipped = (scene.pose(body).rotation * Vec3{0, 1, 0}).y < std::cos(kTipped);
    if (push > 0) {
      const Vec3 force{push, 0, 0}, point = Vec3{0, height, 0} - Vec3{0, scene.pose(body).position.y, 0};
      scene.apply_force(body, force);
      scene.apply_torque(body, cross(point, force));
    }
    return !tipped;
  });
  return tipped;
}

int halvings(Trial& trial) { return trial.effort() == Effort::test ? 7 : 12; }

Outcome on_a_slope(Trial& trial, double azimuth) {
  const double truth = std::atan(kWidth / kHeight);
  const double found = threshold(0.8 * truth, 1.2 * truth, halvings(trial), [&](double slope) { return tips(trial, on_slope(slope, azimuth), 1, 0, 0); });
  Outcome outcome;
  outcome.error = relative(found, trial.reference(truth));
  return outcome;
}

// It slides under a force F a little above mu m g. About its centre, F (y - h/2) + mu m g h/2 = m g w/2 when it tips.
Outcome pushed(Trial& trial) {
  constexpr double friction = 0.4, weight = kMass * kGravity, force = 1.02 * friction * weight;
  constexpr double truth = kHeight / 2 + weight * (kWidth - friction * kHeight) / 2 / force;  // 1.245 m
  const double found = threshold(0.8 * truth, 1.2 * truth, halvings(trial), [&](double height) { return tips(trial, {0, -kGravity, 0}, friction, force, height); });
  Outcome outcome;
  outcome.error = relative(found, trial.reference(truth));
  return outcome;
}

}  // namespace

Case a29_toppling() {
  Case c{"A29", "Toppling", "a box of 1 x 2 x 1 m on a slope, friction 1, and pushed over a level floor at some height, friction 0.4", "F: tips at atan(1/2); at the height where the push's moment lifts an edge",
         "|critical angle or height, by bisection, - true| / true", {}};
  c.parts = {{"slope", 5e-3, [](Trial& t) { return on_a_slope(t, 0); }}, {"pushed", 5e-3, pushed}};
  return c;
}

}  // namespace tumble::accuracy
