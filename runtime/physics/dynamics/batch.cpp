#include "physics/dynamics/batch.h"

namespace tumble::dynamics {

namespace {

// Successive over-relaxation: each row goes this much further than it would alone, since its neighbours will follow. Stacks
// of n come to rest in fewer rounds, and then without a tremble; it converges for any factor below 2 (R. W. Cottle,
// G. H. Golub, R. S. Sacher, On the Solution of Large, Structured Linear Complementarity Problems, 1978).
constexpr float kBeyond = 1.1f, kGripBeyond = 1.3f;

// The linear motion of a against b along three directions, kept up to date while impulses are added.
template <class F>
struct Apart {
  F normal, first, second;
};

template <class F>
Apart<F> apart(const Batch<F>& batch, const Motions<F>& a, const Motions<F>& b) {
  const Triple<F> v{a.along.x * batch.root_a - b.along.x * batch.root_b, a.along.y * batch.root_a - b.along.y * batch.root_b,
                    a.along.z * batch.root_a - b.along.z * batch.root_b};
  return {dot(batch.normal, v), dot(batch.tangent_1, v), dot(batch.tangent_2, v)};
}

// A sum of impulses along the three directions, as motion along.
template <class F>
void push(const Batch<F>& batch, const Apart<F>& impulse, Motions<F>& a, Motions<F>& b) {
  Triple<F> sum;
  add(sum, batch.normal, impulse.normal);
  add(sum, batch.tangent_1, impulse.first);
  add(sum, batch.tangent_2, impulse.second);
  add(a.along, sum, batch.root_a);
  add(b.along, sum, -batch.root_b);
}

template <class F>
F wanted_impulse(const Batch<F>& batch, const PointRow<F>& row, F closing, const Aim& aim) {
  const F zero{}, apart = row.separation;
  // What is apart after the drift is the next substep's business.
  if (!aim.soft) return apart > zero ? (row.impulse > zero ? closing * row.mass : zero) : closing * row.mass;
  const auto rate = static_cast<float>(aim.soft->rate), mass_scale = static_cast<float>(aim.soft->mass_scale);
  const F back = larger(apart * rate, -batch.fastest_push);
  const F overlapping = (closing - back) * row.mass * mass_scale - row.impulse * static_cast<float>(aim.soft->impulse_scale);
  return apart > zero ? (closing - apart * aim.per_second) * row.mass : overlapping;
}

// Within mu N, as Contact::solve_friction: at once where that can be had, by projected gradient where it slides.
template <class F>
Triple<F> next_grip(const Batch<F>& batch, const Triple<F>& slip, F most) {
  const Triple<F>& grip = batch.grip;
  const F x = grip.x - dot(batch.stop[0], slip), y = grip.y - dot(batch.stop[1], slip), z = grip.z - dot(batch.stop[2], slip);
  const F slid_x = grip.x - slip.x * batch.careful, slid_y = grip.y - slip.y * batch.careful, slid_z = grip.z - slip.z * batch.careful;
  const F size = root(slid_x * slid_x + slid_y * slid_y + slid_z * slid_z);
  const F part = size > most ? most / size : all<F>(1);
  const auto holds = x * x + y * y + z * z <= most * most;
  return {holds ? x : slid_x * part, holds ? y : slid_y * part, holds ? z : slid_z * part};
}

}  // namespace

template <class F>
void measure(const Batch<F>& batch, PointRow<F>* rows, const Motion* ways, float time) {
  Motions<F> a, b;
  load(ways, batch.a, a);
  load(ways, batch.b, b);
  const F along = apart(batch, a, b).normal;
  for (int i = 0; i < batch.count; ++i) {
    PointRow<F>& row = rows[batch.first + i];
    row.separation = row.gap + along + dot(row.about_a, a.about) + dot(row.about_b, b.about) - row.drive * time;
  }
}

template <class F>
void warm_start(const Batch<F>& batch, const PointRow<F>* rows, Motion* velocities) {
  Motions<F> a, b;
  load(velocities, batch.a, a);
  load(velocities, batch.b, b);
  const F grip[3] = {batch.grip.x, batch.grip.y, batch.grip.z};
  Apart<F> impulse{F{}, grip[0], grip[1]};
  for (int i = 0; i < batch.count; ++i) {
    const PointRow<F>& row = rows[batch.first + i];
    add(a.about, row.about_a, row.impulse);
    add(b.about, row.about_b, row.impulse);
    impulse.normal += row.impulse;
  }
  for (int k = 0; k < 3; ++k) {
    add(a.about, batch.about_a[k], grip[k]);
    add(b.about, batch.about_b[k], grip[k]);
  }
  push(batch, impulse, a, b);
  store(velocities, batch.a, a);
  store(velocities, batch.b, b);
}

template <class F>
void sum_up(const Batch<F>& batch, PointRow<F>* rows) {
  for (int i = batch.first; i < batch.first + batch.count; ++i) rows[i].sum += rows[i].impulse;
}

template <class F>
F solve(Batch<F>& batch, PointRow<F>* rows, Motion* velocities, const Aim& aim, F takes_part) {
  Motions<F> a, b;
  load(velocities, batch.a, a);
  load(velocities, batch.b, b);
  const Apart<F> before = apart(batch, a, b);
  Apart<F> impulse{};
  F pressing{}, most{};
  for (int i = 0; i < batch.count; ++i) {
    PointRow<F>& row = rows[batch.first + i];
    const F closing = row.drive - (before.normal + impulse.normal * batch.lightness + dot(row.about_a, a.about) + dot(row.about_b, b.about));
    const F total = larger(F{}, row.impulse + wanted_impulse(batch, row, closing, aim) * kBeyond);
    const F change = (total - row.impulse) * takes_part;
    row.impulse += change;
    most = larger(most, larger(change, -change));
    impulse.normal += change;
    pressing += row.impulse;
    add(a.about, row.about_a, change);
    add(b.about, row.about_b, change);
  }
  const auto turning = [&](int k) { return dot(batch.about_a[k], a.about) + dot(batch.about_b[k], b.about); };
  const Triple<F> slip{(before.first + turning(0) - batch.belt.x) * kGripBeyond, (before.second + turning(1) - batch.belt.y) * kGripBeyond,
                       (turning(2) - batch.belt.z) * kGripBeyond};
  const Triple<F> grip = next_grip(batch, slip, batch.friction * pressing);
  const F change[3] = {(grip.x - batch.grip.x) * takes_part, (grip.y - batch.grip.y) * takes_part, (grip.z - batch.grip.z) * takes_part};
  batch.grip = {batch.grip.x + change[0], batch.grip.y + change[1], batch.grip.z + change[2]};
  for (int k = 0; k < 3; ++k) {
    add(a.about, batch.about_a[k], change[k]);
    add(b.about, batch.about_b[k], change[k]);
  }
  impulse.first = change[0];
  impulse.second = change[1];
  push(batch, impulse, a, b);
  store(velocities, batch.a, a);
  store(velocities, batch.b, b);
  return most * batch.lightness;
}

template void sum_up(const Batch<Four>&, PointRow<Four>*);
template void measure(const Batch<Four>&, PointRow<Four>*, const Motion*, float);
template void warm_start(const Batch<Four>&, const PointRow<Four>*, Motion*);
template Four solve(Batch<Four>&, PointRow<Four>*, Motion*, const Aim&, Four);
template void sum_up(const Batch<float>&, PointRow<float>*);
template void measure(const Batch<float>&, PointRow<float>*, const Motion*, float);
template void warm_start(const Batch<float>&, const PointRow<float>*, Motion*);
template float solve(Batch<float>&, PointRow<float>*, Motion*, const Aim&, float);

}  // namespace tumble::dynamics
