#include "accuracy/cases/stacking/build.h"

#include <algorithm>

namespace tumble::accuracy {

namespace {

std::string at_seconds(double seconds) {
  std::string text = std::to_string(std::round(seconds * 10) / 10);
  return " at " + text.substr(0, text.find('.') + 2) + " s";
}

constexpr double kPenetrationEvery = 1;  // s between two looks at overlaps

}  // namespace

double lasting(Trial& trial, double full, double quick, double test) {
  return trial.shortened(full, trial.effort() == Effort::test ? test : quick);
}

double soaking(Trial& trial, double soak, double full, double quick, double test) {
  return trial.effort() == Effort::soak ? soak : lasting(trial, full, quick, test);
}

int as_many(Trial& trial, int full, int quick, int test) { return static_cast<int>(std::lround(lasting(trial, full, quick, test))); }

Build::Build(Trial& trial, double friction, const SceneSettings& settings) : trial_(trial), scene_(trial.scene(settings)), friction_(std::sqrt(friction)) {
  outcome_.max_penetration = 0;
}

BodyIndex Build::add(BodyDef def, const Pose& pose) {
  def.friction = friction_;
  const BodyIndex body = scene_.add(def, pose);
  const bool moves = def.type == BodyType::dynamic;
  placed_.push_back({body, def.colliders.front().shape, moves});
  if (moves) blocks_.push_back({body, pose});
  return body;
}

BodyIndex Build::add_floor(double side) { return add(fixed(box({side, 2, side})), {{0, -1, 0}, {}}); }

double Build::energy() const {
  double sum = 0;
  for (const Block& block : blocks_) sum += accuracy::energy(scene_, block.body);
  return sum;
}

bool Build::look(double seconds) {
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    if (!finite(scene_, blocks_[i].body)) fail("block " + std::to_string(i) + " is not a number" + at_seconds(seconds));
    else if (scene_.pose(blocks_[i].body).position.y < -1) fail("block " + std::to_string(i) + " fell through the floor" + at_seconds(seconds));
  }
  return !failed();
}

void Build::run(double seconds, const std::function<bool(double)>& each) {
  double next_look = kPenetrationEvery;
  accuracy::run(scene_, seconds, kFrame, [&](double time) {
    if (!look(time)) return false;
    const double now = energy();
    if (!started_) first_energy_ = now;
    most_energy_ = started_ ? std::max(most_energy_, now) : now;
    started_ = true;
    if (time >= next_look) {
      next_look += kPenetrationEvery;
      outcome_.max_penetration = std::max(*outcome_.max_penetration, deepest(overlaps()));
    }
    return each(time);
  });
}

void Build::demand(double measured, double allowed) {
  const double ratio = std::isfinite(measured) ? measured / allowed : INFINITY;
  outcome_.error = std::max(outcome_.error, ratio);
}

void Build::fail(const std::string& what) {
  if (outcome_.failed.empty()) outcome_.failed = what;
}

Build::Way Build::way(BodyIndex body, Vec3 right_place) const {
  const Vec3 off = scene_.pose(body).position - trial_.reference(right_place);
  return {std::abs(off.y), std::hypot(off.x, off.z)};
}

double Build::furthest() const {
  double most = 0;
  for (const Block& block : blocks_) most = std::max(most, moved(block).far());
  return most;
}

double Build::fastest() const {
  double most = 0;
  for (const Block& block : blocks_) most = std::max(most, length(scene_.velocity(block.body)));
  return most;
}

Outcome Build::judge(bool of_energy) {
  if (!failed()) outcome_.max_penetration = std::max(*outcome_.max_penetration, deepest(overlaps()));
  double potential = 0;
  for (const Block& block : blocks_) {
    const MassProperties mass = scene_.mass_properties(block.body);
    potential += mass.mass * kGravity * (block.start * mass.center).y;
  }
  if (of_energy && started_) {
    const double right = trial_.reference(potential);
    demand(std::abs(first_energy_ - right), 0.005 * potential);
    demand(std::max(0.0, most_energy_ - right), 0.01 * potential);
    outcome_.energy_drift = most_energy_ / potential - 1;
  }
  if (failed()) outcome_.error = std::max(outcome_.error, 10.0);
  return outcome_;
}

void demand_stand(Build& build, const Stand& stand) {
  const Block& top = build.last();
  Vec3 place = top.start.position;
  if (stand.height > 0) place.y = stand.height;
  double aside = 0, lower = 0;
  build.run(stand.seconds, [&](double time) {
    const Build::Way way = build.way(top.body, place);
    aside = std::max(aside, way.across);
    if (time >= stand.settled) lower = std::max(lower, way.up);
    const bool fell = way.across > 2 * stand.block || (time >= stand.settled && way.up > stand.block);
    if (fell) build.fail("fell" + at_seconds(time));
    return !fell;
  });
  build.demand(aside, stand.block / 4);
  build.demand(lower, stand.sink);
}

}  // namespace tumble::accuracy
