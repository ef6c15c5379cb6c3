#include "physics/dynamics/mechanism.h"

#include <algorithm>

#include "physics/dynamics/rotation.h"

namespace tumble::dynamics {

namespace {

// A freedom that the held rows leave less than this part of what its two bodies alone would have is none.
constexpr double kLeastMobility = 1e-6;
constexpr int kMostSweeps = 12;       // over drives that meet
constexpr double kSettled = 1e-9;     // part of the largest impulse at which sweeps end
constexpr int kGapRounds = 2;
constexpr double kLeastRest = 1e-5;   // m or rad, that is left to be closed in further ones
constexpr int kMostRounds = 8;        // of those
// A repair of positions that costs more than this part of the motion's energy is no motion's, and gives no velocity.
constexpr double kMostRepair = 2e-2, kMostRepairOfLoops = 2e-4;
// Of what whipped so much remains to be reckoned with after a step, of so much at most.
constexpr double kRemembered = 0.95, kMostRemembered = 5e-3;
// More than this is not closed in one round, m or rad: after a jump the rows of before are far from those of then.
constexpr double kMostGap = 0.2;
// What repairs add to the diagonal, as parts of it; less than the last time is tried once in so many substeps.
constexpr double kRegular[] = {1e-10, 1e-6, 1e-4, 1e-2};
constexpr int kMostRegular = 3, kTryLess = 8;
constexpr double kClosed = 1e-13;     // nothing to close

bool holds(const JointRow& row) { return row.friction < 0; }

double across(const JointRow& row, Vec3 shift_a, Vec3 turn_a, Vec3 shift_b, Vec3 turn_b) {
  return dot(row.linear_a, shift_a) + dot(row.angular_a, turn_a) + dot(row.linear_b, shift_b) + dot(row.angular_b, turn_b);
}

bool locked(const FreeRow& free) { return free.freedom.min && free.freedom.max && *free.freedom.min == *free.freedom.max; }

// The rows that hold: those of the kind, and freedoms whose limits are one.
template <class F>
void each_held(const Link& link, F f) {
  for (const JointRow& row : link.rows.held)
    if (holds(row)) f(row);
  for (std::size_t i = 0; i < link.rows.free.size(); ++i) {
    if (!locked(link.rows.free[i])) continue;
    JointRow row = link.rows.free[i].row;
    row.error = link.positions[i] - *link.rows.free[i].freedom.min;
    f(row);
  }
}

}  // namespace

Mechanism::Mechanism(std::vector<Link*> links) : links_(std::move(links)) {}

void Mechanism::find_bodies() {
  bodies_.clear();
  for (const Link* link : links_)
    for (Mover* mover : {link->a, link->b})
      if (mover->pushable && std::find(bodies_.begin(), bodies_.end(), mover) == bodies_.end()) bodies_.push_back(mover);
  const bool floats = std::all_of(links_.begin(), links_.end(), [](const Link* link) { return link->a->pushable && link->b->pushable; });
  tree_ = links_.size() + (floats ? 1 : 0) <= bodies_.size();
}

void Mechanism::begin_step(double h) {
  whip_ *= kRemembered;
  find_bodies();
  for (Link* link : links_) refresh(*link);
  energy_.begin(bodies_, links_, h);
  conserves_ = without_loss(bodies_, links_);
  std::vector<Drive> drives;
  for (Link* link : links_)
    for (Drive& drive : drives_of(*link)) drives.push_back(std::move(drive));
  drives_ = std::move(drives);
  gather();
  if (factor_.size() != static_cast<int>(rows_.size())) {
    find_pattern();
    pull_.setZero(static_cast<Eigen::Index>(rows_.size()));
  }
  stiffen(h);
  for (Drive& drive : drives_) refresh(drive, h);
  drive_rows_.resize(drives_.size());
  for (std::size_t i = 0; i < drives_.size(); ++i) couple(drives_[i]);
  held_.setZero(static_cast<Eigen::Index>(rows_.size()));
}

Mechanism::Row Mechanism::with_response(Link& link, const JointRow& row) const {
  Row out{&link, row, {}, {}, {}, {}, row.angular_a - cross(link.a->rotation * link.local_a.position, row.linear_a)};
  if (link.a->pushable) {
    out.shift_a = scaled(link.a->inverse_mass, row.linear_a);
    out.turn_a = link.a->inverse_inertia * row.angular_a;
  }
  if (link.b->pushable) {
    out.shift_b = scaled(link.b->inverse_mass, row.linear_b);
    out.turn_b = link.b->inverse_inertia * row.angular_b;
  }
  return out;
}

void Mechanism::gather() {
  rows_.clear();
  for (Link* link : links_) each_held(*link, [&](const JointRow& row) { rows_.push_back(with_response(*link, row)); });
}

// Two rows meet where they share a body that can be pushed.
void Mechanism::find_pattern() {
  pattern_.clear();
  for (std::size_t i = 0; i < rows_.size(); ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      const Link &x = *rows_[i].link, &y = *rows_[j].link;
      const auto shares = [&](const Mover* m) { return m->pushable && (m == y.a || m == y.b); };
      if (i == j || shares(x.a) || shares(x.b)) pattern_.emplace_back(static_cast<int>(i), static_cast<int>(j));
    }
  factor_.set_pattern(static_cast<int>(rows_.size()), pattern_);
}

void Mechanism::factor() {
  values_.clear();
  for (const auto& [i, j] : pattern_) {
    const Row &x = rows_[static_cast<std::size_t>(i)], &y = rows_[static_cast<std::size_t>(j)];
    const Link &on = *x.link, &by = *y.link;
    double value = 0;
    const bool a = on.a->pushable, b = on.b->pushable;
    if (a && on.a == by.a) value += dot(x.row.linear_a, y.shift_a) + dot(x.row.angular_a, y.turn_a);
    if (a && on.a == by.b) value += dot(x.row.linear_a, y.shift_b) + dot(x.row.angular_a, y.turn_b);
    if (b && on.b == by.a) value += dot(x.row.linear_b, y.shift_a) + dot(x.row.angular_b, y.turn_a);
    if (b && on.b == by.b) value += dot(x.row.linear_b, y.shift_b) + dot(x.row.angular_b, y.turn_b);
    values_.push_back(value);
  }
  factored_ = 0;
  if (!rows_.empty()) factor_.factor(values_, kRegular[0]);
}

void Mechanism::couple(Drive& drive) {
  if (!drive.active) return;
  Row& own = drive_rows_[static_cast<std::size_t>(&drive - drives_.data())];
  own = with_response(*drive.link, drive.row);
  drive.mobility = across(drive.row, own.shift_a, own.turn_a, own.shift_b, own.turn_b);
  drive.own_mobility = drive.mobility;
  drive.helpers.resize(0);
  if (rows_.empty()) return;
  Eigen::VectorXd coupling = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(rows_.size()));
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Row& x = rows_[i];
    const Link &on = *x.link, &by = *drive.link;
    double& value = coupling[static_cast<Eigen::Index>(i)];
    if (on.a == by.a) value += dot(x.row.linear_a, own.shift_a) + dot(x.row.angular_a, own.turn_a);
    if (on.a == by.b) value += dot(x.row.linear_a, own.shift_b) + dot(x.row.angular_a, own.turn_b);
    if (on.b == by.a) value += dot(x.row.linear_b, own.shift_a) + dot(x.row.angular_b, own.turn_a);
    if (on.b == by.b) value += dot(x.row.linear_b, own.shift_b) + dot(x.row.angular_b, own.turn_b);
  }
  drive.helpers = -factor_.solve(coupling);
  drive.mobility += coupling.dot(drive.helpers);
}

