#include "physics/dynamics/island.h"

#include <algorithm>
#include <map>

#include "physics/dynamics/impact.h"

namespace tumble::dynamics {

namespace {

// At most so far, in radians, may a jointed gyroscope swing in a substep; and at most so many times the substeps.
constexpr double kMostSwing = 0.6;
constexpr int kWhipTimes = 8;
constexpr double kMostWhip = 3e-4;  // of its energy of motion, what closing gaps costs a mechanism in a substep
// Rounds go on while they change a speed by more than this, m/s, up to so many times what was asked for.
constexpr double kLoose = 0.02;
constexpr int kMostRounds = 40;
constexpr int kMostTimes = 32;
// A contact that bears so many times the weight of the lighter body takes twice the substeps, four times as much again
// twice that (its softness goes with the square of a substep). And so many substeps times bodies an island may cost for it.
constexpr double kLoad = 6, kGrain = 1.4e-3;  // of the weight; m, see thinness()
constexpr int kMostWork = 3000;
constexpr double kHardlyTurns = 0.02;  // radians; the error goes with the third power

// ---- which islands there are

// Sets of movers by number; the root of a set is its smallest.
class Sets {
 public:
  explicit Sets(int count) {
    for (int i = 0; i < count; ++i) parent_.push_back(i);
  }
  int root(int i) {
    while (at(i) != i) i = at(i) = at(at(i));
    return i;
  }
  void unite(const Mover& a, const Mover& b) {
    if (!a.pushable || !b.pushable) return;
    const int x = root(a.island), y = root(b.island);
    at(std::max(x, y)) = std::min(x, y);
  }

