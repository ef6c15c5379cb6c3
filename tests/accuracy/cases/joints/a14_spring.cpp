// Springs: do they swing at the frequency and fade at the ratio that was asked for, whatever the step?
//
// Symplectic Euler swings too fast and is unstable past w h = 2; implicit Euler has a damping of its own, 0.25 for 5 Hz
// at 60 Hz. Both are linear, so that frequency and damping come from a fit of x(t + h) = p x(t) - q x(t - h), exact for
// a damped oscillator even at three samples a swing.
#include "accuracy/cases/joints/mechanisms.h"

namespace tumble::accuracy {

namespace {

enum class Measure { frequency, damping, path };

struct Oscillator {
  double frequency = 0, ratio = 0;  // Hz, undamped; damping ratio
  double at(double seconds) const { // from rest at 1
    const double w = 2 * kPi * frequency, t = seconds;
    if (ratio >= 1) return (1 + w * t) * std::exp(-w * t);
    const double root = std::sqrt(1 - ratio * ratio);
    return std::exp(-ratio * w * t) * (std::cos(w * root * t) + ratio / root * std::sin(w * root * t));
  }
};

// A 2 kg box on a slider, 1 m from the spring's rest; without gravity. One value a frame.
std::vector<double> slide(Simulation& scene, const Oscillator& truth, double seconds) {
  SliderDef kind;
  kind.position.spring.emplace();
  kind.position.spring->frequency = truth.frequency;
  kind.position.spring->damping = truth.ratio;
  kind.position.spring->rest = -1;
  const BodyIndex body = scene.add(dynamic(box({1, 1, 1}), 2), {});
  scene.add(joint(body, kWorld, {}, kind, {1, 0, 0}));
  std::vector<double> values{1};
  run(scene, seconds, kFrame, [&](double) {
    values.push_back(1 + scene.pose(body).position.x);
    return std::isfinite(values.back());
  });
  return values;
}

// A ball on an arm, half a radian from the rest of its hinge's spring.
std::vector<double> turn(Simulation& scene, double frequency, double arm, double seconds) {
  HingeDef kind;
  kind.angle.spring.emplace();
  kind.angle.spring->frequency = frequency;
  kind.angle.spring->rest = -0.5;
  const BodyIndex body = scene.add(dynamic(ball(0.1), 1), {{arm, 0, 0}, {}});
  scene.add(joint(body, kWorld, {-arm, 0, 0}, kind, {0, 0, 1}));
  std::vector<double> values{1};
  run(scene, seconds, kFrame, [&](double) {
    const Vec3 at = scene.pose(body).position;
    values.push_back(1 + std::atan2(at.y, at.x) / 0.5);
    return std::isfinite(values.back());
  });
  return values;
}

Outcome judge(Trial& trial, const std::vector<double>& x, const Oscillator& truth, Measure measure) {
  Outcome outcome;
  if (!std::isfinite(x.back()) || std::abs(x.back()) > 100) {
    outcome.error = 1;
    outcome.failed = "unstable";
    return outcome;
  }
  if (measure == Measure::path) {  // during the first swing
    for (std::size_t i = 0; i < x.size() && static_cast<double>(i) * kFrame <= 1 / truth.frequency; ++i)
      outcome.error = std::max(outcome.error, std::abs(x[i] - trial.reference(truth.at(static_cast<double>(i) * kFrame))));
    return outcome;
  }

  // Least squares: sums of products of three neighbours.
  double s11 = 0, s12 = 0, s22 = 0, r1 = 0, r2 = 0;
  for (std::size_t i = 2; i < x.size(); ++i) {
    s11 += x[i - 1] * x[i - 1];
    s12 += x[i - 1] * x[i - 2];
    s22 += x[i - 2] * x[i - 2];
    r1 += x[i] * x[i - 1];
    r2 += x[i] * x[i - 2];
  }
  const double determinant = s11 * s22 - s12 * s12;
  const double p = (r1 * s22 - r2 * s12) / determinant, q = (s12 * r1 - s11 * r2) / determinant;
  if (!(q > 0) || !(p * p < 4 * q)) {
    outcome.error = 1;
    outcome.failed = "does not swing";
    return outcome;
  }
  const double turned = std::acos(p / (2 * std::sqrt(q)));  // rad a frame
  const double root = std::sqrt(1 - truth.ratio * truth.ratio);
  if (measure == Measure::frequency) outcome.error = relative(turned / (2 * kPi * kFrame), trial.reference(truth.frequency * root));
  // What is left after a swing, as its logarithm over 2 pi: for small ratios the ratio itself.
  const double left = std::pow(q, kPi / turned), wanted = std::exp(-2 * kPi * truth.ratio / root);
  if (measure == Measure::damping) outcome.error = std::abs(std::log(left / trial.reference(wanted))) / (2 * kPi);
  return outcome;
}

const SceneSettings kWeightless{{0, 0, 0}, false};

Outcome linear(Trial& trial, const Oscillator& truth, Measure measure) {
  return judge(trial, slide(trial.scene(kWeightless), truth, span(trial, 4, 2, 1)), truth, measure);
}

// 40 N m/rad.
Outcome angular(Trial& trial, double arm, Measure measure) {
  const Oscillator truth{std::sqrt(40 / (arm * arm + 0.4 * 0.1 * 0.1)) / (2 * kPi), 0};
  return judge(trial, turn(trial.scene(kWeightless), truth.frequency, arm, span(trial, 4, 3, 2.5)), truth, measure);
}

// Far stiffer than the step can follow: it must not grow.
Outcome stiff(Trial& trial, double frequency) {
  double highest = 0;
  for (const double x : slide(trial.scene(kWeightless), {frequency, 0}, span(trial, 4, 2, 1))) highest = std::max(highest, std::isfinite(x) ? std::abs(x) : INFINITY);
  Outcome outcome;
  outcome.error = std::min(1.0, relative(highest, trial.reference(1)));
  if (highest > 100) outcome.failed = "unstable";
  return outcome;
}

}  // namespace

Case a14_spring() {
  Case c{"A14", "Spring frequency and damping", "a 2 kg box on a slider's spring 1 m from its rest; a 1 kg ball on an arm, on a hinge's spring of 40 N m/rad",
         "F: x(t) of the damped oscillator", "|f - f_ref| / f_ref; logarithmic decrement / 2 pi; |x - x_ref| / 1 m in the first swing", {}};
  const std::pair<const char*, Measure> measures[] = {{" frequency", Measure::frequency}, {" damping", Measure::damping}, {" path", Measure::path}};
  for (const double frequency : {1, 5, 20})
    for (const double ratio : {0.0, 0.1, 1.0})
      for (const auto& [what, measure] : measures)
        if (ratio < 1 || measure == Measure::path)
          c.parts.push_back({text(frequency) + " Hz ratio " + text(ratio) + what, 1e-3, [=, m = measure](Trial& t) { return linear(t, {frequency, ratio}, m); }});
  for (const double arm : {0.5, 1.0, 2.0})
    for (const auto& [what, measure] : measures)
      c.parts.push_back({"arm " + text(arm) + " m" + what, 1e-3, [=, m = measure](Trial& t) { return angular(t, arm, m); }});
  for (const double frequency : {100, 1000})
    c.parts.push_back({text(frequency) + " Hz amplitude", 1e-3, [=](Trial& t) { return stiff(t, frequency); }});
  return c;
}

}  // namespace tumble::accuracy
