#include "physics/dynamics/impact.h"

#include <algorithm>
#include <optional>
#include <set>
#include <unordered_map>

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

// All contacts of an island, the times at which they are next hit, and who else is at a body: a hit changes only what is
// known of its neighbours.
class Hits {
 public:
  Hits(const std::vector<Contact*>& contacts, double h) : contacts_(contacts), h_(h), times_(contacts.size(), INFINITY), seen_(contacts.size(), 0) {
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      for (const Mover* mover : {contacts[i]->a, contacts[i]->b})
        if (mover->pushable) at_[mover].push_back(i);
      if (is_bound(*contacts[i])) bound_.push_back(i);
      lively_ += contacts[i]->bounces();
      look(i, 0);
    }
  }
  std::size_t lively() const { return lively_; }
  // The earliest, of several the first of the list; empty where there is none.
  std::optional<std::size_t> next() const { return order_.empty() ? std::nullopt : std::optional(order_.begin()->second); }
  double time(std::size_t i) const { return times_[i]; }

  // Where a body, or what is joined, meets others in several places at one time, these are one hit: a table lands on its
  // four legs. In a row of balls only the first comes nearer to the next.
  std::vector<Contact*> together(std::size_t first, double time) {
    std::vector<std::size_t> group = {first};
    ++stamp_;
    seen_[first] = stamp_;
    for (std::size_t i = 0; i < group.size(); ++i)
      for (const std::size_t k : neighbours(group[i])) {
        Contact& other = *contacts_[k];
        if (seen_[k] == stamp_ || !other.bounces() || !other.meets(time, h_)) continue;
        seen_[k] = stamp_;
        group.push_back(k);
      }
    std::vector<Contact*> hit;
    for (const std::size_t i : group) hit.push_back(contacts_[i]);
    return hit;
  }

  // Those at any of the bodies.
  std::vector<std::size_t> of(const std::vector<Motion>& bodies) const {
    std::vector<std::size_t> all;
    for (const Motion& body : bodies)
      if (const auto at = at_.find(body.mover); at != at_.end()) all.insert(all.end(), at->second.begin(), at->second.end());
    return in_order(std::move(all));
  }
  void look(std::size_t i, double from) {
    order_.erase({times_[i], i});
    times_[i] = contacts_[i]->next_hit(from, h_);
    if (times_[i] <= h_) order_.insert({times_[i], i});
  }

 private:
  static std::vector<std::size_t> in_order(std::vector<std::size_t> all) {
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }
  std::vector<std::size_t> neighbours(std::size_t i) const {
    std::vector<std::size_t> all = is_bound(*contacts_[i]) ? bound_ : std::vector<std::size_t>{};
    for (const Mover* mover : {contacts_[i]->a, contacts_[i]->b})
      if (const auto at = at_.find(mover); at != at_.end()) all.insert(all.end(), at->second.begin(), at->second.end());
    return in_order(std::move(all));
  }

  const std::vector<Contact*>& contacts_;
  double h_;
  std::size_t lively_ = 0;
  std::vector<double> times_;
  std::set<std::pair<double, std::size_t>> order_;
  std::unordered_map<const Mover*, std::vector<std::size_t>> at_;  // looked up, never walked through
  std::vector<std::size_t> bound_;                                 // at a body that joints hold
  std::vector<int> seen_;                                          // the last group that looked at it
  int stamp_ = 0;
};

}  // namespace

void bounce(const std::vector<Contact*>& contacts, const std::vector<Mechanism*>& mechanisms, double h) {
  if (std::none_of(contacts.begin(), contacts.end(), [h](Contact* contact) { return contact->next_hit(0, h) <= h; })) return;
  Hits all(contacts, h);
  for (std::size_t hits = 0; hits < all.lively() * kMostHits; ++hits) {
    const auto next = all.next();
    if (!next) break;
    const double now = all.time(*next);
    const std::vector<Contact*> group = all.together(*next, now);
    const std::vector<Motion> before = motions(group, mechanisms);
    const std::vector<std::size_t> near = all.of(before);
    for (const std::size_t i : near) contacts[i]->note_closing();
    blow(group, mechanisms, now, h);
    for (const Motion& then : before) then.mover->shift((then.velocity - then.mover->velocity) * now, (then.spin - then.mover->spin) * now);
    for (const std::size_t i : near) {
      contacts[i]->hit_elsewhere(now, h);
      all.look(i, now);
    }
  }
}

}  // namespace tumble::dynamics