void Mechanism::give(const Row& row, double impulse) const {
  const auto give_to = [impulse](Mover& mover, Vec3 shift, Vec3 turn) {
    if (!mover.pushable) return;
    mover.velocity += shift * impulse;
    mover.spin += turn * impulse;
  };
  give_to(*row.link->a, row.shift_a, row.turn_a);
  give_to(*row.link->b, row.shift_b, row.turn_b);
  row.link->impulse += row.row.linear_a * impulse;
  row.link->twist += row.twist * impulse;
}

void Mechanism::end_step() { energy_.end(bodies_, conserves_ && !touched); }

void Mechanism::begin() {
  aimed_ = false;
  held_.setZero();
  for (Drive& drive : drives_) {
    drive.impulse = 0;
    conserves_ &= !drive.active;
    if (drive.active) drive.before = speed(*drive.link, drive.row);
  }
}

void Mechanism::solve_held() {
  if (rows_.empty()) return;
  impulses_.resize(static_cast<Eigen::Index>(rows_.size()));
  for (std::size_t i = 0; i < rows_.size(); ++i) impulses_[static_cast<Eigen::Index>(i)] = -speed(*rows_[i].link, rows_[i].row);
  factor_.solve_in_place(impulses_);
  for (std::size_t i = 0; i < rows_.size(); ++i) give(rows_[i], impulses_[static_cast<Eigen::Index>(i)]);
  held_ += impulses_;
}

