#include "physics/dynamics/heap.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstdint>

#include "physics/dynamics/rotation.h"

namespace tumble::dynamics {

namespace {

// Rounds go on, where it still runs, while speeds change by more than so many m/s for each second of a substep: a few rounds
// until a stack does not tremble, and many while a blow goes through it.
constexpr double kQuiet = 1, kLoose = 25;
// A blow that changes a speed by this much, m/s, is followed further down than what sways, where that is affordable: what
// it leaves undone in a wall that lands topples its columns. So far with so many contacts, and less with more.
constexpr double kBlow = 1, kLooseInBlow = 4, kInBlow = 250;
constexpr double kLeastKept = 1e-30;  // of a velocity, in a substep
constexpr std::size_t kBodies = 128, kBatches = 24;  // that are worth handing to another thread
constexpr int kColors = 63;          // and one more for what has neighbours in all of them, a contact to a batch

void set(Motion& motion, double along, double about) {
  for (int k = 0; k < 3; ++k) {
    motion.along[k] = static_cast<float>(along);
    motion.about[k] = static_cast<float>(about);
  }
}
void set(float* to, Vec3 v) {
  to[0] = static_cast<float>(v.x);
  to[1] = static_cast<float>(v.y);
  to[2] = static_cast<float>(v.z);
}
Vec3 get(const float* v) { return {v[0], v[1], v[2]}; }

// Corners turn with their body, what is round rolls on.
void turn_arm(Quat turned, Vec3 hub, Vec3 axis, Vec3 out, Vec3& arm) {
  const Vec3 spoke = arm - hub;
  arm = turned * hub + rolled(spoke, turned * axis, out).value_or(spoke);
}

}  // namespace

template <class F>
template <class Each>
void HeapOf<F>::each_body(Team& team, const Each& each) {
  team.each(records_.size() - 1, kBodies, [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) each(i + 1);
  });
}

template <class F>
template <class Each>
void HeapOf<F>::each_batch(Team& team, const Each& each) {
  team.each(batches_.size(), kBatches, [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) each(i);
  });
}

// Batches of a color share no body, colors come one after another; in the last one, each batch does for itself.
template <class F>
template <class Each>
void HeapOf<F>::each_by_color(Team& team, const Each& each) {
  for (std::size_t color = 0; color + 1 < colors_.size(); ++color) {
    const std::size_t first = colors_[color], count = colors_[color + 1] - first;
    team.each(count, color == kColors ? count : kBatches, [&](std::size_t from, std::size_t to) {
      for (std::size_t i = first + from; i < first + to; ++i) each(batches_[i]);
    });
  }
}

template <class F>
void HeapOf<F>::add(Island& island) {
  if (records_.empty()) records_.push_back({});  // of all that cannot be pushed
  for (Mover* mover : island.movers) {
    mover->record = 0;
    if (!mover->pushable) continue;
    mover->record = static_cast<int>(records_.size());
    deep_ += mover->deep;
    const Vec3 i = mover->inertia;
    const Quat q = mover->rotation;
    records_.push_back({mover,
                        {q * Vec3{1 / std::sqrt(i.x), 0, 0}, q * Vec3{0, 1 / std::sqrt(i.y), 0}, q * Vec3{0, 0, 1 / std::sqrt(i.z)}},
                        std::sqrt(mover->inverse_mass.x), {}});
  }
  for (Contact* contact : island.contacts)
    if (contact->count > 0) members_.push_back({contact});
}

template <class F>
void HeapOf<F>::set_drive(std::size_t i, double h) {
  const Record& record = records_[i];
  const Mover& mover = *record.mover;
  const Flight f = flight(mover.damping, h), turning = flight(mover.angular_damping, h);
  const Vec3 pull = mover.acceleration / record.root_mass;
  const Vec3 twist = record.scaled(mover.torque);
  Drive& drive = drives_[i];
  set(drive.kept, f.kept, turning.kept);
  set(drive.gained.along, pull * f.gained);
  set(drive.gained.about, twist * turning.gained);
  // Where damping leaves nothing of a velocity, nothing can be said of the mean by it.
  const auto part = [](const Flight& flight) { return flight.kept > kLeastKept ? flight.mean_kept / flight.kept : 0; };
  const double along = part(f), about = part(turning);
  set(drive.mean_kept, along, about);
  set(drive.mean_gained.along, pull * (f.mean_gained - f.gained * along));
  set(drive.mean_gained.about, twist * (turning.mean_gained - turning.gained * about));
}

