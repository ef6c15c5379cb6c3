// A body as the solver sees it: where it is, how it moves, how hard it is to push. A few numbers, no more.
#pragma once

#include "physics/dynamics/symmetric.h"

namespace tumble::dynamics {

// 0 of what is not above 0: nothing turns what has no moment.
constexpr double reciprocal(double x) { return x > 0 ? 1 / x : 0; }

struct Mover {
  Vec3 position;               // centre of mass, world, m
  Quat rotation;               // from its principal axes to the world
  Vec3 velocity, spin;         // world, m/s and rad/s
  Vec3 inverse_mass;           // 1/kg along the world's axes; 0 where locked, and of what cannot be pushed
  Symmetric inverse_inertia;   // world, 1/(kg m^2); see refresh()

  Vec3 inertia;                // principal moments, kg m^2
  Vec3 turn_factor{1, 1, 1};   // about the world's axes; 0 is locked
  Vec3 acceleration;           // m/s^2, of all forces on it in this step; of what is moved, about its mean velocity
  Vec3 torque;                 // N m
  double damping = 0, angular_damping = 0;  // 1/s
  double stiffness = 0;        // kg m^2 to be added across `stiff_axis`: see JointGroup
  Vec3 stiff_axis;
  Vec3 way, turn;              // a correction that is being summed up
  Vec3 impulse, twist;
  bool pushable = false;       // a dynamic body
  int island = -1;             // of what can be pushed
  int stirred = 0;             // the last round of the solver that changed its velocity much
  bool bound = false;          // a joint holds it
  int record = 0;              // of a heap
  int grounds = 0;             // how many contacts it has with what cannot be pushed
  int deep = 0;                // how many are deep ones: see Crowd

  // The inverse inertia at the rotation that it has now.
  void refresh();
  void push(Vec3 impulse, Vec3 twist) {
    if (!pushable) return;  // nothing times an impulse that is no number would be none either
    velocity += scaled(inverse_mass, impulse);
    spin += inverse_inertia * twist;
  }
  // A correction of its place that changes neither momentum nor angular momentum; of what can be pushed.
  void shift(Vec3 way, Vec3 turn);
  Vec3 velocity_at(Vec3 arm) const { return velocity + cross(spin, arm); }
};

// Along the axis in which it is lightest to push, kg; 0 of what cannot be pushed.
double mass_of(const Mover& mover);

// The mean velocity over h and the last one, of v' = a - k v: mean = v * mean_kept + a * mean_gained, and so on.
struct Flight {
  double mean_kept, mean_gained, kept, gained;
};
Flight flight(double damping, double h);

// A step of h is a kick by half of what the forces give, a drift with the velocity that then is, and the other half: the
// drift is h times the mean velocity, so that free flight under a constant force and damping is exact at any h
// (velocity Verlet; with the constraints solved before and after the drift, RATTLE: H. C. Andersen, J. Comput. Phys. 52,
// 1983). Spin is damped by half before and by half after.
void kick_before(Mover& mover, double h);
void kick_after(Mover& mover, double h);
// Moves and turns it, at constant angular momentum where no axis is locked.
void drift(Mover& mover, double h);

}  // namespace tumble::dynamics
