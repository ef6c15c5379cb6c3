// Deep overlap: boxes that start far inside each other are to come apart soon, and gently: an engine that repairs all of
// it at once shoots them away.
#include "accuracy/cases/impact/overlap.h"
#include "accuracy/scenes.h"

namespace tumble::accuracy {

namespace {

constexpr Vec3 kCube{1, 1, 1};
constexpr double kEnough = 0.005;  // m: this near to apart counts as apart

struct Solid {
  BodyIndex body = 0;
  Vec3 edges;
};
struct Pair {
  Solid a, b;
  double allowed = 0;  // m/s: separation speed
};

// At most 3 m/s, or a tenth of the overlap a frame; apart within a second; at the end no faster than 0.5 m/s.
Outcome part(Trial& trial, Simulation& scene, const std::vector<Solid>& solids, double seconds) {
  const auto overlap = [&](const Pair& pair) {
    // Apart is measured against boxes of their true size.
    return box_overlap(scene.pose(pair.a.body), trial.reference(pair.a.edges), scene.pose(pair.b.body), trial.reference(pair.b.edges));
  };
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < solids.size(); ++i)
    for (std::size_t k = i + 1; k < solids.size(); ++k) {
      Pair pair{solids[i], solids[k]};
      const double depth = overlap(pair);
      pair.allowed = std::max(3.0, 0.1 * depth / kFrame);
      if (depth > kEnough) pairs.push_back(pair);
    }
  const auto apart = [](const Simulation& s, const Pair& pair) {
    const Vec3 way = s.pose(pair.b.body).position - s.pose(pair.a.body).position;
    return dot(s.velocity(pair.b.body) - s.velocity(pair.a.body), normalized(way));
  };

  Outcome outcome;
  double speeding = 0, last_inside = 0;
  run(scene, seconds, kFrame, [&](double time) {
    double deepest = 0;
    for (const Pair& pair : pairs) {
      if (time <= 1) speeding = std::max(speeding, apart(scene, pair) / pair.allowed);
      deepest = std::max(deepest, overlap(pair));
    }
    if (deepest > kEnough) last_inside = time;
    outcome.max_penetration = deepest;
    return true;
  });

  double fastest = 0;
  for (const Solid& solid : solids) {
    fastest = std::max(fastest, length(scene.velocity(solid.body)));
    if (!finite(scene, solid.body)) outcome.failed = "not finite";
  }
  if (last_inside > seconds - kFrame) outcome.failed = "not apart after " + std::to_string(std::lround(seconds)) + " s";
  outcome.error = std::max({speeding, last_inside, fastest / 0.5});
  return outcome;
}

// Two cubes of 1 m, no gravity.
Outcome cubes(Trial& trial, double depth) {
  Simulation& scene = trial.scene({{0, 0, 0}});
  std::vector<Solid> solids;
  for (const double x : {0.0, 1 - depth}) solids.push_back({scene.add(dynamic(box(kCube), 1), {{x, 0, 0}, {}}), kCube});
  return part(trial, scene, solids, 2);
}

// A cube of half a metre inside one of a metre, off its centre.
Outcome inside(Trial& trial) {
  Simulation& scene = trial.scene({{0, 0, 0}});
  const Vec3 small{0.5, 0.5, 0.5};
  return part(trial, scene, {{scene.add(dynamic(box(kCube), 1), {}), kCube}, {scene.add(dynamic(box(small), 1), {{0.1, 0, 0}, {}}), small}}, 2);
}

// Box3D's: a wall of 4, 3, 2 and 1 cubes, pushed together to three quarters of its size, on a floor.
Outcome pyramid(Trial& trial) {
  Simulation& scene = trial.scene();
  add_floor(scene);
  std::vector<Solid> solids;
  for (int row = 0; row < 4; ++row)
    for (int i = 0; i < 4 - row; ++i) {
      const Vec3 at = Vec3{i - 0.5 * (3 - row), 0.5 + row, 0} * 0.75;
      solids.push_back({scene.add(with(dynamic(box(kCube), 1), 0.6), {at, {}}), kCube});
    }
  return part(trial, scene, solids, 4);
}

}  // namespace

Case b09_deep_overlap() {
  Case c{"B09", "Deep overlap", "two cubes 0.1 to 0.9 of an edge inside each other; a cube inside a larger one; a wall pushed together by a quarter",
         "apart within 1 s, at no more than max(3 m/s, a tenth of the overlap a frame), at the end no faster than 0.5 m/s",
         "worst of separation speed, time and end speed, each over what is allowed", {}};
  for (const auto& [name, depth] : {std::pair("0.1", 0.1), {"0.5", 0.5}, {"0.9", 0.9}})
    c.parts.push_back({std::string("cubes, ") + name, 1, [depth = depth](Trial& t) { return cubes(t, depth); }});
  c.parts.push_back({"cube inside", 1, inside});
  c.parts.push_back({"pyramid", 1, pyramid});
  return c;
}

}  // namespace tumble::accuracy