template <class F>
void HeapOf<F>::set_up(double h, Team& team) {
  const std::size_t count = records_.size();
  drives_.assign(count, {});
  velocities_.assign(count, {});
  free_.assign(count, {});
  held_.assign(count, {});
  stirred_.assign(count, -1);
  ways_.assign(count, {});
  each_body(team, [&](std::size_t i) {
    const Record& record = records_[i];
    const Mover& mover = *record.mover;
    set_drive(i, h);
    set(velocities_[i].along, mover.velocity / record.root_mass);
    const Vec3 own = conjugate(mover.rotation) * mover.spin, m = mover.inertia;
    set(velocities_[i].about, {own.x * std::sqrt(m.x), own.y * std::sqrt(m.y), own.z * std::sqrt(m.z)});
  });
  color();
  make_batches();
  each_batch(team, [&](std::size_t i) {
    for (std::size_t m = members_of_[i]; m < members_of_[i + 1]; ++m) fill(batches_[i], members_[m].lane, members_[m], h);
  });
}

// Each contact takes the first color that neither of its bodies has yet.
template <class F>
void HeapOf<F>::color() {
  std::vector<std::uint64_t> taken(records_.size());
  for (Member& member : members_) {
    const auto a = static_cast<std::size_t>(index_of(*member.contact->a)), b = static_cast<std::size_t>(index_of(*member.contact->b));
    const std::uint64_t both = taken[a] | taken[b];
    member.color = std::min(kColors, std::countr_one(both));
    if (member.color == kColors) continue;
    if (a) taken[a] |= std::uint64_t{1} << member.color;
    if (b) taken[b] |= std::uint64_t{1} << member.color;
  }
}

// By color, those of many points first, and else as they were: a counting sort.
template <class F>
void HeapOf<F>::sort_members() {
  constexpr int kMost = Contact::kMostPoints;
  const auto key = [](const Member& member) { return static_cast<std::size_t>(member.color * kMost + kMost - member.contact->count); };
  std::array<std::size_t, (kColors + 1) * kMost + 1> starts{};
  for (const Member& member : members_) ++starts[key(member) + 1];
  for (std::size_t i = 1; i < starts.size(); ++i) starts[i] += starts[i - 1];
  sorted_.resize(members_.size());
  for (const Member& member : members_) sorted_[starts[key(member)]++] = member;
  members_.swap(sorted_);
}

template <class F>
void HeapOf<F>::make_batches() {
  sort_members();
  batches_.clear();
  colors_.clear();
  members_of_.clear();
  int rows = 0, used = 0, color = -1;
  for (Member& member : members_) {
    if (member.color != color || used == kLanes<F> || color == kColors) {
      while (color < member.color) colors_.push_back(batches_.size()), ++color;
      members_of_.push_back(static_cast<std::size_t>(&member - members_.data()));
      used = 0;
      batches_.push_back({});
      batches_.back().first = rows;
      batches_.back().count = member.contact->count;  // the most: the others follow
      rows += member.contact->count;
    }
    member.batch = static_cast<int>(batches_.size()) - 1;
    member.lane = used++;
  }
  colors_.push_back(batches_.size());
  members_of_.push_back(members_.size());
  rows_.assign(static_cast<std::size_t>(rows), {});
}

