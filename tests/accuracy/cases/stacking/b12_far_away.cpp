// Far from the origin a float has few digits left: a millimetre at 10 km, six centimetres at 1000 km. Five scenes of
// other cases are played there and at the origin, and their paths compared.
#include <algorithm>

#include "accuracy/cases/stacking/build.h"

namespace tumble::accuracy {

namespace {

constexpr double kAllowed = 1e-3;  // m

using Places = std::vector<Vec3>;  // of what moves, relative to the base, one after the other in time
using Play = Places (*)(Trial&, Vec3 base);

void note(Places& places, const Simulation& scene, BodyIndex body, Vec3 base) { places.push_back(scene.pose(body).position - base); }

Places tower(Trial& trial, Vec3 base) {
  Simulation& scene = trial.scene();
  const double root = 0.8;  // of the pairs' friction
  scene.add(with(fixed(box({40, 2, 40})), root), {base + Vec3{0, -1, 0}, {}});
  std::vector<BodyIndex> cubes;
  for (int i = 0; i < 5; ++i) cubes.push_back(scene.add(with(dynamic(box({1, 1, 1}), 1), root), {base + Vec3{0, 0.5 + i, 0}, {}}));
  run(scene, lasting(trial, 10, 2, 0.25));
  Places places;
  for (const BodyIndex cube : cubes) note(places, scene, cube, base);
  return places;
}

// A rod of 1 m on a hinge, let go 30 degrees from below.
Places pendulum(Trial& trial, Vec3 base) {
  Simulation& scene = trial.scene();
  const Quat turn = axis_angle({0, 0, 1}, radians(30));
  const BodyIndex rod = scene.add(dynamic(box({0.1, 1, 0.1}), 1), {base + turn * Vec3{0, -0.5, 0}, turn});
  scene.add(joint(rod, kWorld, {0, 0.5, 0}, HingeDef{}, {0, 0, 1}));
  Places places;
  run(scene, 1.5, kFrame, [&](double) {
    note(places, scene, rod, base);
    return true;
  });
  return places;
}

// Ten links and an end ten times as heavy, let go horizontally. Chaotic later on, so half a second.
Places chain(Trial& trial, Vec3 base) {
  Simulation& scene = trial.scene();
  std::vector<BodyIndex> links;
  for (int i = 0; i <= 10; ++i) {
    links.push_back(scene.add(dynamic(box({0.5, 0.1, 0.1}), i == 10 ? 10 : 1), {base + Vec3{0.25 + 0.5 * i, 0, 0}, {}}));
    scene.add(joint(links.back(), i == 0 ? kWorld : links[links.size() - 2], {-0.25, 0, 0}, BallDef{}));
  }
  run(scene, 0.5);
  Places places;
  for (const BodyIndex link : links) note(places, scene, link, base);
  return places;
}

// A ball at 200 m/s at a wall of 1 cm.
Places bullet(Trial& trial, Vec3 base) {
  Simulation& scene = trial.scene({{0, 0, 0}, false});
  scene.add(fixed(box({0.01, 4, 4})), {base, {}});
  BodyDef def = dynamic(ball(0.1), 1);
  def.velocity = {200, 0, 0};
  def.continuous = true;
  const BodyIndex body = scene.add(def, {base + Vec3{-10, 0.3, 0.2}, {}});
  run(scene, 0.25);
  Places places;
  note(places, scene, body, base);
  return places;
}

// Where rays meet a ball, a box and a capsule.
Places rays(Trial& trial, Vec3 base) {
  Simulation& scene = trial.scene();
  scene.add(fixed(ball(1)), {base + Vec3{-3, 0, 0}, {}});
  scene.add(fixed(box({2, 2, 2})), {base, axis_angle({1, 2, 3}, 1)});
  scene.add(fixed(upright(ShapeKind::capsule, 0.5, 2)), {base + Vec3{3, 0, 0}, axis_angle({3, 1, 2}, 1)});
  scene.step(kFrame);
  Chance chance(12);
  Places places;
  for (int i = 0; i < 300; ++i) {
    const Vec3 target{3 * (i % 3 - 1.0), 0, 0}, away = chance.direction() * 10, aside = chance.direction() * 0.3;
    const auto hit = scene.raycast(base + target + away, aside - away, 20);
    places.push_back(hit ? hit->point - base : Vec3{1e3, 0, 0});
  }
  return places;
}

Outcome compare(Trial& trial, Play play, double away) {
  const Vec3 base = Vec3{0.6, 0.48, 0.64} * away;
  const Places here = play(trial, {}), there = play(trial, base);
  Outcome outcome;
  for (std::size_t i = 0; i < here.size(); ++i) {
    if (!is_finite(there[i])) outcome.failed = "not a number";
    else outcome.error = std::max(outcome.error, distance(there[i], trial.reference(here[i])) / kAllowed);
  }
  if (!outcome.failed.empty()) outcome.error = 1e3;
  return outcome;
}

}  // namespace

Case b12_far_away() {
  Case c{"B12", "Far from the origin", "a tower of five, a hinged rod, a chain with an end of 10:1, a ball at 200 m/s at a thin wall, rays; 1 to 1000 km away",
         "S: the same scene at the origin", "greatest difference of places relative to the base, over 1 mm", {}};
  const std::pair<const char*, Play> plays[] = {{"tower", tower}, {"rod", pendulum}, {"chain", chain}, {"bullet", bullet}, {"rays", rays}};
  for (const double away : {1e3, 1e4, 1e5, 1e6})
    for (const auto& [name, play] : plays)
      c.parts.push_back({std::string(name) + " at " + std::to_string(std::lround(away / 1000)) + " km", 1, [play, away](Trial& t) { return compare(t, play, away); }});
  return c;
}

}  // namespace tumble::accuracy
