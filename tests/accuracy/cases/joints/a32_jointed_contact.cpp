// Contact while jointed: a joint that leaves the tested motion free must not swallow restitution or friction.
//
// The bouncing sphere runs on a vertical slider, is one of two welded to each other, or hangs from a pivot and hits a
// wall. The sliding box is one of two welded, or runs on two crossed rails with a frame of 1 kg between them.
#include "accuracy/cases/joints/mechanisms.h"

namespace tumble::accuracy {

namespace {

constexpr double kRadius = 0.2;

enum class Hold { rail, pair, pivot };

// From so high (m, of free way) to the next highest point, over the way down: e^2.
double bounce_height(Simulation& scene, Hold hold, double restitution, double way) {
  const BodyDef body = with(dynamic(ball(kRadius), 1), 0, restitution);
  BodyIndex bouncer = 0;
  double bottom = kRadius;
  if (hold == Hold::pivot) {  // the wall is met where the arm of 2.5 m hangs straight down
    constexpr double arm = 2.5;
    const double angle = std::acos(1 - way / arm);
    const Vec3 along{std::sin(angle), -std::cos(angle), 0};
    scene.add(fixed(box({1, 1, 1})), {{-0.5 - kRadius, -arm, 0}, {}});
    bouncer = scene.add(body, {along * arm, between({1, 0, 0}, along)});
    scene.add(joint(bouncer, kWorld, {-arm, 0, 0}, HingeDef{}, {0, 0, 1}));
    bottom = -arm;
  } else {
    add_floor(scene);
    bouncer = scene.add(body, {{0, kRadius + way, 0}, {}});
    if (hold == Hold::rail) scene.add(joint(bouncer, kWorld, {}, SliderDef{}));
    else scene.add(joint(scene.add(body, {{1, kRadius + way, 0}, {}}), bouncer, {-0.5, 0, 0}, FixedDef{}));
  }

  bool hit = false;
  double highest = 0;
  run(scene, 3, kFrame, [&](double) {
    const Vec3 velocity = scene.velocity(bouncer);
    const double height = scene.pose(bouncer).position.y - bottom;
    if (!hit) {  // turned round: upward again, or stopped near the bottom
      hit = hold == Hold::pivot ? velocity.x > -1e-3 && height < way / 2 : velocity.y > -1e-3 && height < way / 2;
      return true;
    }
    highest = std::max(highest, height);
    return hold == Hold::pivot ? velocity.x > 1e-3 : velocity.y > 1e-3;
  });
  return highest / way;
}

Outcome bounce(Trial& trial, Hold hold, double restitution) {
  Outcome outcome;
  Spread spread;
  const int phases = trial.effort() == Effort::test ? 2 : trial.phases();
  for (int k = 0; k < phases; ++k) {
    // The whole way, down and up.
    const double way = 1 + bounce_height(trial.scene(), hold, restitution, span(trial, 2, 2, 0.7) + 0.0071 * k);
    spread.add(way - trial.reference(1 + restitution * restitution));
  }
  outcome.bias = spread.mean();
  outcome.error = std::max(std::abs(spread.low), std::abs(spread.high));
  outcome.worst = outcome.error;
  if (!std::isfinite(spread.sum)) outcome.failed = "not a number";
  return outcome;
}

// A box of 2 kg on a plane, gravity tilted by an angle towards x.
struct Slide {
  Simulation& scene;
  BodyIndex box;
};
Slide build(Simulation& scene, Hold hold, double friction) {
  add_floor(scene);
  const BodyDef body = with(dynamic(box({1, 0.5, 1}), 2), friction);
  const BodyIndex slider = scene.add(body, {{0, 0.25, 0}, {}});
  if (hold == Hold::pair) {
    scene.add(joint(scene.add(body, {{0, 0.25, 2}, {}}), slider, {0, 0, -1}, FixedDef{}));
  } else {
    const BodyIndex frame = scene.add(dynamic(box({1, 1, 1}), 1), {{0, 3, 0}, {}});
    scene.add(joint(frame, kWorld, {}, SliderDef{}, {1, 0, 0}));
    scene.add(joint(slider, frame, {}, SliderDef{}, {0, 1, 0}));
  }
  return {scene, slider};
}
SceneSettings tilted(double angle) { return {{kGravity * std::sin(angle), -kGravity * std::cos(angle), 0}, false}; }
// How much of what moves presses on the plane: the frame does not.
double pressing(Hold hold) { return hold == Hold::rail ? 2.0 / 3 : 1; }

Outcome slide(Trial& trial, Hold hold, bool lateral) {
  const double angle = radians(30), friction = 0.3;
  const Slide made = build(trial.scene(tilted(angle)), hold, friction);
  run(made.scene, 2);
  const double way = 2 * kGravity * (std::sin(angle) - friction * std::cos(angle) * pressing(hold));
  const Vec3 at = made.scene.pose(made.box).position;
  Outcome outcome;
  if (lateral) outcome.error = relative(std::abs(at.x) + std::abs(at.z), trial.reference(std::abs(at.x)), way);
  else outcome.error = relative(at.x, trial.reference(way));
  return outcome;
}

Outcome stick(Trial& trial, Hold hold) {
  const Slide made = build(trial.scene(tilted(radians(20))), hold, 0.5 / pressing(hold));
  const double seconds = span(trial, 10, 2, 1);
  run(made.scene, 0.5);  // it comes to rest on the plane
  const double start = made.scene.pose(made.box).position.x;
  run(made.scene, seconds);
  Outcome outcome;
  outcome.error = relative(1 + made.scene.pose(made.box).position.x - start, trial.reference(1), 1);
  return outcome;
}

// The friction at which it just holds, by bisection.
Outcome threshold(Trial& trial, Hold hold) {
  const double truth = std::tan(radians(20)) / pressing(hold);
  double low = 0.8 * truth, high = 1.2 * truth;
  const double seconds = span(trial, 2, 1, 0.4);
  for (int i = static_cast<int>(span(trial, 10, 9, 5)); i > 0; --i) {
    const double friction = (low + high) / 2;
    const Slide made = build(trial.scene(tilted(radians(20))), hold, friction);
    run(made.scene, seconds);
    (length(made.scene.velocity(made.box)) > 1e-3 ? low : high) = friction;
  }
  Outcome outcome;
  outcome.error = relative((low + high) / 2, trial.reference(truth));
  return outcome;
}

}  // namespace

Case a32_jointed_contact() {
  Case c{"A32", "Jointed body in contact", "a sphere that bounces and a box that slides, while a joint leaves just that motion free", "F: as without the joint: e^2, slope with friction, tan(angle)",
         "|h1/h0 - e^2|, worst of the phases; |way - ref| / ref, drift sideways / way; creep / 1 m; |mu - ref| / ref", {}};
  for (const auto& [name, hold] : {std::pair<std::string, Hold>{"rail", Hold::rail}, {"welded pair", Hold::pair}, {"hung", Hold::pivot}})
    for (const double e : {0.0, 0.3, 0.5, 0.8, 0.95, 1.0})
      c.parts.push_back({name + " e " + text(e), 5e-3, [=, hold = hold](Trial& t) { return bounce(t, hold, e); }});
  for (const auto& [name, hold] : {std::pair<std::string, Hold>{"rails", Hold::rail}, {"welded pair", Hold::pair}}) {
    c.parts.push_back({name + " slide", 2e-3, [=, hold = hold](Trial& t) { return slide(t, hold, false); }});
    c.parts.push_back({name + " slide sideways", 1e-3, [=, hold = hold](Trial& t) { return slide(t, hold, true); }});
    c.parts.push_back({name + " stick", 1e-4, [=, hold = hold](Trial& t) { return stick(t, hold); }});
    c.parts.push_back({name + " threshold", 2e-3, [=, hold = hold](Trial& t) { return threshold(t, hold); }});
  }
  return c;
}

}  // namespace tumble::accuracy
