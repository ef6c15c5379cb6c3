#include "physics/dynamics/mover.h"

#include <algorithm>

#include "physics/dynamics/rotation.h"

namespace tumble::dynamics {

namespace {

bool is_free(Vec3 factor) { return factor == Vec3{1, 1, 1}; }

// A locked axis turns by nothing and the others turn against it as about a bearing: the inverse of the block that is
// left. A factor between 0 and 1 makes it lighter to turn in both directions of the product, so that energy stays sound.
Symmetric inverse_with_factors(const Symmetric& inertia, Vec3 f) {
  const int open = (f.x != 0) + (f.y != 0) + (f.z != 0);
  Symmetric result;
  if (open == 3) {
    result = inverse(inertia);
  } else if (open == 2) {
    const auto block = [](double a, double b, double c, double& ia, double& ib, double& ic) {
      const double d = a * b - c * c;
      if (!(d > 0)) return;
      ia = b / d;
      ib = a / d;
      ic = -c / d;
    };
    if (f.x == 0) block(inertia.yy, inertia.zz, inertia.yz, result.yy, result.zz, result.yz);
    else if (f.y == 0) block(inertia.xx, inertia.zz, inertia.xz, result.xx, result.zz, result.xz);
    else block(inertia.xx, inertia.yy, inertia.xy, result.xx, result.yy, result.xy);
  } else if (open == 1) {
    if (f.x != 0) result.xx = reciprocal(inertia.xx);
    if (f.y != 0) result.yy = reciprocal(inertia.yy);
    if (f.z != 0) result.zz = reciprocal(inertia.zz);
  }
  const Vec3 s{std::sqrt(std::abs(f.x)), std::sqrt(std::abs(f.y)), std::sqrt(std::abs(f.z))};
  return {result.xx * s.x * s.x, result.yy * s.y * s.y, result.zz * s.z * s.z,
          result.xy * s.x * s.y, result.xz * s.x * s.z, result.yz * s.y * s.z};
}

void keep_locked(Mover& mover) {
  if (mover.turn_factor.x == 0) mover.spin.x = 0;
  if (mover.turn_factor.y == 0) mover.spin.y = 0;
  if (mover.turn_factor.z == 0) mover.spin.z = 0;
}

// Locked directions take no force; their velocity is the body's own (0 since it was locked).
Vec3 free_part(const Mover& mover, Vec3 acceleration) {
  return {mover.inverse_mass.x == 0 ? 0 : acceleration.x, mover.inverse_mass.y == 0 ? 0 : acceleration.y,
          mover.inverse_mass.z == 0 ? 0 : acceleration.z};
}

}  // namespace

Flight flight(double k, double h) {
  const double x = k * h;
  if (x < 1e-6) return {1 - x / 2, h * (0.5 - x / 6), 1 - x, h * (1 - x / 2)};
  const double kept = std::exp(-x), lost = -std::expm1(-x);
  return {lost / x, (1 - lost / x) / k, kept, lost / k};
}

void Mover::refresh() {
  if (!pushable) return;
  if (stiffness == 0 && is_free(turn_factor)) {
    inverse_inertia = turned(rotation, {reciprocal(inertia.x), reciprocal(inertia.y), reciprocal(inertia.z)});
    return;
  }
  Symmetric whole = turned(rotation, inertia);
  if (stiffness > 0) {
    const Vec3 r = stiff_axis;
    const double k = stiffness;
    whole = whole + Symmetric{k * (1 - r.x * r.x), k * (1 - r.y * r.y), k * (1 - r.z * r.z), -k * r.x * r.y, -k * r.x * r.z, -k * r.y * r.z};
  }
  inverse_inertia = inverse_with_factors(whole, turn_factor);
}

double mass_of(const Mover& mover) { return reciprocal(std::max({mover.inverse_mass.x, mover.inverse_mass.y, mover.inverse_mass.z})); }

void Mover::shift(Vec3 by, Vec3 turned) {
  if (!pushable) return;  // islands share what cannot be pushed, and may run in several threads
  position += by;
  if (turned == Vec3{}) return;
  const bool keeps = is_free(turn_factor);
  const Vec3 momentum = keeps ? rotation * scaled(inertia, conjugate(rotation) * spin) : Vec3{};
  rotation = turned_by(rotation, turned);
  if (keeps) spin = rotation * unscaled(conjugate(rotation) * momentum, inertia);
  refresh();
}

void kick_before(Mover& mover, double h) {
  const Flight f = flight(mover.damping, h);
  mover.velocity = mover.velocity * f.mean_kept + free_part(mover, mover.acceleration) * f.mean_gained;
  mover.spin = mover.spin * std::exp(-mover.angular_damping * h / 2) + mover.inverse_inertia * mover.torque * (h / 2);
  keep_locked(mover);
}

void kick_after(Mover& mover, double h) {
  const Flight f = flight(mover.damping, h);
  const Vec3 pull = free_part(mover, mover.acceleration);
  mover.velocity = (mover.velocity - pull * f.mean_gained) * (f.kept / f.mean_kept) + pull * f.gained;
  mover.spin = mover.spin * std::exp(-mover.angular_damping * h / 2) + mover.inverse_inertia * mover.torque * (h / 2);
  keep_locked(mover);
}

void drift(Mover& mover, double h) {
  mover.position += mover.velocity * h;
  // A bearing takes the gyroscopic moment of a body with a locked axis; what carries others turns as it is told.
  const bool moments = mover.inertia.x > 0 && mover.inertia.y > 0 && mover.inertia.z > 0;
  if (mover.pushable && moments && is_free(mover.turn_factor)) turn(mover.rotation, mover.spin, mover.inertia, h);
  else mover.rotation = turned_by(mover.rotation, mover.spin * h);
  mover.refresh();
}

}  // namespace tumble::dynamics