// What motor, brake and limits give along a spring's freedom; they come after it in the list.
double Mechanism::beside(const Drive& spring) const {
  double sum = 0;
  for (const Drive* next = &spring + 1; next != drives_.data() + drives_.size() && next->link == spring.link && next->free_row == spring.free_row; ++next)
    if (next->active) sum += next->impulse;
  return sum;
}

double Mechanism::drive_once(Drive& drive) {
  if (!drive.active || drive.own_mobility <= 0) return 0;
  // Where what holds leaves no freedom, both pull as hard as the bodies alone would need, and once: a force that a joint
  // may break under, but none without bounds.
  const bool freedom = drive.mobility > kLeastMobility * drive.own_mobility;
  if (!freedom && drive.impulse != 0) return 0;
  const double mobility = freedom ? drive.mobility : drive.own_mobility;
  const double target = drive.kind == Drive::spring ? drive.target + drive.yield * mobility * beside(drive) : drive.target;
  const double wanted = drive.impulse + (target - speed(*drive.link, drive.row)) / mobility;
  const double total = std::clamp(wanted, drive.lower, drive.upper), change = total - drive.impulse;
  if (change == 0) return 0;
  drive.impulse = total;
  give(drive_rows_[static_cast<std::size_t>(&drive - drives_.data())], change);
  if (drive.helpers.size() == 0) return change;
  for (std::size_t i = 0; i < rows_.size(); ++i) give(rows_[i], change * drive.helpers[static_cast<Eigen::Index>(i)]);
  held_ += change * drive.helpers;
  return change;
}

void Mechanism::solve_drives() {
  const auto active = std::count_if(drives_.begin(), drives_.end(), [](const Drive& drive) { return drive.active; });
  const int sweeps = active > 1 ? kMostSweeps : 1;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    double changed = 0, largest = 0;
    for (Drive& drive : drives_) {
      changed = std::max(changed, std::abs(drive_once(drive)));
      largest = std::max(largest, std::abs(drive.impulse));
    }
    if (changed <= kSettled * largest) break;
  }
}

void Mechanism::solve_before(double h) {
  solve_held();
  if (!aimed_)
    for (Drive& drive : drives_)
      if (drive.active) aim_before(drive, speed(*drive.link, drive.row), h);
  aimed_ = true;
  solve_drives();
}

// Tells the largest, m or rad.
double Mechanism::find_gaps() {
  gaps_.resize(static_cast<Eigen::Index>(rows_.size()));
  Eigen::Index at = 0;
  for (Link* link : links_) {
    refresh(*link);
    each_held(*link, [&](const JointRow& row) { gaps_[at++] = row.error; });
  }
  refreshed_ = true;
  const double largest = gaps_.lpNorm<Eigen::Infinity>();
  if (largest > kMostGap) gaps_ *= kMostGap / largest;
  return largest;
}

// Finds shifts along the rows that close the gaps, and tells their cost. Where the rows hardly differ, as in a taut rope
// between two walls, closing a gap of nothing takes pushes without bound. The more is added to the diagonal, the more of
// such a gap is left open (K. Levenberg, 1944): as much as the last time, to begin with, since factoring is what costs.
double Mechanism::repair(double most_cost) {
  for (;; ++regular_) {
    if (regular_ != factored_) factor_.factor(values_, kRegular[regular_]);
    factored_ = regular_;
    shifts_ = gaps_;
    factor_.solve_in_place(shifts_);
    const double cost = gaps_.dot(shifts_);
    if (cost <= most_cost || regular_ == kMostRegular || tree_) return cost;
  }
}

// A limit whose row turns as the bodies move along it, as a cone's does, is passed by that bend in a drift. It is taken back
// like a held row's gap, along the row of before and with the velocity that goes with it (SHAKE): so a bone that slides
// round in its cone neither leaves it nor loses speed.
void Mechanism::close_bends(double h) {
  for (int round = 0; round < kGapRounds; ++round)
    for (Drive& drive : drives_) {
      const bool bent = drive.free_row >= 0 && drive.link->rows.free[static_cast<std::size_t>(drive.free_row)].bent;
      if (!bent || !drive.active || drive.mobility <= kLeastMobility * drive.own_mobility) continue;
      refresh(*drive.link);
      const double beyond = std::min(passed(drive), kMostGap);
      if (beyond <= kClosed) continue;
      const double shift = (drive.kind == Drive::low ? beyond : -beyond) / drive.mobility;
      drift_along(drive_rows_[static_cast<std::size_t>(&drive - drives_.data())], shift, h);
      for (std::size_t i = 0; i < rows_.size() && drive.helpers.size() > 0; ++i)
        drift_along(rows_[i], shift * drive.helpers[static_cast<Eigen::Index>(i)], h);
      if (drive.helpers.size() > 0) held_ += drive.helpers * (shift / h);
      drive.impulse += shift / h;
    }
}

