// Bad values. That an argument is finite is checked where scripts call (the world's header says whose duty it is), so what
// is left to the world is the body that becomes infinite or NaN inside: by a force whose effect overflows, or a number that
// slipped through. It is put back to where it was and switched off, and the one that it touches stays sound.
#include "accuracy/scenes.h"

namespace tumble::accuracy {

namespace {

constexpr double kHuge = 1e308, kTiny = 1e-310;
constexpr double kNear = 0.004;  // m: how far the two may have moved

using Harm = std::function<void(Simulation&, BodyIndex)>;

// Two cubes, one on the other on a floor; the lower one is harmed.
struct Pair {
  BodyIndex sick = 0, neighbour = 0;
};
Pair add_pair(Simulation& scene) {
  add_floor(scene);
  const BodyIndex sick = scene.add(with(dynamic(box({1, 1, 1}), 1e-3), 0.5), {{0, 0.5, 0}, {}});
  return {sick, scene.add(with(dynamic(box({1, 1, 1}), 1e-3), 1), {{0, 1.5, 0}, {}})};
}

// How far the neighbour is from where it should be in the end, and whether both are sound.
Outcome judge(Trial& trial, const Simulation& scene, const Pair& pair, double height, double sick_way) {
  Outcome outcome;
  if (!finite(scene, pair.neighbour)) outcome.failed = "the neighbour is not finite";
  else if (!finite(scene, pair.sick)) outcome.failed = "the body is not finite";
  outcome.error = std::max(sick_way, std::abs(scene.pose(pair.neighbour).position.y - trial.reference(height))) / kNear;
  if (!(outcome.error < 1e3)) outcome.error = 1e3;  // NaN too
  return outcome;
}

// It is switched off, so that what stood on it falls on the floor. Where it is put back to is asked only where it was
// not moved from there on purpose.
Outcome harmed(Trial& trial, const Harm& harm, bool moved) {
  Simulation& scene = trial.scene();
  const Pair pair = add_pair(scene);
  run(scene, 0.25);

  harm(scene, pair.sick);
  run(scene, 1);

  const double way = moved ? 0 : distance(scene.pose(pair.sick).position, {0, trial.reference(0.5), 0});
  Outcome outcome = judge(trial, scene, pair, 0.5, way);
  if (outcome.failed.empty() && scene.enabled(pair.sick)) outcome.failed = "the body was not switched off";
  return outcome;
}

// A number next to nothing does next to nothing.
Outcome harmless(Trial& trial, const Harm& harm) {
  Simulation& scene = trial.scene();
  const Pair pair = add_pair(scene);
  run(scene, 0.25);

  harm(scene, pair.sick);
  run(scene, 1);

  Outcome outcome = judge(trial, scene, pair, 1.5, distance(scene.pose(pair.sick).position, {0, trial.reference(0.5), 0}));
  if (outcome.failed.empty() && !scene.enabled(pair.sick)) outcome.failed = "the body was switched off";
  return outcome;
}

// A step that is no time must change nothing.
Outcome bad_step(Trial& trial, double seconds) {
  Simulation& scene = trial.scene();
  const BodyIndex body = scene.add(dynamic(ball(0.5), 1), {{0, 10, 0}, {}});
  run(scene, 0.5);
  const double before = scene.pose(body).position.y, speed = scene.velocity(body).y;

  scene.step(seconds);

  Outcome outcome;
  outcome.error = std::max(std::abs(scene.pose(body).position.y - trial.reference(before)), std::abs(scene.velocity(body).y - trial.reference(speed))) / kNear;
  if (!finite(scene, body)) outcome.failed = "the body is not finite";
  if (!(outcome.error < 1e3)) outcome.error = 1e3;  // NaN too
  return outcome;
}

}  // namespace

Case b24_bad_values() {
  Case c{"B24", "Bad values", "a cube becomes infinite or NaN under another one; a step of a length that is none",
         "the body is put back and switched off, its neighbour falls on the floor; such a step changes nothing", "way from where it should be over 4 mm", {}};
  const double nan = std::nan("");
  const std::pair<const char*, Harm> harms[] = {
      {"force 1e308 N", [](Simulation& s, BodyIndex b) { s.apply_force(b, {0, kHuge, 0}); }},
      {"torque 1e308 N m", [](Simulation& s, BodyIndex b) { s.apply_torque(b, {0, kHuge, 0}); }},
      {"impulse 1e308 N s", [](Simulation& s, BodyIndex b) { s.apply_impulse(b, {kHuge, 0, 0}); }},
      {"velocity 1e30 m/s", [](Simulation& s, BodyIndex b) { s.set_velocity(b, {1e30, 0, 0}); }},
      {"spin 1e30 rad/s", [](Simulation& s, BodyIndex b) { s.set_angular_velocity(b, {0, 1e30, 0}); }},
      {"velocity NaN", [nan](Simulation& s, BodyIndex b) { s.set_velocity(b, {nan, 0, 0}); }},
  };
  for (const auto& [name, harm] : harms) c.parts.push_back({name, 1, [harm = harm](Trial& t) { return harmed(t, harm, false); }});
  c.parts.push_back({"position 1e30 m", 1, [](Trial& t) {
                       return harmed(t, [](Simulation& s, BodyIndex b) { s.teleport(b, {{1e30, 0.5, 0}, {}}); }, true);
                     }});
  c.parts.push_back({"denormal impulse", 1, [](Trial& t) {
                       return harmless(t, [](Simulation& s, BodyIndex b) { s.apply_impulse(b, {kTiny, 0, 0}); });
                     }});
  c.parts.push_back({"denormal velocity", 1, [](Trial& t) {
                       return harmless(t, [](Simulation& s, BodyIndex b) { s.set_velocity(b, {kTiny, kTiny, 0}); });
                     }});
  for (const auto& [name, seconds] : {std::pair("step NaN", nan), {"step -1 s", -1.0}, {"step 0 s", 0.0}})
    c.parts.push_back({name, 1, [seconds = seconds](Trial& t) { return bad_step(t, seconds); }});
  return c;
}

}  // namespace tumble::accuracy
