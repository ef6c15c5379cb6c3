// Kinematic tools that nothing can stop: a press that squeezes a cube, a blade that sweeps boxes, a lift that carries
// one into a ceiling. The squeezed body may be shot out only as fast as the tool goes, never through the floor.
#include "accuracy/cases/life/verdict.h"

namespace tumble::accuracy {

namespace {

constexpr double kSpeed = 0.5;       // of press and lift, m/s
constexpr double kSqueeze = 0.6;     // left for the cube of 1 m, m
constexpr double kHold = 0.5;        // s

bool touched(const Simulation& scene, BodyIndex a, BodyIndex b) {
  for (const Touch& touch : scene.touches())
    if ((touch.a == a && touch.b == b) || (touch.a == b && touch.b == a)) return true;
  return false;
}

// The tool starts 1 m from the fixed surface at `gap` more, closes in, holds, and goes back; 1 s later all is well.
// `up`: the tool is a lift below the cube and the fixed surface is a ceiling.
Outcome squeeze(Trial& trial, bool up) {
  Simulation& scene = trial.scene();
  constexpr double kGap = 0.05;
  const BodyIndex floor = add_floor(scene);
  const double tool_start = up ? 0.5 : 1 + kGap + 0.5;  // middle of the tool, 1 m thick
  const double cube_start = up ? 1.5 : 0.5;
  const BodyIndex tool = scene.add(kinematic(box({2, 1, 2})), {{0, tool_start, 0}, {}});
  const BodyIndex other = up ? scene.add(fixed(box({4, 1, 4})), {{0, 2 + kGap + 0.5, 0}, {}}) : floor;
  const BodyIndex cube = scene.add(with(dynamic(box({1, 1, 1}), 1), 0.5), {{0, cube_start, 0}, {}});

  Verdict verdict;
  const double closing = (1 + kGap - kSqueeze) / kSpeed, lowest = up ? 1 + (1 - kSqueeze) / 2 : 0.5 - (1 - kSqueeze) / 2;
  int silent = 0;
  run(scene, closing + kHold + closing + 1, kFrame, [&](double t) {
    const double way = kSpeed * std::clamp(std::min(t + kFrame, 2 * closing + kHold - t - kFrame), 0.0, closing);
    scene.move(tool, {{0, tool_start + (up ? way : -way), 0}, {}});
    if (!verdict.require_finite(scene, cube)) return false;
    verdict.allow(length(scene.velocity(cube)), 5 * kSpeed);
    const double y = scene.pose(cube).position.y;
    if (!up) verdict.require(y > lowest - 0.1, "pressed through the floor at " + in_seconds(t));
    const Vec3 off = scene.pose(cube).position - scene.pose(tool).position;
    const bool between = std::abs(off.x) < 1 && std::abs(off.z) < 1;
    if (t > closing && t < closing + kHold && between) silent += !touched(scene, cube, tool) || !touched(scene, cube, other);
    return true;
  });
  verdict.require(silent == 0, std::to_string(silent) + " steps of the squeeze without a contact");

  // Where it lies, or where it was shot out to: on the lift or on the floor.
  const double y = scene.pose(cube).position.y;
  const double rest = up && y > 1 ? 1.5 : 0.5;
  verdict.allow(std::abs(y - trial.reference(rest)), 0.004);
  verdict.allow(length(scene.velocity(cube)), 0.1);
  return verdict.outcome;
}

Outcome blade(Trial& trial) {
  constexpr int kBoxes = 50;
  constexpr double kRate = 1, kArm = 5, kEdge = 0.5;
  Simulation& scene = trial.scene();
  add_floor(scene, 80);
  const BodyIndex bar = scene.add(kinematic(box({2 * kArm, 0.5, 0.3})), {{0, 0.3, 0}, {}});
  std::vector<BodyIndex> boxes;
  Chance chance(16);
  for (int ring = 1; static_cast<int>(boxes.size()) < kBoxes; ++ring) {
    for (int i = 0; i < 6 * ring && static_cast<int>(boxes.size()) < kBoxes; ++i) {
      const double angle = kPi * (2 * i + 1) / (6 * ring);
      const Vec3 at{1.2 * ring * std::cos(angle), kEdge / 2, 1.2 * ring * std::sin(angle)};
      if (std::abs(at.z) < 0.6) continue;  // there is the blade
      boxes.push_back(scene.add(with(dynamic(box({kEdge, kEdge, kEdge}), 1), 0.6), {at, axis_angle({0, 1, 0}, chance.between(0, 1))}));
    }
  }

  Verdict verdict;
  const double sweep = trial.shortened(2 * kPi / kRate, 2.5);
  run(scene, sweep + 1, kFrame, [&](double t) {
    scene.move(bar, {{0, 0.3, 0}, axis_angle({0, 1, 0}, -kRate * std::min(t + kFrame, sweep))});
    for (const BodyIndex body : boxes) {
      if (!verdict.require_finite(scene, body)) return false;
      verdict.allow(length(scene.velocity(body)), 5 * kRate * kArm);
      verdict.require(scene.pose(body).position.y > 0, "box " + std::to_string(body) + " below the floor at " + in_seconds(t));
    }
    return true;
  });
  // At rest a second after the blade, lying on a face.
  for (const BodyIndex body : boxes) {
    verdict.allow(length(scene.velocity(body)), 0.5);
    verdict.allow(std::abs(scene.pose(body).position.y - trial.reference(kEdge / 2)), 0.002);
  }
  return verdict.outcome;
}

}  // namespace

Case b16_press() {
  return {"B16", "Press, blade and lift", "a kinematic press closes on a cube of 1 m down to 0.6 m; a blade sweeps 50 boxes; a lift goes into a ceiling",
          "F: at most 5 times as fast as the tool, not below the floor, contacts go on, at rest 1 s after release", "worst of measured / allowed",
          {{"press", 1, [](Trial& t) { return squeeze(t, false); }},
           {"lift into ceiling", 1, [](Trial& t) { return squeeze(t, true); }},
           {"blade", 1, blade}}};
}

}  // namespace tumble::accuracy
