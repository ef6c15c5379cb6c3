// Fast bodies, asked to be swept: nothing thin may be passed in a step, nothing may lose its time, hang in the air or
// stick where it only brushed something.
#include "accuracy/cases/impact/b10_parts.h"
#include "accuracy/cases/impact/volley.h"

namespace tumble::accuracy {

BodyDef swept(BodyDef def) {
  def.continuous = true;
  return def;
}

Outcome count_through(int through, int tries) {
  Outcome outcome;
  outcome.error = through;
  if (through > 0) outcome.failed = std::to_string(through) + " of " + std::to_string(tries) + " went through";
  return outcome;
}

namespace {

// Against a wall of 1 cm, straight and at 45 degrees.
Outcome wall(Trial& trial, const BodyDef& body, double speed, BodyType type = BodyType::fixed) {
  std::vector<Shot> shots;
  for (int i = 0; i < trial.phases(); ++i)
    for (const double angle : {0.0, kPi / 4}) shots.push_back({body, angle, static_cast<double>(i) / trial.phases()});
  const Hits hits = fire(trial, shots, speed, type);
  Outcome outcome = count_through(hits.through, static_cast<int>(shots.size()));
  if (!hits.failed.empty()) outcome.failed = hits.failed;
  return outcome;
}

BodyDef dumbbell() {
  BodyDef def = swept(dynamic(box({0.2, 0.2, 0.2}), 2));
  def.colliders.push_back(def.colliders.front());
  def.colliders.front().offset = {0, 0.25, 0};
  def.colliders.back().offset = {0, -0.25, 0};
  return def;
}

BodyDef moved_capsule() {
  BodyDef def = swept(dynamic(upright(ShapeKind::capsule, 0.1, 0.5), 1));
  def.colliders.front().offset = {0, 0.15, 0.1};
  def.colliders.front().rotation = axis_angle({0, 0, 1}, kPi / 2);
  return def;
}

}  // namespace

Case b10_fast_bodies() {
  Case c{"B10", "Fast bodies", "balls, boxes and compounds at 50 to 1000 m/s against walls of 1 cm; planks, rods, sticks; two head on",
         "none goes through; at most a step of time lost; a body that brushes or slides goes on",
         "how many went through; else what is lost over a step's way, or over 0.5 % of the speed", {}};
  for (const int speed : {50, 100, 300, 1000}) {
    const std::string name = ", " + std::to_string(speed) + " m/s";
    c.parts.push_back({"ball" + name, 1, [speed](Trial& t) { return wall(t, swept(dynamic(ball(0.1), 1)), speed); }});
    c.parts.push_back({"box" + name, 1, [speed](Trial& t) { return wall(t, swept(dynamic(box({0.2, 0.2, 0.2}), 1)), speed); }});
  }
  c.parts.push_back({"compound, 300 m/s", 1, [](Trial& t) { return wall(t, dumbbell(), 300); }});
  c.parts.push_back({"moved capsule, 300 m/s", 1, [](Trial& t) { return wall(t, moved_capsule(), 300); }});
  c.parts.push_back({"kinematic wall, 300 m/s", 1, [](Trial& t) { return wall(t, swept(dynamic(ball(0.1), 1)), 300, BodyType::kinematic); }});
  c.parts.push_back({"head on, 100 m/s", 1, [](Trial& t) { return head_on(t, 100); }});
  c.parts.push_back({"head on, 300 m/s", 1, [](Trial& t) { return head_on(t, 300); }});
  c.parts.push_back({"lost time", 1, lost_time});
  c.parts.push_back({"glancing hit", 1, glancing});
  c.parts.push_back({"steps of 1/4 s", 1, long_steps});
  c.parts.push_back({"plank on two triangles", 1, plank});
  c.parts.push_back({"thin rod on a plane", 1, rod});
  c.parts.push_back({"spinning stick at a post", 1, stick});
  return c;
}

}  // namespace tumble::accuracy
