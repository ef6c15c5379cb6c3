// Words for building scenes and for judging what became of them, shared by the cases.
#pragma once

#include <cmath>
#include <cstdint>

#include "accuracy/case.h"
#include "base/math.h"

namespace tumble::accuracy {

// ---- shapes
Shape box(Vec3 size);
Shape ball(double radius);
Shape upright(ShapeKind kind, double radius, double height);  // capsule, cylinder, cone
Shape hull(std::vector<Vec3> points);

// ---- bodies. Friction and restitution are 0 unless a case says otherwise; a pair has the product of both partners'.
BodyDef dynamic(const Shape& shape, double mass);
BodyDef fixed(const Shape& shape);      // friction and restitution 1: the partner's value is the pair's
BodyDef kinematic(const Shape& shape);  // likewise
BodyDef with(BodyDef body, double friction, double restitution = 0);
// A static box 40 x 2 x 40 m (or wider) whose top is y = 0.
BodyIndex add_floor(Simulation& scene, double side = 40);

// ---- joints without motor, limits or springs; anchor and axis in a's frame
JointSpec joint(BodyIndex a, BodyIndex b, Vec3 anchor, const JointKind& kind, Vec3 axis = {0, 1, 0});

// ---- time. The callback is called after each step with the seconds since the start; false ends the run.
void run(Simulation& scene, double seconds, double frame = kFrame);
void run(Simulation& scene, double seconds, double frame, const std::function<bool(double)>& each);

// ---- mechanics of what there is now, from poses, velocities and mass properties
double kinetic_energy(const Simulation& scene, BodyIndex body);
double energy(const Simulation& scene, BodyIndex body, Vec3 gravity = {0, -kGravity, 0});  // kinetic and potential, J
Vec3 momentum(const Simulation& scene, BodyIndex body);
Vec3 spin_momentum(const Simulation& scene, BodyIndex body);      // about its own centre of mass, kg m^2/s
Vec3 angular_momentum(const Simulation& scene, BodyIndex body);   // about the origin
Vec3 center(const Simulation& scene, BodyIndex body);             // centre of mass, world
bool finite(const Simulation& scene, BodyIndex body);
double fastest_corner(const Simulation& scene, BodyIndex body, Vec3 size);  // m/s, of a box of this size around its centre

// ---- deterministic chance: the same numbers on every machine
class Chance {
 public:
  explicit Chance(std::uint64_t seed) : state_(seed) {}
  double unit();                             // 0 <= x < 1
  double between(double low, double high) { return low + (high - low) * unit(); }
  Vec3 direction();                          // uniform on the sphere
  Quat rotation();                           // uniform

 private:
  std::uint64_t state_;
};

// ---- over phases
struct Spread {
  void add(double value);
  double mean() const { return count ? sum / count : 0; }
  double sum = 0, low = INFINITY, high = -INFINITY;
  int count = 0;
};

// |value - truth| / scale; `truth` has gone through Trial::reference.
inline double relative(double value, double truth, double scale) { return std::abs(value - truth) / scale; }
inline double relative(double value, double truth) { return std::abs(value - truth) / std::abs(truth); }

}  // namespace tumble::accuracy
