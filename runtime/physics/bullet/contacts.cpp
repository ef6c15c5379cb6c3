#include "physics/bullet/contacts.h"

#include <algorithm>
#include <tuple>

#include "physics/bullet/crossing.h"

namespace tumble {

namespace {

// Points of two substeps that are nearer than this are one point, m.
constexpr double kSamePoint = 0.02;

void add_point(ContactEvent& event, Vec3 position, double impulse) {
  for (ContactPoint& known : event.points)
    if (distance(known.point, position) < kSamePoint) {
      known = {position, known.impulse + impulse};
      return;
    }
  event.points.push_back({position, impulse});
}

Vec3 start_velocity_at(const BodyState& body, Vec3 point) {
  return body.start_velocity + cross(body.start_turning, point - body.center.position);
}

int collider(const BodyState& body, const btCollisionObject* object, int part, int index) {
  return (is_ghost(object) ? *body.triggers : *body.solids).collider_of(part, index);
}

// Bodies overlap by what a substep lets them sink in. The place told is on the surface of the one that does not move, so
// that a mark put there is seen; between two that move it is the middle.
Vec3 place_of(const BodyState& a, const BodyState& b, Vec3 on_a, Vec3 on_b) {
  if (a.dynamic() == b.dynamic()) return (on_a + on_b) * 0.5;
  return a.dynamic() ? on_b : on_a;
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

// Two bodies and their contact, from wherever it is kept.
struct Found {
  struct Point {
    double distance, impulse;
    Vec3 on_a, on_b, normal;   // from b to a
    int collider_a, collider_b;
  };
  BodyState *a, *b;
  bool trigger = false;
  int count = 0;
  Point points[dynamics::Contact::kMostPoints + 1];
  bool touches(bool already) const {
    return std::any_of(points, points + count, [&](const Point& point) {
      if (point.distance <= 0) return true;
      return !trigger && (point.impulse > 0 || (already && point.distance <= kStillTouching));
    });
  }
};

void read(const KeptContact& kept, Found& found) {
  found.a = kept.a;
  found.b = kept.b;
  const int collider_a = kept.a->solids->pieces()[0].collider, collider_b = kept.b->solids->pieces()[0].collider;
  for (int i = 0; i < kept.contact.count; ++i) {
    const dynamics::TouchPoint& point = kept.contact.points[i];
    found.points[found.count++] = {point.separation, point.sum, kept.a->center.position + point.arm_a, kept.b->center.position + point.arm_b,
                                   kept.contact.normal, collider_a, collider_b};
  }
  const dynamics::Contact::Lost& lost = kept.contact.lost;
  if (lost.sum > 0) found.points[found.count++] = {0, lost.sum, lost.on_a, lost.on_b, lost.normal, collider_a, collider_b};
}

void read(const btPersistentManifold& manifold, Found& found) {
  const btCollisionObject *a = manifold.getBody0(), *b = manifold.getBody1();
  found.a = state_of(a);
  found.b = state_of(b);
  found.trigger = is_ghost(a) || is_ghost(b);
  for (int i = 0; i < manifold.getNumContacts(); ++i) {
    const btManifoldPoint& point = manifold.getContactPoint(i);
    found.points[found.count++] = {point.getDistance(), point.getAppliedImpulse(), from_bullet(point.getPositionWorldOnA()),
                                   from_bullet(point.getPositionWorldOnB()), from_bullet(point.m_normalWorldOnB),
                                   collider(*found.a, a, point.m_partId0, point.m_index0), collider(*found.b, b, point.m_partId1, point.m_index1)};
  }
}

void forget(Pair& pair) {
  ContactEvent& event = pair.event;
  std::vector<ContactPoint> points = std::move(event.points);  // its memory
  points.clear();
  event = {};
  event.points = std::move(points);
  event.trigger = pair.trigger;
  event.a = pair.a->id;
  event.user_a = pair.a->user;
  event.user_b = pair.b->user;
  event.b = pair.b->id;
  pair.depth = 1e18;
}

void note(Pair& pair, const Found& found) {
  ContactEvent& event = pair.event;
  const bool swapped = found.a != pair.a;

  for (int i = 0; i < found.count; ++i) {
    const Found::Point& at = found.points[i];
    if (pair.trigger && at.distance > 0) continue;
    const Vec3 point = place_of(*found.a, *found.b, at.on_a, at.on_b);
    const Vec3 normal = swapped ? at.normal : -at.normal;
    const Vec3 relative = start_velocity_at(*pair.b, point) - start_velocity_at(*pair.a, point);
    if (!pair.trigger) {
      event.impulse += at.impulse;
      add_point(event, point, at.impulse);
      event.speed = std::max(event.speed, -dot(relative, normal));
    }
    if (at.distance >= pair.depth) continue;
    pair.depth = at.distance;
    event.point = point;
    event.normal = normal;
    event.velocity = relative;
    event.collider_a = swapped ? at.collider_b : at.collider_a;
    event.collider_b = swapped ? at.collider_a : at.collider_b;
  }
}

ContactEvent exit_of(Pair& pair) {
  ContactEvent event = told(pair);
  event.kind = EventKind::exit;
  event.time = pair.left;
  event.speed = event.impulse = 0;
  event.points.clear();
  return event;
}

// It came into the trigger in this step, and may have left it too.
double came(Pair& pair, double seconds) {
  if (pair.inside < 1) pair.left = last_touch(*pair.a, *pair.b, seconds, pair.inside) - seconds;
  return first_touch(*pair.a, *pair.b, seconds, pair.inside);
}

double went(const Pair& pair, double seconds) { return pair.left < 0 ? pair.left : last_touch(*pair.a, *pair.b, seconds, 0); }

}  // namespace

const ContactEvent& told(Pair& pair) {
  if (pair.unread && pair.kept) {
    Found found;
    read(*pair.kept, found);
    forget(pair);
    note(pair, found);
  }
  pair.unread = false;
  pair.event.kind = pair.kind;
  return pair.event;
}

Pair* ContactBook::find(const BodyState& older, const BodyState& younger, bool trigger) {
  for (Pair* pair : (older.pairs.size() < younger.pairs.size() ? older : younger).pairs)
    if (pair->a == &older && pair->b == &younger && pair->trigger == trigger) return pair;
  return nullptr;
}

Pair* ContactBook::find_any(const BodyState& a, const BodyState& b, bool trigger) {
  return a.serial > b.serial ? find(b, a, trigger) : find(a, b, trigger);
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
  if (pair.kept) pair.kept->pair = nullptr;
  erase_value(pair.a->pairs, &pair);
  erase_value(pair.b->pairs, &pair);
  const std::size_t index = pair.index;
  std::swap(pairs_[index], pairs_.back());
  pairs_[index]->index = index;
  pairs_.pop_back();
}

Pair& ContactBook::pair_of(BodyState& a, BodyState& b, bool trigger) {
  const bool swapped = a.serial > b.serial;
  BodyState &older = swapped ? b : a, &younger = swapped ? a : b;
  Pair* known = find(older, younger, trigger);
  return known ? *known : make(older, younger, trigger);
}

void ContactBook::observe(Collision& collision) {
  for (KeptContact* kept : collision.found()) {
    if (!kept->touching) continue;
    if (!kept->pair) {
      kept->pair = &pair_of(*kept->a, *kept->b, false);
      kept->pair->kept = kept;
    }
    kept->pair->seen = step_;
    kept->pair->unread = true;
  }
  for (const Overlap::Kind kind : {Overlap::solids, Overlap::triggers})
    collision.each_manifold(kind, [this](const btPersistentManifold& manifold) { observe(manifold); });
  for (const Collision::Passage& passage : collision.passages())
    if (Pair* pair = find_any(*passage.a, *passage.b, true)) pair->inside = passage.part;
}

void ContactBook::observe(const btPersistentManifold& manifold) {
  Found found;
  read(manifold, found);
  Pair* pair = find_any(*found.a, *found.b, found.trigger);
  if (!found.touches(pair != nullptr)) return;
  if (!pair) pair = &pair_of(*found.a, *found.b, found.trigger);
  if (pair->seen != step_) forget(*pair);
  pair->seen = step_;
  note(*pair, found);
}

void ContactBook::end_step(double seconds, const std::vector<BodyState*>& awake, const std::vector<BodyState*>& carriers, Events& events) {
  std::vector<Sorted> batch;
  const auto add = [&batch](const Pair& pair, ContactEvent event, EventKind kind, double time) {
    event.kind = kind;
    event.time = time;
    batch.push_back({kind, pair.a->serial, pair.b->serial, pair.trigger, std::move(event)});
  };
  const auto look_at = [&](Pair& pair) {
    if (pair.seen == step_) {
      const EventKind kind = pair.kind = pair.told ? EventKind::stay : EventKind::enter;
      if (pair.told) pair.left = 0;
      const double time = pair.trigger && !pair.told ? came(pair, seconds) : seconds;
      if (!pair.told || pair.a->want_stay || pair.b->want_stay) add(pair, told(pair), kind, time);
      pair.told = true;
    } else if (pair.a->active || pair.b->active) {
      add(pair, exit_of(pair), EventKind::exit, pair.trigger ? went(pair, seconds) : seconds);
      drop(pair);
    }
  };
  const auto looks = [](const BodyState& body) { return body.active || body.stirred; };
  for (const auto* bodies : {&awake, &carriers})
    for (BodyState* body : *bodies)
      for (std::size_t i = body->pairs.size(); i-- > 0;) {
        Pair& pair = *body->pairs[i];
        if (body == pair.a || !looks(*pair.a)) look_at(pair);  // once, where both do
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

void lose_contact(Pair& pair) {
  told(pair);
  pair.kept->pair = nullptr;
  pair.kept = nullptr;
}

ContactEvent seen_from(Pair& pair, const BodyState& body) {
  ContactEvent event = told(pair);
  if (pair.a == &body) return event;
  std::swap(event.a, event.b);
  std::swap(event.user_a, event.user_b);
  std::swap(event.collider_a, event.collider_b);
  event.normal = -event.normal;
  event.velocity = -event.velocity;
  return event;
}

}  // namespace tumble