// Moves both bodies as an impulse of shift / h in the drift of h would have, and gives that impulse.
void Mechanism::drift_along(const Row& row, double shift, double h) {
  row.link->a->shift(row.shift_a * shift, row.turn_a * shift);
  row.link->b->shift(row.shift_b * shift, row.turn_b * shift);
  give(row, shift / h);
}

// Of the energy of the motion. In loops rows say nearly the same, and repairs feed what they should not; and where one body
// dwarfs the others, a small part of its energy is much to them.
double Mechanism::most_repair() const {
  if (!tree_) return kMostRepairOfLoops;
  double light = 0, heavy = INFINITY;
  for (const Mover* mover : bodies_) {
    const double ease = std::max({mover->inverse_mass.x, mover->inverse_mass.y, mover->inverse_mass.z});
    light = std::max(light, ease);
    heavy = std::min(heavy, ease);
  }
  return light > 0 ? kMostRepair * std::pow(heavy / light, 0.25) : 0;
}

// Newton's method with the matrix of before the drift: its error shrinks by about the turn in a substep each round.
void Mechanism::close_gaps(double h) {
  close_bends(h);
  if (rows_.empty()) return;
  if (regular_ > 0 && ++since_less_ % kTryLess == 0) --regular_;
  for (int round = 0; round < kGapRounds; ++round) {
    if (find_gaps() < kClosed) return;
    double motion = 0, fall = 0;
    for (const Mover* mover : bodies_) {
      motion += kinetic_energy(*mover);
      fall += energy_of_fall(*mover, h);
    }
    const double most = most_repair() * (motion + fall) * 2 * h * h, cost = repair(most);
    // What moves no faster than it would by falling through the substep does not whip, but trembles about its rest.
    if (round == 0 && motion > 0) whip_ = std::max(whip_, std::min(cost / (2 * h * h * (motion + fall)), kMostRemembered) / (h * h));
    move(cost <= most ? 1 / h : 0);
    conserves_ &= cost <= most;
  }
  if (tree_) close_rest();
}

// A blow that goes through a chain turns its links so far in a substep that the rows of before are no guide. What then is
// left is closed along those of now, and gives no velocity.
void Mechanism::close_rest() {
  for (int round = 0; round < kMostRounds && find_gaps() > kLeastRest; ++round) {
    gather();
    factor();
    shifts_ = gaps_;
    factor_.solve_in_place(shifts_);
    move(0);
    conserves_ = false;
  }
}

// Moves along the rows by -shifts, and gives them `rate` times as much velocity.
void Mechanism::move(double rate) {
  refreshed_ = false;
  for (Mover* mover : bodies_) mover->way = mover->turn = mover->impulse = mover->twist = {};
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Row& row = rows_[i];
    const double shift = -shifts_[static_cast<Eigen::Index>(i)];
    const auto add = [shift](Mover& mover, Vec3 way, Vec3 turn, Vec3 linear, Vec3 angular) {
      if (!mover.pushable) return;
      mover.way += way * shift;
      mover.turn += turn * shift;
      mover.impulse += linear * shift;
      mover.twist += angular * shift;
    };
    add(*row.link->a, row.shift_a, row.turn_a, row.row.linear_a, row.row.angular_a);
    add(*row.link->b, row.shift_b, row.turn_b, row.row.linear_b, row.row.angular_b);
    if (rate == 0) continue;
    row.link->impulse += row.row.linear_a * (shift * rate);
    row.link->twist += row.twist * (shift * rate);
  }
  for (Mover* mover : bodies_) {
    mover->shift(mover->way, mover->turn);
    if (rate > 0) mover->push(mover->impulse * rate, mover->twist * rate);
  }
  held_ -= shifts_ * rate;
}

void Mechanism::turn_to_now(double h) {
  if (!refreshed_)
    for (Link* link : links_) refresh(*link);
  refreshed_ = false;
  pull_ = 2 * held_;  // the other half of the substep is to come
  for (Mover* mover : bodies_) {
    if (mover->stiffness == 0) continue;
    mover->stiffness = 0;
    mover->refresh();
  }
  gather();
  stiffen(h);
  for (Drive& drive : drives_) {
    const bool before = drive.active;
    refresh(drive, h);
    drive.active |= before;
    couple(drive);
  }
}

void Mechanism::solve_after(double h) {
  for (Drive& drive : drives_)
    if (drive.active) aim_after(drive, h);
  solve_held();
  solve_drives();
}

}  // namespace tumble::dynamics
