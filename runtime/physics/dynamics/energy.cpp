#include "physics/dynamics/energy.h"

#include <algorithm>

namespace tumble::dynamics {

namespace {

// Of the energy of the motion that is scaled, less than this part is given or taken at once: what went amiss by more was
// no matter of h^2.
constexpr double kMostPart = 1e-2;
// A rigid motion that moves a row by less than this part of its spin keeps to it.
constexpr double kKeepsTo = 1e-4;
constexpr double kSameStep = 1e-9;

struct Rigid {
  Vec3 center, velocity, spin;
  Vec3 velocity_at(Vec3 place) const { return velocity + cross(spin, place - center); }
};

double along(const Rigid& motion, const Mover& mover, Vec3 linear, Vec3 angular) {
  return mover.pushable ? dot(linear, motion.velocity_at(mover.position)) + dot(angular, motion.spin) : 0;
}

bool keeps_to(const Rigid& motion, const std::vector<const Link*>& bearings) {
  for (const Link* link : bearings)
    for (const JointRow& row : link->rows.held) {
      const double speed = along(motion, *link->a, row.linear_a, row.angular_a) + along(motion, *link->b, row.linear_b, row.angular_b);
      if (std::abs(speed) > kKeepsTo * length(motion.spin)) return false;
    }
  return true;
}

// Mass, momentum and so on of all bodies, about a place.
struct Whole {
  double mass = 0;
  Vec3 momentum, angular_momentum;
  Symmetric inertia;
};

Whole whole(const std::vector<Mover*>& bodies, Vec3 about) {
  Whole all;
  for (const Mover* mover : bodies) {
    const double mass = mass_of(*mover);
    const Vec3 arm = mover->position - about, momentum = mover->velocity * mass;
    const Symmetric own = turned(mover->rotation, mover->inertia);
    all.mass += mass;
    all.momentum += momentum;
    all.angular_momentum += cross(arm, momentum) + own * mover->spin;
    const Vec3 s{arm.x * arm.x, arm.y * arm.y, arm.z * arm.z};
    all.inertia = all.inertia + own + Symmetric{mass * (s.y + s.z), mass * (s.x + s.z), mass * (s.x + s.y),
                                                -mass * arm.x * arm.y, -mass * arm.x * arm.z, -mass * arm.y * arm.z};
  }
  return all;
}

// The motion of all bodies as one that has their momentum and angular momentum. Of what hangs, about the place where it
// does: as a whole, or about the direction of what pulls, about which alone angular momentum then stays. In the measure of
// the masses the rest of the motion is at right angles to it, so that energies add up.
Rigid rigid_part(const std::vector<Mover*>& bodies, const std::vector<Link*>& links) {
  std::vector<const Link*> bearings;
  for (const Link* link : links)
    if (!link->a->pushable || !link->b->pushable) bearings.push_back(link);
  Rigid motion;
  if (bearings.empty()) {
    double mass = 0;
    for (const Mover* mover : bodies) {
      mass += mass_of(*mover);
      motion.center += mover->position * mass_of(*mover);
    }
    motion.center = motion.center * reciprocal(mass);
  } else {
    const JointFrame held = frame(*bearings.front());
    motion.center = bearings.front()->a->pushable ? held.b.position : held.a.position;
  }
  const Whole all = whole(bodies, motion.center);
  if (bearings.empty()) motion.velocity = all.momentum * reciprocal(all.mass);
  motion.spin = inverse(all.inertia) * all.angular_momentum;
  if (keeps_to(motion, bearings)) return motion;
  const Vec3 pull = normalized(bodies.front()->acceleration);
  motion.spin = pull * (dot(pull, all.angular_momentum) * reciprocal(dot(pull, all.inertia * pull)));
  if (keeps_to(motion, bearings)) return motion;
  motion.spin = {};
  return motion;
}

}  // namespace

double kinetic_energy(const Mover& mover) {
  const Vec3 spin = conjugate(mover.rotation) * mover.spin;
  return (mass_of(mover) * dot(mover.velocity, mover.velocity) + dot(scaled(mover.inertia, spin), spin)) / 2;
}

double energy_of_fall(const Mover& mover, double seconds) {
  return mass_of(mover) * dot(mover.acceleration, mover.acceleration) * seconds * seconds / 2;
}

bool without_loss(const std::vector<Mover*>& bodies, const std::vector<Link*>& links) {
  const auto lossless = [](const Mover* mover) {
    const Vec3 light = mover->inverse_mass;
    return mover->damping == 0 && mover->angular_damping == 0 && mover->torque == Vec3{} && mover->turn_factor == Vec3{1, 1, 1} &&
           light.x == light.y && light.y == light.z;
  };
  const auto still = [](const Mover* mover) {
    return mover->pushable || (mover->velocity == Vec3{} && mover->spin == Vec3{} && mover->acceleration == Vec3{});
  };
  return std::all_of(bodies.begin(), bodies.end(), lossless) &&
         std::all_of(links.begin(), links.end(), [&](const Link* link) { return still(link->a) && still(link->b); });
}

bool add_energy(const std::vector<Mover*>& bodies, const std::vector<Link*>& links, double energy) {
  const Rigid motion = rigid_part(bodies, links);
  double inner = 0;
  for (const Mover* mover : bodies) {
    Mover apart = *mover;
    apart.velocity -= motion.velocity_at(mover->position);
    apart.spin -= motion.spin;
    inner += kinetic_energy(apart);
  }
  if (!(std::abs(energy) < kMostPart * inner)) return false;
  const double factor = std::sqrt(1 + energy / inner);
  for (Mover* mover : bodies) {
    const Vec3 velocity = motion.velocity_at(mover->position);
    mover->velocity = velocity + (mover->velocity - velocity) * factor;
    mover->spin = motion.spin + (mover->spin - motion.spin) * factor;
  }
  return true;
}

void EnergyBook::begin(const std::vector<Mover*>& bodies, const std::vector<Link*>& links, double h) {
  if (gained_ != 0 && std::abs(h - h_) > kSameStep * h) {
    const double left = h < h_ ? gained_ * (h / h_) * (h / h_) : 0;
    gained_ = add_energy(bodies, links, left - gained_) ? left : 0;
  }
  h_ = h;
  kinetic_ = 0;
  places_.clear();
  for (const Mover* mover : bodies) {
    kinetic_ += kinetic_energy(*mover);
    places_.push_back(mover->position);
  }
}

void EnergyBook::end(const std::vector<Mover*>& bodies, bool conserved) {
  if (!conserved) {
    gained_ = 0;
    return;
  }
  gained_ -= kinetic_;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Mover& mover = *bodies[i];
    gained_ += kinetic_energy(mover) - mass_of(mover) * dot(mover.acceleration, mover.position - places_[i]);
  }
}

}  // namespace tumble::dynamics
