#include "physics/bullet/contacts.h"

#include <algorithm>
#include <tuple>

namespace tumble {

namespace {

// Two bodies that touched go on touching up to this distance, m: a resting body's contacts breathe.
constexpr double kStillTouching = 0.005;
// Points of two substeps that are nearer than this are one point, m.
constexpr double kSamePoint = 0.02;

bool touches(const btPersistentManifold& manifold, bool trigger, bool already) {
  for (int i = 0; i < manifold.getNumContacts(); ++i) {
    const btManifoldPoint& point = manifold.getContactPoint(i);
    if (point.getDistance() <= 0) return true;
    if (trigger) continue;
    if (point.getAppliedImpulse() > 0 || (already && point.getDistance() <= kStillTouching)) return true;
  }
  return false;
}

void add_point(ContactEvent& event, Vec3 position, double impulse) {
  for (ContactPoint& known : event.points)
    if (distance(known.point, position) < kSamePoint) {
      known = {position, known.impulse + impulse};
      return;
    }
  event.points.push_back({position, impulse});
}

Vec3 start_velocity_at(const BodyState& body, Vec3 point) {
  return body.start_velocity + cross(body.start_turning, point - from_bullet(body.rigid->getWorldTransform().getOrigin()));
}

int collider(const BodyState& body, const btCollisionObject* object, int part, int index) {
  return (is_ghost(object) ? *body.triggers : *body.solids).collider_of(part, index);
}

// Bodies overlap by what a substep lets them sink in. The place told is on the surface of the one that does not move, so
// that a mark put there is seen; between two that move it is the middle.
Vec3 place_of(const btManifoldPoint& found, const btPersistentManifold& manifold) {
  const Vec3 on_a = from_bullet(found.getPositionWorldOnA()), on_b = from_bullet(found.getPositionWorldOnB());
  const bool moves_a = state_of(manifold.getBody0())->dynamic(), moves_b = state_of(manifold.getBody1())->dynamic();
  if (moves_a == moves_b) return (on_a + on_b) * 0.5;
  return moves_a ? on_b : on_a;
}

ContactEvent exit_of(const Pair& pair) {
  ContactEvent event = pair.event;
  event.kind = EventKind::exit;
  event.speed = event.impulse = 0;
  event.points.clear();
  return event;
}

struct Sorted {
  EventKind kind;
  std::uint32_t a, b;
  bool trigger;
  ContactEvent event;
  auto key() const { return std::tuple(kind, a, b, trigger); }
};

void append_sorted(std::vector<Sorted>& batch, Events& events) {
  std::sort(batch.begin(), batch.end(), [](const Sorted& x, const Sorted& y) { return x.key() < y.key(); });
  for (Sorted& entry : batch) events.contacts.push_back(std::move(entry.event));
}

template <class T>
void erase_value(std::vector<T*>& list, T* value) {
  const auto at = std::find(list.begin(), list.end(), value);
  if (at != list.end()) list.erase(at);
}

}  // namespace

Pair* ContactBook::find(const BodyState& a, const BodyState& b, bool trigger) {
  for (Pair* pair : (a.pairs.size() < b.pairs.size() ? a : b).pairs)
    if (pair->a == &a && pair->b == &b && pair->trigger == trigger) return pair;
  return nullptr;
}

Pair& ContactBook::make(BodyState& a, BodyState& b, bool trigger) {
  pairs_.push_back(std::make_unique<Pair>());
  Pair& pair = *pairs_.back();
  pair.a = &a;
  pair.b = &b;
  pair.trigger = trigger;
  pair.index = pairs_.size() - 1;
  a.pairs.push_back(&pair);
  b.pairs.push_back(&pair);
  return pair;
}

void ContactBook::drop(Pair& pair) {
  erase_value(pair.a->pairs, &pair);
  erase_value(pair.b->pairs, &pair);
  const std::size_t index = pair.index;
  std::swap(pairs_[index], pairs_.back());
  pairs_[index]->index = index;
  pairs_.pop_back();
}

void ContactBook::observe(btDispatcher& dispatcher) {
  for (int i = 0; i < dispatcher.getNumManifolds(); ++i) observe(*dispatcher.getManifoldByIndexInternal(i));
}

void ContactBook::observe(btPersistentManifold& manifold) {
  if (manifold.getNumContacts() == 0) return;
  const btCollisionObject *first = manifold.getBody0(), *second = manifold.getBody1();
  if (!first->isActive() && !second->isActive()) return;
  BodyState *a = state_of(first), *b = state_of(second);
  const bool trigger = is_ghost(first) || is_ghost(second);
  const bool swapped = a->serial > b->serial;
  if (swapped) std::swap(a, b);
  Pair* pair = find(*a, *b, trigger);
  if (!touches(manifold, trigger, pair != nullptr)) return;
  note(pair ? *pair : make(*a, *b, trigger), manifold, swapped);
}

void ContactBook::note(Pair& pair, btPersistentManifold& manifold, bool swapped) {
  ContactEvent& event = pair.event;
  const bool first_in_step = pair.seen != step_;
  if (first_in_step) {
    event = {};
    event.trigger = pair.trigger;
    event.a = pair.a->id;
    event.user_a = pair.a->user;
    event.user_b = pair.b->user;
    event.b = pair.b->id;
    pair.depth = 1e18;
    pair.seen = step_;
  }

  for (int i = 0; i < manifold.getNumContacts(); ++i) {
    const btManifoldPoint& found = manifold.getContactPoint(i);
    if (pair.trigger && found.getDistance() > 0) continue;
    const Vec3 point = place_of(found, manifold);
    const Vec3 normal = from_bullet(found.m_normalWorldOnB) * (swapped ? 1.0 : -1.0);
    const Vec3 relative = start_velocity_at(*pair.b, point) - start_velocity_at(*pair.a, point);
    if (!pair.trigger) {
      event.impulse += found.getAppliedImpulse();
      add_point(event, point, found.getAppliedImpulse());
      event.speed = std::max(event.speed, -dot(relative, normal));
    }
    if (found.getDistance() >= pair.depth) continue;
    pair.depth = found.getDistance();
    event.point = point;
    event.normal = normal;
    event.velocity = relative;
    const int c0 = collider(*state_of(manifold.getBody0()), manifold.getBody0(), found.m_partId0, found.m_index0);
    const int c1 = collider(*state_of(manifold.getBody1()), manifold.getBody1(), found.m_partId1, found.m_index1);
    event.collider_a = swapped ? c1 : c0;
    event.collider_b = swapped ? c0 : c1;
  }
}

void ContactBook::end_step(Events& events) {
  std::vector<Sorted> batch;
  for (std::size_t i = 0; i < pairs_.size();) {
    Pair& pair = *pairs_[i];
    const auto add = [&](ContactEvent event) {
      batch.push_back({event.kind, pair.a->serial, pair.b->serial, pair.trigger, std::move(event)});
    };
    if (pair.seen == step_) {
      pair.event.kind = pair.told ? EventKind::stay : EventKind::enter;
      if (!pair.told || pair.a->want_stay || pair.b->want_stay) add(pair.event);
      pair.told = true;
    } else if (pair.a->rigid->isActive() || pair.b->rigid->isActive()) {
      add(exit_of(pair));
      drop(pair);
      continue;  // another pair is in its place now
    }
    ++i;
  }
  append_sorted(batch, events);
}

void ContactBook::end_pairs(BodyState& body, Events& events) {
  std::vector<Sorted> batch;
  while (!body.pairs.empty()) {
    Pair& pair = *body.pairs.back();
    if (pair.told) batch.push_back({EventKind::exit, pair.a->serial, pair.b->serial, pair.trigger, exit_of(pair)});
    drop(pair);
  }
  append_sorted(batch, events);
}

int ContactBook::touching() const {
  return static_cast<int>(std::count_if(pairs_.begin(), pairs_.end(), [](const auto& pair) { return !pair->trigger; }));
}

ContactEvent seen_from(const Pair& pair, const BodyState& body) {
  ContactEvent event = pair.event;
  if (pair.a == &body) return event;
  std::swap(event.a, event.b);
  std::swap(event.user_a, event.user_b);
  std::swap(event.collider_a, event.collider_b);
  event.normal = -event.normal;
  event.velocity = -event.velocity;
  return event;
}

}  // namespace tumble
