// Contacts that share no body, a lane each, as rows of numbers that are known for the whole step.
//
// Velocities are scaled by the roots of mass and of inertia, the latter in the principal axes that a body had when the
// step began. A row of such numbers then both measures a speed and hands on an impulse: J M^-1/2, with J its Jacobian.
#pragma once

#include "physics/dynamics/contact.h"
#include "physics/dynamics/lanes.h"

namespace tumble::dynamics {

// Of one point of each contact, along the normal.
template <class F>
struct PointRow {
  Triple<F> about_a, about_b;
  F mass{};                  // kg, of the point; 0 where a lane has none
  F drive{};                 // m/s, closing, by what moves and cannot be pushed
  F gap{};                   // m, when the step began; less the lift, as what follows
  F separation{};            // m, in this substep
  F impulse{}, sum{};        // N s, in this substep, and in the step
};

template <class F>
struct Batch {
  int a[kLanes<F>] = {}, b[kLanes<F>] = {};
  int first = 0, count = 0;  // of its point rows
  Triple<F> normal, tangent_1, tangent_2;
  F root_a{}, root_b{};      // 1 over the root of the mass
  F lightness{};             // 1/kg, of both
  F fastest_push{};
  F friction{};
  Triple<F> about_a[3], about_b[3];  // of both tangents and the twist
  Triple<F> belt;            // speed of b against a that is not its motion
  Triple<F> stop[3];         // what impulse brings a slip to rest
  F careful{};               // that brings none of it beyond rest
  Triple<F> grip;            // N s, as a row's impulses
};

// What is asked for: to be apart after the drift, or, where `soft` is nullptr, to be at rest after it.
struct Aim {
  const Softness* soft = nullptr;
  float per_second = 0;      // 1 / h
};

// Separations at the displacements that bodies have made in the step, `time` after it began.
template <class F>
void measure(const Batch<F>& batch, PointRow<F>* rows, const Motion* ways, float time);
// Sums up what the points gave in a substep.
template <class F>
void sum_up(const Batch<F>& batch, PointRow<F>* rows);
// Gives the impulses that are there already.
template <class F>
void warm_start(const Batch<F>& batch, const PointRow<F>* rows, Motion* velocities);
// Lanes take part by 1 or 0. Tells the largest change of a speed, m/s.
template <class F>
F solve(Batch<F>& batch, PointRow<F>* rows, Motion* velocities, const Aim& aim, F takes_part);

extern template void sum_up(const Batch<Four>&, PointRow<Four>*);
extern template void measure(const Batch<Four>&, PointRow<Four>*, const Motion*, float);
extern template void warm_start(const Batch<Four>&, const PointRow<Four>*, Motion*);
extern template Four solve(Batch<Four>&, PointRow<Four>*, Motion*, const Aim&, Four);
extern template void sum_up(const Batch<float>&, PointRow<float>*);
extern template void measure(const Batch<float>&, PointRow<float>*, const Motion*, float);
extern template void warm_start(const Batch<float>&, const PointRow<float>*, Motion*);
extern template float solve(Batch<float>&, PointRow<float>*, Motion*, const Aim&, float);

}  // namespace tumble::dynamics
