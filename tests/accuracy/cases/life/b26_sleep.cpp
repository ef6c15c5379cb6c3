// Who sleeps must wake for everything that concerns it, within one step and with its whole island; who only moves
// slowly, or stands still for a moment, must not fall asleep. Stock Bullet fails at both.
#include <algorithm>

#include "accuracy/cases/life/verdict.h"

namespace tumble::accuracy {

namespace {

SceneSettings with_sleep(Vec3 gravity = {0, -kGravity, 0}) {
  SceneSettings settings;
  settings.gravity = gravity;
  settings.sleeping = true;
  return settings;
}

BodyDef cube() { return with(dynamic(box({1, 1, 1}), 1), 0.5); }

// Puts the cubes to sleep, does something, and counts the steps until all of them are awake.
Outcome wakes(Trial& trial, Simulation& scene, const std::vector<BodyIndex>& bodies, const std::function<void()>& disturb) {
  Verdict verdict;
  const auto all = [&](bool asleep) {
    return std::all_of(bodies.begin(), bodies.end(), [&](BodyIndex body) { return scene.asleep(body) == asleep; });
  };
  run(scene, 10, kFrame, [&](double) { return !all(true); });
  if (!verdict.require(all(true), "never fell asleep")) return verdict.outcome;

  disturb();
  int steps = 0;
  do {
    scene.step(kFrame);
    ++steps;
  } while (!all(false) && steps < 60);
  verdict.require(all(false), "still asleep after 1 s");
  verdict.allow(std::abs(steps - trial.reference(1.0)), 0.009);
  return verdict.outcome;
}

struct Stack {
  Simulation& scene;
  BodyIndex floor, lower, upper;
  std::vector<BodyIndex> both() const { return {lower, upper}; }
};
Stack stack(Trial& trial) {
  Simulation& scene = trial.scene(with_sleep());
  const BodyIndex floor = add_floor(scene);
  const BodyIndex lower = scene.add(cube(), {{0, 0.5, 0}, {}});
  return {scene, floor, lower, scene.add(cube(), {{0, 1.5, 0}, {}})};
}

// A ball that does not sleep comes in and hits the upper cube; the step of the hit is the one that counts.
Outcome touch(Trial& trial) {
  const Stack s = stack(trial);
  Simulation& scene = s.scene;
  return wakes(trial, scene, s.both(), [&] {
    BodyDef def = dynamic(ball(0.3), 1);
    def.velocity = {-5, 0, 0};
    def.can_sleep = false;
    const BodyIndex hitter = scene.add(def, {{3, 1.5, 0}, {}});
    // To where one more step makes it touch.
    run(scene, 2, kFrame, [&](double) { return scene.pose(hitter).position.x - 5 * kFrame > 0.8; });
  });
}

// 20 cubes in a row, shoved at one end: an island.
Outcome push_chain(Trial& trial) {
  Simulation& scene = trial.scene(with_sleep());
  add_floor(scene);
  std::vector<BodyIndex> row;
  for (int i = 0; i < 20; ++i) row.push_back(scene.add(cube(), {{static_cast<double>(i), 0.5, 0}, {}}));
  return wakes(trial, scene, row, [&] { scene.set_velocity(row[0], {2, 0, 0}); });
}

Outcome support_removed(Trial& trial) {
  const Stack s = stack(trial);
  return wakes(trial, s.scene, s.both(), [&] { s.scene.remove(s.floor); });
}

Outcome joint_target(Trial& trial) {
  Simulation& scene = trial.scene(with_sleep());
  const BodyIndex base = scene.add(fixed(box({0.2, 0.2, 0.2})), {});
  const BodyIndex arm = scene.add(dynamic(box({1, 0.1, 0.1}), 1), {{0.6, 0, 0}, {}});
  HingeDef hinge;
  hinge.angle.min = hinge.angle.max = 0;
  JointSpec spec = joint(arm, base, {-0.6, 0, 0}, hinge, {0, 0, 1});
  const JointIndex index = scene.add(spec);
  return wakes(trial, scene, {arm}, [&] {
    hinge.angle.min = hinge.angle.max = 0.5;
    spec.def.kind = hinge;
    scene.configure_joint(index, spec.def);
  });
}

Outcome gravity_change(Trial& trial) {
  const Stack s = stack(trial);
  return wakes(trial, s.scene, s.both(), [&] { s.scene.set_gravity({0, 5, 0}); });
}

// What is done to the lower cube wakes the upper one as well.
Outcome done_to_lower(Trial& trial, const std::function<void(Simulation&, BodyIndex)>& act) {
  const Stack s = stack(trial);
  return wakes(trial, s.scene, s.both(), [&] { act(s.scene, s.lower); });
}

Outcome neighbour_teleported(Trial& trial) {
  const Stack s = stack(trial);
  return wakes(trial, s.scene, {s.upper}, [&] { s.scene.teleport(s.lower, {{5, 0.5, 0}, {}}); });
}

Outcome mover_starts(Trial& trial) {
  Simulation& scene = trial.scene(with_sleep());
  const BodyIndex plate = scene.add(kinematic(box({4, 1, 4})), {{0, -0.5, 0}, {}});
  const BodyIndex lower = scene.add(cube(), {{0, 0.5, 0}, {}}), upper = scene.add(cube(), {{0, 1.5, 0}, {}});
  return wakes(trial, scene, {lower, upper}, [&] { scene.move(plate, {{0.02, -0.5, 0}, {}}); });
}

// A trigger that passes must not wake it, though it reports it.
Outcome trigger_only(Trial& trial) {
  const Stack s = stack(trial);
  run(s.scene, 10, kFrame, [&](double) { return !s.scene.asleep(s.lower) || !s.scene.asleep(s.upper); });
  Verdict verdict;
  verdict.require(s.scene.asleep(s.lower) && s.scene.asleep(s.upper), "never fell asleep");
  BodyDef zone = fixed(box({3, 3, 3}));
  zone.trigger = true;
  s.scene.take_crossings();
  s.scene.add(zone, {{0, 1, 0}, {}});
  double events = 0;
  run(s.scene, 0.5, kFrame, [&](double) {
    verdict.require(s.scene.asleep(s.lower) && s.scene.asleep(s.upper), "woken by a trigger");
    for (const Crossing& crossing : s.scene.take_crossings()) events += crossing.visitor == s.lower || crossing.visitor == s.upper;
    return true;
  });
  verdict.allow(std::abs(events - trial.reference(2.0)), 0.009);
  return verdict.outcome;
}

// Through space at 0.5 m/s for 10 s.
Outcome drifter(Trial& trial) {
  Simulation& scene = trial.scene(with_sleep({}));
  const BodyIndex body = scene.add(cube(), {});
  scene.set_velocity(body, {0.5, 0, 0});
  Verdict verdict;
  run(scene, 10, kFrame, [&](double t) { return verdict.require(!scene.asleep(body), "frozen at " + in_seconds(t)); });
  verdict.allow(relative(scene.pose(body).position.x, trial.reference(5.0)), 0.001);
  return verdict.outcome;
}

// A ball on a string, let go at an angle, for two periods: at each turn it stands still for a moment, at the end where
// it began, but for what a large angle adds.
Outcome pendulum(Trial& trial, double length_of_string, double angle) {
  Simulation& scene = trial.scene(with_sleep());
  const BodyIndex hook = scene.add(fixed(ball(0.05)), {});
  const BodyIndex bob = scene.add(dynamic(ball(0.2), 1), Pose{{}, axis_angle({0, 0, 1}, angle)} * Pose{{0, -length_of_string, 0}, {}});
  scene.add(joint(hook, bob, {}, HingeDef{}, {0, 0, 1}));
  Verdict verdict;
  const Vec3 start = scene.pose(bob).position;
  const double inertia = 1 + 0.4 * 0.04 / (length_of_string * length_of_string);
  const double period = 2 * kPi * std::sqrt(length_of_string * inertia / kGravity) * (1 + angle * angle / 16);
  run(scene, 2 * period, kFrame, [&](double t) { return verdict.require(!scene.asleep(bob), "frozen at " + in_seconds(t)); });
  verdict.allow(distance(scene.pose(bob).position, trial.reference(start)), 0.009 * length(start));
  return verdict.outcome;
}

}  // namespace

Case b26_sleep() {
  Case c{"B26", "Sleep and wake", "two cubes asleep on each other (or a row of 20, or a held arm), and something happens; a drifter and pendulums",
         "F: all of the island awake after one step; a trigger wakes nobody; slow movers do not fall asleep", "|steps until awake - 1| / 0.009; worst of measured / allowed", {}};
  c.parts = {{"touch", 1, touch},
             {"push in a row of 20", 1, push_chain},
             {"support removed", 1, support_removed},
             {"joint target", 1, joint_target},
             {"gravity change", 1, gravity_change},
             {"set velocity", 1, [](Trial& t) { return done_to_lower(t, [](Simulation& s, BodyIndex b) { s.set_velocity(b, {2, 0, 0}); }); }},
             {"impulse", 1, [](Trial& t) { return done_to_lower(t, [](Simulation& s, BodyIndex b) { s.apply_impulse(b, {2, 0, 0}, {}); }); }},
             {"force", 1, [](Trial& t) { return done_to_lower(t, [](Simulation& s, BodyIndex b) { s.apply_force(b, {60, 0, 0}); }); }},
             {"scale", 1, [](Trial& t) { return done_to_lower(t, [](Simulation& s, BodyIndex b) { s.configure(b, with(dynamic(box({1.2, 1.2, 1.2}), 1), 0.5)); }); }},
             {"neighbour teleported", 1, neighbour_teleported},
             {"kinematic starts", 1, mover_starts},
             {"trigger only", 1, trigger_only},
             {"drifter 0.5 m/s", 1, drifter},
             {"pendulum 1 m, 30 deg", 1, [](Trial& t) { return pendulum(t, 1, radians(30)); }},
             {"pendulum 10 m, 1 deg", 1, [](Trial& t) { return pendulum(t, 10, radians(1)); }}};
  return c;
}

}  // namespace tumble::accuracy
