// Joint limits: a row that acts only once the limit is passed lets the joint go too far by most of a step's way; one
// that looks ahead stops it there. Where it stops it must rest, and not come back.
#include "accuracy/cases/joints/mechanisms.h"

namespace tumble::accuracy {

namespace {

enum class Measure { overshoot, rest, rebound };

// What one fall onto the limit came to.
struct Fall {
  double lowest = INFINITY, highest_after = -INFINITY, last = 0;
  void add(double value) {
    last = value;
    if (value < lowest) {
      lowest = value;
      highest_after = value;
    }
    highest_after = std::max(highest_after, value);
  }
};

// The rod of the pendulums from so far above the horizontal, onto -0.7 rad.
Fall fall_of_rod(Simulation& scene, double start, double seconds, const JointKind& kind, Vec3 axis) {
  const Vec3 along{std::cos(start), std::sin(start), 0};
  const BodyIndex body = scene.add(rod(), {along * 0.5, between({1, 0, 0}, along)});
  scene.add(joint(body, kWorld, {-0.5, 0, 0}, kind, axis));
  Fall fall;
  run(scene, seconds, kFrame, [&](double) {
    fall.add(angle_of(scene, body, {}) - kPi / 2);
    return true;
  });
  return fall;
}

Fall turn(Simulation& scene, double start, double seconds) {
  HingeDef kind;
  kind.angle.min = -0.7 - start;
  kind.angle.max = 1;
  return fall_of_rod(scene, start, seconds, kind, {0, 0, 1});
}

// The same within a cone around where it starts.
Fall swing(Simulation& scene, double start, double seconds) {
  RagdollDef kind;
  kind.swing_a.max = kind.swing_b.max = 0.7 + start;
  return fall_of_rod(scene, start, seconds, kind, {1, 0, 0});
}

// A cube on a slider, a little more than 1 m above its stop at -1 m.
Fall slide(Simulation& scene, double start, double seconds) {
  const BodyIndex body = scene.add(dynamic(box({0.2, 0.2, 0.2}), 1), {{0, start, 0}, {}});
  SliderDef kind;
  kind.position.min = -1 - start;
  kind.position.max = 1;
  scene.add(joint(body, kWorld, {}, kind, {0, 1, 0}));
  Fall fall;
  run(scene, seconds, kFrame, [&](double) {
    fall.add(center(scene, body).y);
    return true;
  });
  return fall;
}

Outcome stop(Trial& trial, Fall (*fall)(Simulation&, double, double), double limit, Measure measure) {
  Outcome outcome;
  Spread spread;
  for (int k = 0; k < trial.phases(); ++k) {
    const Fall found = fall(trial.scene(), 0.0071 * k, span(trial, 3, 1.5, 0.8));
    const double value = measure == Measure::overshoot ? found.lowest : measure == Measure::rest ? found.last : found.highest_after;
    spread.add(value - trial.reference(limit));
    if (!std::isfinite(found.last)) outcome.failed = "not a number";
    else if (found.lowest > limit + 0.05) outcome.failed = "does not reach its limit";
  }
  outcome.bias = spread.mean();
  outcome.error = std::max(std::abs(spread.low), std::abs(spread.high));
  outcome.worst = outcome.error;
  return outcome;
}

}  // namespace

Case a16_limit() {
  Case c{"A16", "Joint limits", "a rod falls from the horizontal onto its hinge's limit at -0.7 rad or that of its cone, a cube 1 m onto its slider's stop",
         "F: the limit, at which it stays", "way past the limit, at rest off it, back from it (rad, m), worst of the phases", {}};
  const std::pair<const char*, Measure> measures[] = {{" overshoot", Measure::overshoot}, {" rest", Measure::rest}, {" rebound", Measure::rebound}};
  for (const auto& [what, measure] : measures) {
    c.parts.push_back({std::string("hinge") + what, 1e-3, [m = measure](Trial& t) { return stop(t, turn, -0.7, m); }});
    c.parts.push_back({std::string("slider") + what, 1e-3, [m = measure](Trial& t) { return stop(t, slide, -1, m); }});
    c.parts.push_back({std::string("cone") + what, 1e-3, [m = measure](Trial& t) { return stop(t, swing, -0.7, m); }});
  }
  return c;
}

}  // namespace tumble::accuracy
