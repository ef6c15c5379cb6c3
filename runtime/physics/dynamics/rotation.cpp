#include "physics/dynamics/rotation.h"

#include <algorithm>

namespace tumble::dynamics {

namespace {

// Moments that differ by less than this part of the largest are equal: the spin then keeps its direction.
constexpr double kIsotropic = 1e-6;
// The iteration gains a factor of about |w| h each round. It ends when a round changes the spin by less than this part.
constexpr double kSettled = 1e-14;
constexpr int kMostRounds = 12;
// A turn by more in one step is cut into parts, radians: beyond a radian the iteration need not settle.
constexpr double kLargestPart = 0.5;
constexpr int kMostParts = 16;

bool isotropic(Vec3 inertia) {
  const double low = std::min({inertia.x, inertia.y, inertia.z}), high = std::max({inertia.x, inertia.y, inertia.z});
  return high - low <= kIsotropic * high;
}

// The spin that a rotation has with an angular momentum.
Vec3 spin_of(Quat rotation, Vec3 inertia, Vec3 momentum) { return rotation * unscaled(conjugate(rotation) * momentum, inertia); }

void turn_part(Quat& rotation, Vec3 first_guess, Vec3 inertia, Vec3 momentum, double seconds) {
  Vec3 middle = first_guess;
  for (int round = 0; round < kMostRounds; ++round) {
    const Vec3 next = spin_of(turned_by(rotation, middle * (seconds / 2)), inertia, momentum);
    const double change = distance(next, middle);
    middle = next;
    if (change <= kSettled * length(middle)) break;
  }
  rotation = turned_by(rotation, middle * seconds);
}

}  // namespace

Quat turned_by(Quat q, Vec3 rotation) {
  const double angle = length(rotation);
  // sin(x / 2) / x, by its series where the quotient would lose digits.
  const double part = angle < 1e-4 ? 0.5 - angle * angle / 48 : std::sin(angle / 2) / angle;
  return normalized(Quat{rotation.x * part, rotation.y * part, rotation.z * part, std::cos(angle / 2)} * q);
}

namespace {

Vec3 axis(int k) { return {k == 0 ? 1.0 : 0.0, k == 1 ? 1.0 : 0.0, k == 2 ? 1.0 : 0.0}; }
double component(Vec3 v, int k) { return k == 0 ? v.x : k == 1 ? v.y : v.z; }

// Turned about its own axis k by as much as the momentum along that axis gives at `rate` (1 / moment) in a time.
void turn_about_own(Quat& rotation, Vec3 momentum, int k, double rate, double seconds) {
  const double angle = component(conjugate(rotation) * momentum, k) * rate * seconds;
  rotation = normalized(rotation * axis_angle(axis(k), angle));
}

// For bodies so thin that the iteration would not settle: their energy L.I^-1 L / 2 is that of a body with two equal
// moments, of which the turning is known in closed form, and a small rest, which is two turns about own axes. A symmetric
// splitting: it too keeps L, and swings the energy by O(h^2).
void turn_thin(Quat& rotation, Vec3 inertia, Vec3 momentum, double seconds) {
  const double rate[3] = {1 / inertia.x, 1 / inertia.y, 1 / inertia.z};
  int alone = 0;  // the axis whose two others are most alike
  for (int k = 1; k < 3; ++k)
    if (std::abs(rate[(k + 1) % 3] - rate[(k + 2) % 3]) < std::abs(rate[(alone + 1) % 3] - rate[(alone + 2) % 3])) alone = k;
  const int one = (alone + 1) % 3, other = (alone + 2) % 3;
  const double mean = (rate[one] + rate[other]) / 2, rest = (rate[one] - rate[other]) / 2;

  turn_about_own(rotation, momentum, one, rest, seconds / 2);
  turn_about_own(rotation, momentum, other, -rest, seconds / 2);
  turn_about_own(rotation, momentum, alone, rate[alone] - mean, seconds);
  rotation = turned_by(rotation, momentum * (mean * seconds));
  turn_about_own(rotation, momentum, other, -rest, seconds / 2);
  turn_about_own(rotation, momentum, one, rest, seconds / 2);
}

}  // namespace

void turn(Quat& rotation, Vec3& spin, Vec3 inertia, double seconds) {
  if (isotropic(inertia)) {
    rotation = turned_by(rotation, spin * seconds);
    return;
  }
  const Vec3 momentum = rotation * scaled(inertia, conjugate(rotation) * spin);
  // The fastest that the momentum can make it turn, about its easiest axis.
  const double fastest = length(momentum) / std::min({inertia.x, inertia.y, inertia.z});
  if (fastest * seconds > kMostParts * kLargestPart) {
    turn_thin(rotation, inertia, momentum, seconds);
    spin = spin_of(rotation, inertia, momentum);
    return;
  }
  const int parts = std::clamp(static_cast<int>(std::ceil(fastest * seconds / kLargestPart)), 1, kMostParts);
  for (int i = 0; i < parts; ++i) {
    turn_part(rotation, spin, inertia, momentum, seconds / parts);
    spin = spin_of(rotation, inertia, momentum);
  }
}

}  // namespace tumble::dynamics
