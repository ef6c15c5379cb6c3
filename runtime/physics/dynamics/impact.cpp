#include "physics/dynamics/impact.h"

#include <algorithm>

namespace tumble::dynamics {

namespace {

// Balls in a heap may hand on a blow for ever; so many hits a contact are enough in a substep.
constexpr int kMostHits = 8;
// A body that is held by joints takes the blow with all of them: contact and joints in turns.
constexpr int kHeldRounds = 60, kGroupRounds = 30;
constexpr double kSettled = 1e-7;  // m/s, of the last correction

struct Motion {
  Mover* mover;
  Vec3 velocity, spin;
};

bool is_bound(const Contact& contact) { return contact.a->bound || contact.b->bound; }

// Where a body, or what is joined, meets others in several places at one time, these are one hit: a table lands on its
// four legs. In a row of balls only the first comes nearer to the next.
std::vector<Contact*> together(Contact& first, const std::vector<Contact*>& lively, double time, double h) {
  std::vector<Contact*> group = {&first};
  const auto shares = [](const Contact& x, const Contact& y) {
    const auto among = [&y](const Mover* mover) { return mover->pushable && (mover == y.a || mover == y.b); };
    return among(x.a) || among(x.b) || (is_bound(x) && is_bound(y));
  };
  for (std::size_t i = 0; i < group.size(); ++i)
    for (Contact* other : lively) {
      if (std::find(group.begin(), group.end(), other) != group.end()) continue;
      if (shares(*group[i], *other) && other->meets(time, h)) group.push_back(other);
    }
  return group;
}

std::vector<Motion> motions(const std::vector<Contact*>& group, const std::vector<Mechanism*>& mechanisms) {
  std::vector<Motion> list;
  const auto add = [&list](Mover* mover) {
    const bool known = std::any_of(list.begin(), list.end(), [mover](const Motion& motion) { return motion.mover == mover; });
    if (mover->pushable && !known) list.push_back({mover, mover->velocity, mover->spin});
  };
  bool bound = false;
  for (const Contact* contact : group) {
    add(contact->a);
    add(contact->b);
    bound |= is_bound(*contact);
  }
  if (bound)
    for (const Mechanism* mechanism : mechanisms)
      for (Mover* mover : mechanism->bodies()) add(mover);
  return list;
}

void blow(const std::vector<Contact*>& group, const std::vector<Mechanism*>& mechanisms, double time, double h) {
  const bool bound = std::any_of(group.begin(), group.end(), [](const Contact* contact) { return is_bound(*contact); });
  for (Contact* contact : group) contact->aim_hit(time, h);
  const int rounds = bound ? kHeldRounds : group.size() > 1 ? kGroupRounds : 1;
  for (int round = 0; round < rounds; ++round) {
    if (bound && round > 0)
      for (Mechanism* mechanism : mechanisms) mechanism->solve_held();
    double changed = 0;
    for (Contact* contact : group) changed = std::max(changed, contact->hit(time, h));
    if (changed <= kSettled) break;
  }
  if (bound)
    for (Mechanism* mechanism : mechanisms) mechanism->solve_held();
  for (Contact* contact : group) contact->end_hit();
}

}  // namespace

void bounce(const std::vector<Contact*>& contacts, const std::vector<Mechanism*>& mechanisms, double h) {
  if (std::none_of(contacts.begin(), contacts.end(), [h](Contact* contact) { return contact->next_hit(0, h) <= h; })) return;
  std::vector<Contact*> lively;
  for (Contact* contact : contacts)
    if (contact->bounces()) lively.push_back(contact);

  double now = 0;
  for (std::size_t hits = 0; hits < lively.size() * kMostHits; ++hits) {
    Contact* next = nullptr;
    double first = INFINITY;
    for (Contact* contact : lively) {
      const double time = contact->next_hit(now, h);
      if (time < first) {
        first = time;
        next = contact;
      }
    }
    if (!next) break;
    now = first;
    const std::vector<Contact*> group = together(*next, lively, now, h);
    const std::vector<Motion> before = motions(group, mechanisms);
    for (Contact* contact : contacts) contact->note_closing();
    blow(group, mechanisms, now, h);
    for (const Motion& then : before) then.mover->shift((then.velocity - then.mover->velocity) * now, (then.spin - then.mover->spin) * now);
    for (Contact* contact : contacts) contact->hit_elsewhere(now, h);
  }
}

}  // namespace tumble::dynamics