template <class F>
void HeapOf<F>::fill(Batch<F>& batch, int i, Member& member, double h) {
  Contact& contact = *member.contact;
  const Mover &a = *contact.a, &b = *contact.b;
  const Record &of_a = record_of(a), &of_b = record_of(b);
  batch.a[i] = index_of(a);
  batch.b[i] = index_of(b);
  const double root_a = a.pushable ? of_a.root_mass : 0, root_b = b.pushable ? of_b.root_mass : 0;
  const double lightness = root_a * root_a + root_b * root_b;
  const auto put = [i](F& to, double value) { lane(to, i) = static_cast<float>(value); };
  set_lane(batch.normal, i, contact.normal.x, contact.normal.y, contact.normal.z);
  set_lane(batch.tangent_1, i, contact.tangent_1.x, contact.tangent_1.y, contact.tangent_1.z);
  set_lane(batch.tangent_2, i, contact.tangent_2.x, contact.tangent_2.y, contact.tangent_2.z);
  put(batch.root_a, root_a);
  put(batch.root_b, root_b);
  put(batch.lightness, lightness);
  put(batch.fastest_push, contact.fastest_push);
  put(batch.friction, contact.friction);
  for (int k = 0; k < contact.count; ++k) {
    TouchPoint& point = contact.points[k];
    PointRow<F>& row = rows_[static_cast<std::size_t>(batch.first + k)];
    const Vec3 ja = of_a.scaled(cross(point.arm_a, contact.normal)), jb = -of_b.scaled(cross(point.arm_b, contact.normal));
    set_lane(row.about_a, i, ja.x, ja.y, ja.z);
    set_lane(row.about_b, i, jb.x, jb.y, jb.z);
    const double mobility = lightness + dot(ja, ja) + dot(jb, jb);
    put(row.mass, mobility > 0 ? 1 / mobility : 0);
    put(row.gap, point.separation - contact.lift);
    put(row.impulse, point.impulse * h);  // between steps a force
    double drive = 0;
    if (!a.pushable) drive -= dot(contact.normal, a.velocity_at(point.arm_a));
    if (!b.pushable) drive += dot(contact.normal, b.velocity_at(point.arm_b));
    put(row.drive, drive);
  }
  fill_friction(batch, i, member, h);
}

// As Contact::place_friction, where the points press as they did when the last step ended.
template <class F>
void HeapOf<F>::fill_friction(Batch<F>& batch, int i, Member& member, double h) {
  const Contact& contact = *member.contact;
  const Mover &a = *contact.a, &b = *contact.b;
  const Record &of_a = record_of(a), &of_b = record_of(b);
  const Contact::Place place = contact.friction_place(&TouchPoint::impulse);
  member.lever = place.lever;
  const Vec3 grip = contact.grip * h;
  set_lane(batch.grip, i, grip.x, grip.y, place.lever > 0 ? grip.z / place.lever : 0);
  const Vec3 ra[3] = {cross(place.arm_a, contact.tangent_1), cross(place.arm_a, contact.tangent_2), contact.normal * place.lever};
  const Vec3 rb[3] = {cross(place.arm_b, contact.tangent_1), cross(place.arm_b, contact.tangent_2), contact.normal * place.lever};
  Vec3 ja[3], jb[3];
  for (int k = 0; k < 3; ++k) {
    ja[k] = of_a.scaled(ra[k]);
    jb[k] = -of_b.scaled(rb[k]);
    set_lane(batch.about_a[k], i, ja[k].x, ja[k].y, ja[k].z);
    set_lane(batch.about_b[k], i, jb[k].x, jb[k].y, jb[k].z);
  }
  const double lightness = lane(batch.lightness, i);
  const auto speed = [&](int j, int k) { return dot(ja[j], ja[k]) + dot(jb[j], jb[k]) + (j == k && j < 2 ? lightness : 0); };
  Symmetric slip{speed(0, 0), speed(1, 1), speed(2, 2), speed(0, 1), speed(0, 2), speed(1, 2)};
  if (slip.zz <= 0) slip.zz = std::max(slip.xx, slip.yy);
  const Symmetric stop = inverse(slip);
  set_lane(batch.stop[0], i, stop.xx, stop.xy, stop.xz);
  set_lane(batch.stop[1], i, stop.xy, stop.yy, stop.yz);
  set_lane(batch.stop[2], i, stop.xz, stop.yz, stop.zz);
  const double stiffest = std::max({slip.xx + std::abs(slip.xy) + std::abs(slip.xz), slip.yy + std::abs(slip.xy) + std::abs(slip.yz),
                                    slip.zz + std::abs(slip.xz) + std::abs(slip.yz)});
  lane(batch.careful, i) = static_cast<float>(stiffest > 0 ? 1 / stiffest : 0);
  Vec3 belt = contact.belt;
  double twist = 0;
  if (!a.pushable) belt -= a.velocity_at(place.arm_a), twist -= dot(contact.normal, a.spin);
  if (!b.pushable) belt += b.velocity_at(place.arm_b), twist += dot(contact.normal, b.spin);
  set_lane(batch.belt, i, dot(belt, contact.tangent_1), dot(belt, contact.tangent_2), twist * place.lever);
}

