#include "accuracy/cases/joints/mechanisms.h"

#include <algorithm>
#include <sstream>

namespace tumble::accuracy {

double span(Trial& trial, double full, double quick, double test) {
  return trial.shortened(full, trial.effort() == Effort::test ? test : quick);
}

std::string text(double number) {
  std::ostringstream out;
  out << number;
  return out.str();
}

BodyIndex Mechanism::add(BodyDef body, const Pose& pose) {
  body.group = "mechanism";
  body.collides_with = {""};
  const BodyIndex index = scene_.add(body, pose);
  if (body.type == BodyType::dynamic) bodies_.push_back(index);
  return index;
}

JointIndex Mechanism::join(const JointSpec& spec) {
  const Pose b = inverse(pose(spec.b)) * pose(spec.a);
  const bool slides = std::holds_alternative<SliderDef>(spec.def.kind);
  held_.push_back({spec.a, spec.b, spec.def.anchor, b * spec.def.anchor, slides ? b.rotation * normalized(spec.def.axis) : Vec3{}});
  return scene_.add(spec);
}

std::vector<BodyIndex> Mechanism::chain(const std::vector<Vec3>& nodes, const BodyDef& link, const JointKind& kind, BodyIndex from) {
  std::vector<BodyIndex> links;
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    const Vec3 along = nodes[i] - nodes[i - 1];
    links.push_back(add(link, {(nodes[i] + nodes[i - 1]) / 2, between({1, 0, 0}, along)}));
    join(joint(links.back(), i == 1 ? from : links[i - 2], {-length(along) / 2, 0, 0}, kind, {0, 0, 1}));
  }
  return links;
}

double Mechanism::kinetic() const {
  double sum = 0;
  for (const BodyIndex body : bodies_) sum += kinetic_energy(scene_, body);
  return sum;
}

double Mechanism::energy() const {
  double sum = 0;
  for (const BodyIndex body : bodies_) sum += accuracy::energy(scene_, body, gravity_);
  return sum;
}

Vec3 Mechanism::momentum() const {
  Vec3 sum;
  for (const BodyIndex body : bodies_) sum += accuracy::momentum(scene_, body);
  return sum;
}

Vec3 Mechanism::angular_momentum() const {
  Vec3 sum;
  for (const BodyIndex body : bodies_) sum += accuracy::angular_momentum(scene_, body);
  return sum;
}

double Mechanism::gap() const {
  double largest = 0;
  for (const Held& held : held_) {
    const Pose b = pose(held.b);
    const Vec3 apart = pose(held.a) * held.on_a - b * held.on_b, axis = b.rotation * held.axis;
    largest = std::max(largest, length(apart - axis * dot(apart, axis)));
  }
  return largest;
}

double Mechanism::fastest() const {
  double speed = 0;
  for (const BodyIndex body : bodies_) speed = std::max(speed, length(scene_.velocity(body)));
  return speed;
}

bool Mechanism::finite() const {
  return std::all_of(bodies_.begin(), bodies_.end(), [&](BodyIndex body) { return accuracy::finite(scene_, body); });
}

BodyDef rod() { return dynamic(box({1, 0.1, 0.1}), 1); }

double angle_of(const Simulation& scene, BodyIndex body, Vec3 pivot) {
  const Vec3 arm = center(scene, body) - pivot;
  return std::atan2(arm.x, -arm.y);
}

double swing_period(double inertia, double moment, double amplitude) {
  double a = 1, b = std::cos(amplitude / 2);
  for (int i = 0; i < 40; ++i) {
    const double mean = (a + b) / 2;
    b = std::sqrt(a * b);
    a = mean;
  }
  return 2 * kPi * std::sqrt(inertia / (moment * kGravity)) / a;
}

Outcome keep_energy(Trial& trial, Simulation& scene, const Mechanism& mechanism, double scale, double seconds, bool gain) {
  const double before = mechanism.energy();
  double low = before, high = before, gap = 0;
  run(scene, seconds, kFrame, [&](double) {
    const double now = mechanism.energy();
    low = std::min(low, now);
    high = std::max(high, now);
    gap = std::max(gap, mechanism.gap());
    return mechanism.finite();
  });

  const double truth = trial.reference(before);
  Outcome outcome;
  outcome.error = relative(high, truth, scale);
  if (!gain) outcome.error = std::max(outcome.error, relative(low, truth, scale));
  outcome.energy_drift = (mechanism.energy() - before) / scale;
  outcome.max_joint_gap = gap;
  if (!mechanism.finite()) outcome.failed = "not a number";
  return outcome;
}

void Swing::add(double seconds, double value) {
  // A jump of half a turn is an angle that starts anew, not a way through 0.
  if (seconds_ > 0 && value * value_ <= 0 && value != value_ && std::abs(value - value_) < kPi) {
    const double at = seconds_ + (seconds - seconds_) * value_ / (value_ - value);
    if (++crossings_ == 1) first_ = at;
    if (crossings_ % 2 == 1) {
      last_ = at;
      whole_ = crossings_;
    }
  }
  seconds_ = seconds;
  value_ = value;
}

}  // namespace tumble::accuracy
