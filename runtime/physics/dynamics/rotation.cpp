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

void turn(Quat& rotation, Vec3& spin, Vec3 inertia, double seconds) {
  if (isotropic(inertia)) {
    rotation = turned_by(rotation, spin * seconds);
    return;
  }
  const Vec3 momentum = rotation * scaled(inertia, conjugate(rotation) * spin);
  // The fastest that the momentum can make it turn, about its easiest axis.
  const double fastest = length(momentum) / std::min({inertia.x, inertia.y, inertia.z});
  const int parts = std::clamp(static_cast<int>(std::ceil(std::min(fastest * seconds / kLargestPart, 1e3))), 1, 64);
  for (int i = 0; i < parts; ++i) {
    turn_part(rotation, spin, inertia, momentum, seconds / parts);
    spin = spin_of(rotation, inertia, momentum);
  }
}

}  // namespace tumble::dynamics