template <class F>
void HeapOf<F>::kick(std::size_t i) {
  const Drive& drive = drives_[i];
  Motion &v = velocities_[i], &free = free_[i];
  four(free.along) = four(v.along) * four(drive.kept.along) + four(drive.gained.along);
  four(free.about) = four(v.about) * four(drive.kept.about) + four(drive.gained.about);
  four(v.along) = four(free.along) + four(held_[i].along);
  four(v.about) = four(free.about) + four(held_[i].about);
}

// With the velocity at the end, which is the one that contacts were solved for. What nothing touches flies with the mean.
template <class F>
void HeapOf<F>::drift(std::size_t i, float h) {
  const Motion &v = velocities_[i], &free = free_[i];
  const bool touched = !std::equal(v.along, v.along + 3, free.along);
  const Drive& drive = drives_[i];
  four(ways_[i].along) += (touched ? four(v.along) : four(v.along) * four(drive.mean_kept.along) + four(drive.mean_gained.along)) * h;
  four(ways_[i].about) += (touched ? four(v.about) : four(v.about) * four(drive.mean_kept.about) + four(drive.mean_gained.about)) * h;
}

template <class F>
void HeapOf<F>::hold(std::size_t i) {
  four(held_[i].along) = four(velocities_[i].along) - four(free_[i].along);
  four(held_[i].about) = four(velocities_[i].about) - four(free_[i].about);
}

// Which lanes have a body that a later round changed much? What others share the batch does not matter to any of them.
template <class F>
bool HeapOf<F>::find_stirred(const Batch<F>& batch, int round, F& lanes) const {
  bool any = false;
  for (int i = 0; i < kLanes<F>; ++i) {
    const int last = std::max(stirred_[static_cast<std::size_t>(batch.a[i])], stirred_[static_cast<std::size_t>(batch.b[i])]);
    lane(lanes, i) = last >= round ? 1.0f : 0.0f;
    any |= last >= round;
  }
  return any;
}

// Did it change a speed much?
template <class F>
bool HeapOf<F>::solve_batch(Batch<F>& batch, int round, int least, const Aim& aim) {
  F takes_part = all<F>(1);
  if (round >= least && !find_stirred(batch, round - 1, takes_part)) return false;
  const double after_blow = std::clamp(kLooseInBlow * static_cast<double>(members_.size()) / kInBlow, kLooseInBlow, kLoose);
  const auto loose = static_cast<float>((round < kFewRounds ? kQuiet : blow_ ? after_blow : kLoose) / aim.per_second);
  const F changed = solve(batch, rows_.data(), velocities_.data(), aim, takes_part);
  if (round == 0 && any_reaches(changed, kBlow)) blow_.store(true, std::memory_order_relaxed);
  if (!any_reaches(changed, loose)) return false;
  for (int i = 0; i < kLanes<F>; ++i) {
    if (lane(changed, i) < loose) continue;
    if (batch.a[i]) stirred_[static_cast<std::size_t>(batch.a[i])] = round;
    if (batch.b[i]) stirred_[static_cast<std::size_t>(batch.b[i])] = round;
  }
  return true;
}

// As solve_in_rounds in island.cpp, a batch at a time.
template <class F>
void HeapOf<F>::solve_in_rounds(int least, const Aim& aim, Team& team) {
  std::fill(stirred_.begin(), stirred_.end(), -1);
  const double contacts = static_cast<double>(members_.size()), around = std::max(contacts, deep_ / 2) / static_cast<double>(records_.size());
  const int most = most_rounds(contacts, around, least);
  for (int round = 0; round < most; ++round) {
    std::atomic<bool> any = false;
    each_by_color(team, [&](Batch<F>& batch) {
      if (solve_batch(batch, round, least, aim)) any.store(true, std::memory_order_relaxed);
    });
    if (round + 1 >= least && !any) break;
  }
}

