// Bodies, supports and joint partners that go away, are switched off or come again in the middle of things. Those who
// leaned on them must notice at once; stock Bullet lets sleepers float.
#include <set>

#include "accuracy/cases/life/verdict.h"

namespace tumble::accuracy {

namespace {

SceneSettings with_sleep() {
  SceneSettings settings;
  settings.sleeping = true;
  return settings;
}

BodyDef cube() { return with(dynamic(box({1, 1, 1}), 1), 0.6); }

// Contacts may name only those who are there.
void check_touches(const Simulation& scene, const std::set<BodyIndex>& gone, Verdict& verdict) {
  for (const Touch& touch : scene.touches())
    verdict.require(!gone.count(touch.a) && !gone.count(touch.b), "a contact of a body that is gone");
}

// Every pair that begins to touch loses its younger body, its older one, or both, in turn.
Outcome on_touch(Trial& trial) {
  Simulation& scene = trial.scene();
  const BodyIndex floor = add_floor(scene);
  Chance chance(22);
  constexpr int kBodies = 60;
  for (int i = 0; i < kBodies; ++i) {
    const Vec3 at{chance.between(-1, 1), 1 + 0.6 * i, chance.between(-1, 1)};
    scene.add(i % 2 ? dynamic(ball(0.3), 1) : dynamic(box({0.5, 0.5, 0.5}), 1), {at, chance.rotation()});
  }

  Verdict verdict;
  std::set<BodyIndex> gone;
  int turn = 0;
  run(scene, 3, kFrame, [&](double) {
    for (const Touch& touch : scene.touches()) {
      ++turn;
      for (const BodyIndex body : {touch.a, touch.b}) {
        const bool goes = body == touch.a ? turn % 3 != 0 : turn % 3 != 1;
        if (body != floor && goes && gone.insert(body).second) scene.remove(body);
      }
    }
    check_touches(scene, gone, verdict);
    for (BodyIndex body = 1; body <= kBodies; ++body)
      if (!gone.count(body) && !verdict.require_finite(scene, body)) return false;
    return true;
  });
  verdict.require(gone.size() > kBodies / 2, "too few met");
  return verdict.outcome;
}

Outcome one_each_step(Trial& trial) {
  Simulation& scene = trial.scene();
  add_floor(scene);
  const int bodies = static_cast<int>(trial.shortened(500, 125));
  Chance chance(23);
  for (int i = 0; i < bodies; ++i) {
    const Vec3 at{0.7 * (i % 5) - 1.4, 0.4 + 0.7 * (i / 25), 0.7 * (i / 5 % 5) - 1.4};
    scene.add(i % 2 ? dynamic(ball(0.3), 1) : dynamic(box({0.6, 0.6, 0.6}), 1), {at, {}});
  }

  Verdict verdict;
  std::vector<BodyIndex> left;
  for (BodyIndex body = 1; body <= bodies; ++body) left.push_back(body);
  std::set<BodyIndex> gone;
  while (!left.empty()) {
    const auto at = left.begin() + static_cast<long>(chance.unit() * static_cast<double>(left.size()));
    scene.remove(*at);
    gone.insert(*at);
    left.erase(at);
    scene.step(kFrame);
    check_touches(scene, gone, verdict);
    for (const BodyIndex body : left) {
      if (!verdict.require_finite(scene, body)) return verdict.outcome;
      verdict.allow(length(scene.velocity(body)), 20);
    }
  }
  verdict.require(scene.contact_points() == 0, "contacts without bodies");
  return verdict.outcome;
}

// Two cubes asleep on a slab: without it they wake within a step and fall.
Outcome support(Trial& trial, bool removed) {
  Simulation& scene = trial.scene(with_sleep());
  const BodyIndex slab = scene.add(fixed(box({4, 1, 4})), {{0, -0.5, 0}, {}});
  const BodyIndex lower = scene.add(cube(), {{0, 0.5, 0}, {}}), upper = scene.add(cube(), {{0, 1.5, 0}, {}});
  run(scene, 5, kFrame, [&](double) { return !scene.asleep(lower) || !scene.asleep(upper); });

  Verdict verdict;
  verdict.require(scene.asleep(lower) && scene.asleep(upper), "never fell asleep");
  if (removed) scene.remove(slab);
  else scene.set_enabled(slab, false);
  scene.step(kFrame);
  for (const BodyIndex body : {lower, upper}) verdict.require(!scene.asleep(body), "body " + std::to_string(body) + " was not woken");
  const double start = scene.pose(upper).position.y, speed = scene.velocity(upper).y;
  constexpr double kSeconds = 2;
  run(scene, kSeconds);
  const double way = kGravity * kSeconds * kSeconds / 2 - speed * kSeconds;
  verdict.allow(relative(start - scene.pose(upper).position.y, trial.reference(way)), 0.009);
  return verdict.outcome;
}

// A cube that is switched off keeps its place and holds nothing; switched on again it falls on.
Outcome switched(Trial& trial) {
  Simulation& scene = trial.scene(with_sleep());
  add_floor(scene);
  const BodyIndex lower = scene.add(cube(), {{0, 0.5, 0}, {}}), upper = scene.add(cube(), {{0, 1.5, 0}, {}});
  run(scene, 5, kFrame, [&](double) { return !scene.asleep(upper); });

  Verdict verdict;
  scene.set_enabled(lower, false);
  scene.step(kFrame);
  verdict.require(!scene.asleep(upper), "was not woken");
  run(scene, 2);
  verdict.allow(std::abs(scene.pose(upper).position.y - trial.reference(0.5)), 0.004);
  verdict.allow(std::abs(scene.pose(lower).position.y - 0.5), 0.01);
  scene.teleport(lower, {{5, 1.5, 0}, {}});
  scene.set_enabled(lower, true);
  run(scene, 2);
  verdict.allow(std::abs(scene.pose(lower).position.y - trial.reference(0.5)), 0.004);
  return verdict.outcome;
}

// The middle cube of three is removed and made anew at its place, each tick.
Outcome again(Trial& trial) {
  Simulation& scene = trial.scene();
  add_floor(scene);
  BodyIndex middle = 0, top = 0;
  for (const double y : {0.5, 1.5, 2.5}) (y == 1.5 ? middle : top) = scene.add(cube(), {{0, y, 0}, {}});

  Verdict verdict;
  run(scene, 1, kFrame, [&](double) {
    const Pose pose = scene.pose(middle);
    BodyDef def = cube();
    def.velocity = scene.velocity(middle);
    def.angular_velocity = scene.angular_velocity(middle);
    scene.remove(middle);
    middle = scene.add(def, pose);
    return verdict.require_finite(scene, top);
  });
  run(scene, 1);
  verdict.allow(std::abs(scene.pose(middle).position.y - trial.reference(1.5)), 0.012);
  verdict.allow(std::abs(scene.pose(top).position.y - trial.reference(2.5)), 0.02);
  return verdict.outcome;
}

// The third of five links on ball joints goes: the two above hang on, the two below fall.
Outcome joint_partner(Trial& trial) {
  Simulation& scene = trial.scene(with_sleep());
  std::vector<BodyIndex> links{scene.add(fixed(box({0.1, 0.1, 0.1})), {})};
  for (int i = 1; i <= 5; ++i) {
    links.push_back(scene.add(dynamic(box({0.1, 1, 0.1}), 1), {{0, 0.5 - i, 0}, {}}));
    scene.add(joint(links[static_cast<std::size_t>(i) - 1], links.back(), {0, i == 1 ? 0 : -0.5, 0}, BallDef{}));
  }
  run(scene, 5, kFrame, [&](double) { return !scene.asleep(links[5]); });

  Verdict verdict;
  scene.remove(links[3]);
  scene.step(kFrame);
  verdict.require(!scene.asleep(links[4]) && !scene.asleep(links[5]), "the lower links were not woken");
  const double start = scene.pose(links[4]).position.y, speed = scene.velocity(links[4]).y;
  run(scene, 2);
  const double way = kGravity * 2 - 2 * speed;
  verdict.allow(relative(start - scene.pose(links[4]).position.y, trial.reference(way)), 0.009);
  verdict.allow(std::abs(scene.pose(links[2]).position.y - trial.reference(-1.5)), 0.014);
  return verdict.outcome;
}

// In a trigger: one enter and one exit, whether the visitor or the trigger goes.
Outcome in_trigger(Trial& trial, bool visitor_goes) {
  Simulation& scene = trial.scene();
  BodyDef zone = fixed(box({2, 2, 2}));
  zone.trigger = true;
  const BodyIndex trigger = scene.add(zone, {});
  const BodyIndex visitor = scene.add(dynamic(ball(0.25), 1), {{0, 2, 0}, {}});
  int enters = 0, exits = 0;
  bool gone = false;
  run(scene, 1, kFrame, [&](double t) {
    for (const Crossing& crossing : scene.take_crossings()) ++(crossing.enter ? enters : exits);
    if (t > 0.5 && !gone) {
      scene.remove(visitor_goes ? visitor : trigger);
      gone = true;
    }
    return true;
  });
  Verdict verdict;
  verdict.allow(std::abs(enters - trial.reference(1.0)) + std::abs(exits - trial.reference(1.0)), 0.009);
  return verdict.outcome;
}

}  // namespace

Case b22_removal() {
  return {"B22", "Removal", "bodies removed on touch, one of 500 a step, supports, joint partners, in triggers, switched off, made anew in one step",
          "F: neighbours wake within one step and fall freely; one end for each begin; nothing names what is gone", "worst of measured / allowed",
          {{"on touch", 1, on_touch},
           {"1 of 500 a step", 1, one_each_step},
           {"support removed", 1, [](Trial& t) { return support(t, true); }},
           {"support switched off", 1, [](Trial& t) { return support(t, false); }},
           {"switched off and on", 1, switched},
           {"anew in one step", 1, again},
           {"joint partner", 1, joint_partner},
           {"visitor in trigger", 1, [](Trial& t) { return in_trigger(t, true); }},
           {"trigger itself", 1, [](Trial& t) { return in_trigger(t, false); }},
           {"inside callbacks", 1, [](Trial&) -> Outcome { throw Missing{"handlers that run during a step"}; }},
           {"world in callback", 1, [](Trial&) -> Outcome { throw Missing{"handlers that run during a step"}; }}}};
}

}  // namespace tumble::accuracy