 private:
  int& at(int i) { return parent_[static_cast<std::size_t>(i)]; }
  std::vector<int> parent_;
};

const Mover& pushable_of(const Link& link) { return link.a->pushable ? *link.a : *link.b; }

// What moves and cannot be pushed goes its way in each island anew.
void separate_carriers(std::deque<Mover>& movers, std::vector<Island>& islands) {
  for (Island& island : islands) {
    std::map<const Mover*, Mover*> own;
    const auto take = [&](Mover*& mover) {
      if (mover->pushable || (mover->velocity == Vec3{} && mover->spin == Vec3{} && mover->acceleration == Vec3{})) return;
      Mover*& copy = own[mover];
      if (!copy) {
        movers.push_back(*mover);
        copy = &movers.back();
        island.movers.push_back(copy);
      }
      mover = copy;
    };
    for (Contact* contact : island.contacts) {
      take(contact->a);
      take(contact->b);
    }
    for (Mechanism* mechanism : island.mechanisms)
      for (Link* link : mechanism->links()) {
        take(link->a);
        take(link->b);
      }
    bool joined = false;
    for (const Contact* contact : island.contacts) joined |= contact->a->bound || contact->b->bound;
    for (Mechanism* mechanism : island.mechanisms) mechanism->touched = joined;
  }
}

// ---- how many substeps

// How fast a spinning body wavers about its principal axes, rad/s: for a spin w about axis 1 and moments I,
// w sqrt((I1 - I2) (I1 - I3) / (I2 I3)).
double nutation(const Mover& mover) {
  const Vec3 spin = conjugate(mover.rotation) * mover.spin, i = mover.inertia;
  if (!(i.x > 0 && i.y > 0 && i.z > 0)) return 0;
  const auto about = [](double w, double own, double one, double other) {
    return std::abs(w) * std::sqrt(std::abs((own - one) * (own - other)) / (one * other));
  };
  return about(spin.x, i.x, i.y, i.z) + about(spin.y, i.y, i.x, i.z) + about(spin.z, i.z, i.x, i.y);
}

// Where something heavy comes to lie on something light nothing presses yet: their masses tell what will.
double first_load(const Contact& contact, double seconds) {
  if (!contact.a->pushable || !contact.b->pushable || contact.pressing() > 0) return 0;
  const Vec3 coming = contact.b->velocity - contact.a->velocity;
  if (contact.nearest() > std::max(1e-3, dot(coming, contact.normal) * seconds)) return 0;
  const double a = mass_of(*contact.a), b = mass_of(*contact.b);
  const bool a_above = dot(contact.normal, contact.a->acceleration) < 0;
  const double above = a_above ? a : b, below = a_above ? b : a;
  return below > 0 ? above / below / kLoad : 0;
}

// The radius of gyration of a cube as thin as the body is where it is thinnest, m.
double thinness(const Mover& mover, double lightness) {
  const Vec3 i = mover.inertia;
  return std::sqrt(std::max(0.0, i.x + i.y + i.z - 2 * std::max({i.x, i.y, i.z})) * lightness);
}

// What presses there, over the weight of the lighter of the bodies and over what may be: the contact gives way by 0.07 mm
// times this at 4 substeps of 1/60 s, which is nothing to a brick and much to a grain. Impulses still are forces here.
double load_on(const Contact& contact, double seconds) {
  double load = first_load(contact, seconds);
  for (const Mover* mover : {contact.a, contact.b}) {
    const double pull = length(mover->acceleration), lightness = std::max({mover->inverse_mass.x, mover->inverse_mass.y, mover->inverse_mass.z});
    if (!mover->pushable || !(pull > 0)) continue;
    const double most = std::min(kLoad, thinness(*mover, lightness) / kGrain);
    if (most > 0) load = std::max(load, contact.pressing() * lightness / pull / most);
  }
  return load;
}

// Nothing touches or holds it, and it hardly turns in the step: then a substep of any length is exact.
bool flies_alone(const Island& island, double seconds) {
  if (!island.contacts.empty() || !island.mechanisms.empty() || !island.looks.empty()) return false;
  return std::all_of(island.movers.begin(), island.movers.end(), [&](const Mover* mover) {
    return mover->torque == Vec3{} && length(mover->spin) * seconds < kHardlyTurns;
  });
}

// ---- a substep

// As often as asked, and on, where it still runs, while a blow goes through a stack.
void solve_in_rounds(Island& island, int least, double h, const Softness* soft) {
  for (Mover* mover : island.movers) mover->stirred = -1;
  for (int round = 0; round < kMostRounds * least; ++round) {
    for (Mechanism* mechanism : island.mechanisms) {
      if (soft) mechanism->solve_before(h);
      else mechanism->solve_after(h);
    }
    bool any = false;
    for (Contact* contact : island.contacts) {
      const int last = std::max(contact->a->pushable ? contact->a->stirred : -1, contact->b->pushable ? contact->b->stirred : -1);
      if (round >= least && last < round - 1 && !contact->a->bound && !contact->b->bound) continue;
      if (contact->solve(h, soft) < kLoose) continue;
      for (Mover* mover : {contact->a, contact->b})
        if (mover->pushable) mover->stirred = round;
      any = true;
    }
    if (round + 1 >= least && !any) break;
  }
}

// What is moved by somebody speeds up about its mean velocity, whatever pushes it.
void kick(Mover& mover, double h, void (*pushed)(Mover&, double)) {
  if (mover.pushable) pushed(mover, h);
  else mover.velocity += mover.acceleration * (h / 2);
}

void move(Island& island, double h) {
  for (Mover* mover : island.movers) drift(*mover, h);
  for (Mechanism* mechanism : island.mechanisms) mechanism->close_gaps(h);
  for (Mechanism* mechanism : island.mechanisms) mechanism->turn_to_now(h);
  for (Contact* contact : island.contacts) contact->drifted(h);
  for (Mover* mover : island.movers) kick(*mover, h, kick_after);
}

void substep(Island& island, double h, int rounds) {
  const Softness soft = contact_softness(h);
  for (Mechanism* mechanism : island.mechanisms) mechanism->begin();
  for (const auto& look : island.looks) look(h);
  for (Contact* contact : island.contacts) contact->begin(h);
  for (Mover* mover : island.movers) kick(*mover, h, kick_before);
  for (Contact* contact : island.contacts) contact->foresee(h);
  if (island.bouncy) bounce(island.contacts, island.mechanisms, h);
  for (Contact* contact : island.contacts) contact->warm_start();
  solve_in_rounds(island, rounds, h, &soft);
  for (Mechanism* mechanism : island.mechanisms)
    if (mechanism->touched) mechanism->solve_before(h);

  move(island, h);

  for (Contact* contact : island.contacts) contact->warm_start();
  solve_in_rounds(island, rounds, h, nullptr);
  for (Mechanism* mechanism : island.mechanisms)
    if (mechanism->touched) mechanism->solve_after(h);
  for (Contact* contact : island.contacts) contact->end();
}

}  // namespace

std::vector<Island> find_islands(std::deque<Mover>& movers, const std::vector<Contact*>& contacts, const std::vector<Mechanism*>& mechanisms) {
  int count = 0;
  for (Mover& mover : movers)
    if (mover.pushable) mover.island = count++;
  Sets sets(count);
  for (const Contact* contact : contacts) sets.unite(*contact->a, *contact->b);
  for (const Mechanism* mechanism : mechanisms)
    for (const Link* link : mechanism->links()) {
      sets.unite(*link->a, *link->b);
      sets.unite(pushable_of(*link), pushable_of(*mechanism->links().front()));
    }

  std::vector<Island> islands;
  std::vector<int> island_of(static_cast<std::size_t>(count));
  for (Mover& mover : movers) {
    if (!mover.pushable) continue;
    const auto own = static_cast<std::size_t>(mover.island), root = static_cast<std::size_t>(sets.root(mover.island));
    if (own == root) {
      island_of[own] = static_cast<int>(islands.size());
      islands.emplace_back();
    }
    mover.island = island_of[root];  // roots come first: later ones only look at their places
    island_of[own] = mover.island;
    islands[static_cast<std::size_t>(mover.island)].movers.push_back(&mover);
  }
  for (Contact* contact : contacts) {
    Island& here = islands[static_cast<std::size_t>(contact->island())];
    here.contacts.push_back(contact);
    here.bouncy |= contact->bounces();
  }
  for (Mechanism* mechanism : mechanisms)
    islands[static_cast<std::size_t>(pushable_of(*mechanism->links().front()).island)].mechanisms.push_back(mechanism);
  separate_carriers(movers, islands);
  return islands;
}

// A gyroscope must not swing far in a substep, and what bears many times its own weight needs smaller ones; but a large
// heap is not to cost many times as much for a few of its bodies.
int substeps_of(const Island& island, double seconds, int least) {
  double fastest = 0, load = 0;
  for (const Mover* mover : island.movers)
    if (mover->bound && mover->pushable) fastest = std::max(fastest, nutation(*mover));
  for (const Contact* contact : island.contacts) load = std::max(load, load_on(*contact, seconds));
  double whip = 0;
  for (const Mechanism* mechanism : island.mechanisms) whip = std::max(whip, mechanism->whip());
  int times = 1;
  const auto too_few = [&] {
    const double h = seconds / (times * least);
    return fastest * h > kMostSwing || load > times * times || (times < kWhipTimes && whip * h * h > kMostWhip);
  };
  while (times < kMostTimes && too_few()) times *= 2;
  const auto bodies = static_cast<int>(island.movers.size());
  while (times > 1 && times * least * bodies > kMostWork) times /= 2;
  return times * least;
}

int run(Island& island, double seconds, int least, int rounds) {
  for (Mover* mover : island.movers) {
    mover->refresh();
    if (!mover->pushable) mover->velocity -= mover->acceleration * (seconds / 2);
  }
  const int count = flies_alone(island, seconds) ? 1 : substeps_of(island, seconds, least);
  const double h = seconds / count;
  for (Mechanism* mechanism : island.mechanisms) mechanism->begin_step(h);
  for (Contact* contact : island.contacts) contact->scale(h);
  for (int i = 0; i < count; ++i) substep(island, h, rounds);
  for (Mechanism* mechanism : island.mechanisms) mechanism->end_step();
  for (Contact* contact : island.contacts) {
    contact->scale(1 / h);
    contact->raise(seconds);
  }
  return count;
}

}  // namespace tumble::dynamics