template <class F>
void HeapOf<F>::run(double seconds, int substeps, int rounds, Team& team) {
  if (records_.empty()) return;
  const double h = seconds / substeps;
  const auto step = static_cast<float>(h);
  const Softness softness = contact_softness(h);
  set_up(h, team);
  for (int i = 0; i < substeps; ++i) {
    each_batch(team, [&](std::size_t k) { measure(batches_[k], rows_.data(), ways_.data(), static_cast<float>(i) * step); });
    each_body(team, [&](std::size_t k) { kick(k); });
    if (i == 0) each_by_color(team, [&](Batch<F>& batch) { warm_start(batch, rows_.data(), velocities_.data()); });
    blow_ = false;
    solve_in_rounds(rounds, {&softness, 1 / step}, team);
    each_body(team, [&](std::size_t k) { drift(k, step); });
    solve_in_rounds(rounds, {nullptr, 1 / step}, team);
    each_batch(team, [&](std::size_t k) { sum_up(batches_[k], rows_.data()); });
    each_body(team, [&](std::size_t k) { hold(k); });
  }
  finish(seconds, h, team);
  records_.clear();
  members_.clear();
  deep_ = 0;
}

// The spin follows from the angular momentum and from how it then is turned.
template <class F>
void HeapOf<F>::move(Record& record, const Motion& way, const Motion& velocity) const {
  Mover& mover = *record.mover;
  mover.position += get(way.along) * record.root_mass;
  mover.velocity = get(velocity.along) * record.root_mass;
  const auto turned = [&](const float* about) { return record.across[0] * about[0] + record.across[1] * about[1] + record.across[2] * about[2]; };
  const Vec3 spin = turned(velocity.about), m = mover.inertia;
  const Vec3 momentum = mover.rotation * scaled(m, conjugate(mover.rotation) * spin);
  record.turned = turned_by({}, turned(way.about));
  mover.rotation = normalized(record.turned * mover.rotation);
  mover.spin = mover.rotation * unscaled(conjugate(mover.rotation) * momentum, m);
}

template <class F>
void HeapOf<F>::finish(double seconds, double h, Team& team) {
  each_batch(team, [&](std::size_t i) { measure(batches_[i], rows_.data(), ways_.data(), static_cast<float>(seconds)); });
  each_body(team, [&](std::size_t i) { move(records_[i], ways_[i], velocities_[i]); });
  each_batch(team, [&](std::size_t i) {
    for (std::size_t m = members_of_[i]; m < members_of_[i + 1]; ++m) read_back(members_[m], seconds, h);
  });
}

template <class F>
void HeapOf<F>::read_back(const Member& member, double seconds, double h) {
  Contact& contact = *member.contact;
  const Batch<F>& batch = batches_[static_cast<std::size_t>(member.batch)];
  const double force = 1 / h;  // between steps
  for (int k = 0; k < contact.count; ++k) {
    TouchPoint& point = contact.points[k];
    const PointRow<F>& row = rows_[static_cast<std::size_t>(batch.first + k)];
    point.impulse = lane(row.impulse, member.lane) * force;
    point.sum = lane(row.sum, member.lane);
    point.separation = lane(row.separation, member.lane) + contact.lift;
    if (contact.a->pushable) turn_arm(record_of(*contact.a).turned, point.hub_a, contact.axis_a, -contact.normal, point.arm_a);
    if (contact.b->pushable) turn_arm(record_of(*contact.b).turned, point.hub_b, contact.axis_b, contact.normal, point.arm_b);
  }
  contact.raise(seconds);
  const auto grip = [&](F Triple<F>::*of) { return lane(batch.grip.*of, member.lane) * force; };
  contact.grip = {grip(&Triple<F>::x), grip(&Triple<F>::y), grip(&Triple<F>::z) * member.lever};
}

template class HeapOf<Four>;
template class HeapOf<float>;

}  // namespace tumble::dynamics
