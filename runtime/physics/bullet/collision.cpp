#include "physics/bullet/collision.h"

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>

#include <algorithm>

#include "physics/bullet/contacts.h"
#include "physics/bullet/way.h"

namespace tumble {

namespace {

// Contacts are looked for this far ahead beside what the bodies' speeds ask for, m, but no farther than this part of the
// smaller body.
constexpr double kMargin = 0.01, kMarginPart = 0.2, kTriggerMargin = 1e-9;
constexpr double kFastestPull = 1e6;  // m/s^2: what is pulled harder is not looked after
constexpr int kMostLooks = 200;  // into a trigger, of a fast body
// Boxes are larger than need be by this, m, or this part of the body; and made anew where they are by so many times that.
constexpr double kSpare = 0.02, kSparePart = 0.2, kMostSpare = 4;

double reach_of(const BodyState& body) {
  return body.dynamic() ? body.extent : std::numeric_limits<double>::infinity();
}

// How fast a body's surface may come nearer, beside the motion of its centre.
double whirl(const BodyState& body) { return body.rigid->getAngularVelocity().length() * body.extent; }

struct Placed {
  btCollisionObject& object;
  btTransform at;
};

void process(Overlap& overlap, PairDispatcher& dispatcher, const btDispatcherInfo& info, const Placed& a, const Placed& b) {
  const btCollisionObjectWrapper wrap_a(nullptr, a.object.getCollisionShape(), &a.object, a.at, -1, -1);
  const btCollisionObjectWrapper wrap_b(nullptr, b.object.getCollisionShape(), &b.object, b.at, -1, -1);
  if (!overlap.algorithm) overlap.algorithm = dispatcher.findAlgorithm(&wrap_a, &wrap_b, nullptr, BT_CONTACT_POINT_ALGORITHMS);
  if (!overlap.algorithm) return;
  btManifoldResult result(&wrap_a, &wrap_b);
  result.m_closestPointDistanceThreshold = dispatcher.margin;
  overlap.algorithm->processCollision(&wrap_a, &wrap_b, info, &result);
}

Placed now(const Occupant& occupant) { return {*occupant.object, occupant.object->getWorldTransform()}; }

btDbvtVolume box_of(const Occupant& occupant) {
  btVector3 low, high;
  occupant.object->getCollisionShape()->getAabb(occupant.object->getWorldTransform(), low, high);
  return btDbvtVolume::FromMM(low, high);
}

double sum(const btVector3& v) { return v.x() + v.y() + v.z(); }

}  // namespace

btPersistentManifold* PairDispatcher::getNewManifold(const btCollisionObject* a, const btCollisionObject* b) {
  btPersistentManifold* manifold = btCollisionDispatcher::getNewManifold(a, b);
  manifold->setContactBreakingThreshold(margin + kMargin);
  return manifold;
}

// ---- boxes

void Collision::fit(Occupant& occupant, const btVector3& way, double around) {
  btDbvtVolume need = box_of(occupant);
  need.tMins().setMin(need.Mins() + way);
  need.tMaxs().setMax(need.Maxs() + way);
  need.Expand({around, around, around});
  const double spare = std::min(kSpare, kSparePart * occupant.body->extent);
  if (occupant.leaf && occupant.box().Contain(need) && sum(occupant.box().Lengths() - need.Lengths()) < 6 * spare * kMostSpare) return;
  need.Expand({spare, spare, spare});
  overlaps_.set_box(occupant, need);
}

// A step ends with boxes for queries, and the next begins with the same ones unless somebody did something in between.
void Collision::fit(BodyState& body) {
  body.fall = pull_on(body) * seconds_ * seconds_;
  const Boxed now{body.travel, body.placed, from_bullet(body.rigid->getLinearVelocity()), from_bullet(body.rigid->getAngularVelocity()),
                  seconds_, body.fall};
  if (now == body.boxed) return;
  body.boxed = now;
  const double turning = body.rigid->getAngularVelocity().length() * seconds_;
  const double around = std::min(kMargin, kMarginPart * body.extent) + body.fall;
  const btVector3 way = body.rigid->getLinearVelocity() * seconds_;
  body.ahead = way.length() + turning * body.extent;
  if (!body.solids->empty()) fit(body.solid_box, way, around + turning * body.extent);
  if (body.ghost) fit(body.trigger_box, way, around + turning * body.trigger_extent);
}

// m/s^2, of gravity and of what pushes it in the next step.
double Collision::pull_on(const BodyState& body) const {
  if (!body.dynamic()) return 0;
  const double pull = length(gravity_ * body.def.gravity_factor + body.force * (body.mass.mass > 0 ? 1 / body.mass.mass : 0));
  return pull < kFastestPull ? pull : kFastestPull;
}

void Collision::fit_boxes(const std::vector<BodyState*>& carriers) {
  for (BodyState* body : awake_.bodies()) fit(*body);
  for (BodyState* body : carriers) fit(*body);
}

// ---- pairs of solids

double Collision::margin_of(const BodyState& a, const BodyState& b) const {
  const double speed = (a.rigid->getLinearVelocity() - b.rigid->getLinearVelocity()).length() + whirl(a) + whirl(b);
  const double smaller = std::min(reach_of(a), reach_of(b));
  double way = speed * seconds_;
  // A body that is not to be looked after goes through what is thinner than its way.
  for (const BodyState* body : {&a, &b})
    if (body->dynamic() && !body->def.continuous.value_or(true)) way = std::min(way, inner_radius(body->def));
  return std::min(kMargin, kMarginPart * smaller) + way + std::max(a.fall, b.fall);
}

// May they touch there before the step is over? Points are also found beside the way of what flies past.
bool Collision::comes_to(const BodyState& a, const BodyState& b, Vec3 normal, double separation) const {
  const double closing = dot(from_bullet(b.rigid->getLinearVelocity() - a.rigid->getLinearVelocity()), normal) + whirl(a) + whirl(b);
  return separation <= kMargin + std::max(closing, 0.0) * seconds_ + std::max(a.fall, b.fall);
}

bool Collision::any_near(Overlap& overlap) {
  const BodyState &a = *overlap.a->body, &b = *overlap.b->body;
  if (overlap.kind == Overlap::bodies) return comes_to(a, b, overlap.pair->contact().normal, overlap.pair->contact().nearest());
  manifolds_.resizeNoInitialize(0);
  if (overlap.algorithm) overlap.algorithm->getAllContactManifolds(manifolds_);
  for (int i = 0; i < manifolds_.size(); ++i)
    for (int p = 0; p < manifolds_[i]->getNumContacts(); ++p) {
      const btManifoldPoint& point = manifolds_[i]->getContactPoint(p);
      const Vec3 normal = from_bullet(point.m_normalWorldOnB);
      if (comes_to(a, b, manifolds_[i]->getBody0() == overlap.a->object ? normal : -normal, point.getDistance())) return true;
    }
  return false;
}

// What moves wakes what it meets; what is moved by somebody keeps it awake.
void Collision::wake_by(Overlap& overlap) {
  BodyState &a = *overlap.a->body, &b = *overlap.b->body;
  const auto wakes = [](const BodyState& one, const BodyState& other) {
    return one.active && other.dynamic() && (!other.active || !one.dynamic());
  };
  if (wakes(a, b) && any_near(overlap)) awake_.wake(b);
  if (wakes(b, a) && any_near(overlap)) awake_.wake(a);
}

void Collision::look_at_bodies(Overlap& overlap) const {
  const BodyState &a = *overlap.a->body, &b = *overlap.b->body;
  overlap.pair->look(std::max(a.fall, b.fall), [&] { return margin_of(a, b); });
}

void Collision::look_at(Overlap& overlap) {
  BodyState &a = *overlap.a->body, &b = *overlap.b->body;
  dispatcher_.margin = margin_of(a, b);
  process(overlap, dispatcher_, info_, now(*overlap.a), now(*overlap.b));
  wake_by(overlap);
}

void Collision::look(double seconds, Vec3 gravity, const std::vector<BodyState*>& carriers, Team& team) {
  constexpr std::size_t kPairs = 64;  // that are worth handing to another thread
  seconds_ = seconds;
  gravity_ = gravity;
  fit_boxes(carriers);
  overlaps_.tidy();
  if (overlaps_.left_out()) overlaps_.meet_again(awake_.bodies());
  overlaps_.found.clear();
  // Whoever wakes meanwhile adds his pairs to the ends of the lists.
  std::vector<Overlap*>&bodies = overlaps_.active(Overlap::bodies), &solids = overlaps_.active(Overlap::solids);
  for (std::size_t i = 0, k = 0, looked_at = 0; i < bodies.size() || k < solids.size();) {
    if (looked_at < bodies.size()) {
      team.each(bodies.size() - looked_at, kPairs, [&, first = looked_at](std::size_t from, std::size_t to) {
        for (std::size_t at = first + from; at < first + to; ++at) look_at_bodies(*bodies[at]);
      });
      looked_at = bodies.size();
    }
    if (i == bodies.size()) look_at(*solids[k++]);
    else if (Overlap& overlap = *bodies[i++]; overlap.pair->tell()) wake_by(overlap);
  }
  awake_.sort();
}

// ---- triggers

bool Collision::any_inside(Overlap& overlap) {
  manifolds_.resizeNoInitialize(0);
  if (overlap.algorithm) overlap.algorithm->getAllContactManifolds(manifolds_);
  for (int i = 0; i < manifolds_.size(); ++i)
    for (int p = 0; p < manifolds_[i]->getNumContacts(); ++p)
      if (manifolds_[i]->getContactPoint(p).getDistance() <= 0) return true;
  return false;
}

// Is it in there at the end of the step, or, if it was not before, was it at any time of it? What is faster than it is
// thick is looked at on its way as well.
void Collision::look_into(Overlap& overlap, double seconds) {
  const Occupant &a = *overlap.a, &b = *overlap.b;
  BodyState &body_a = *a.body, &body_b = *b.body;
  dispatcher_.margin = kTriggerMargin;  // 0 would be taken for none
  process(overlap, dispatcher_, info_, now(a), now(b));
  const double way = distance(straight_way(body_a), straight_way(body_b)), thick = inner_radius(body_a.def) + inner_radius(body_b.def);
  const int looks = thick > 0 ? std::clamp(static_cast<int>(std::ceil(std::min(way / thick, 1e6))), 1, kMostLooks) : 1;
  if (looks == 1 || any_inside(overlap)) return;
  const bool was_in = std::any_of(body_a.pairs.begin(), body_a.pairs.end(), [&](const Pair* known) {
    return known->trigger && (known->a == &body_b || known->b == &body_b);
  });
  if (was_in) return;
  const Way way_a(body_a, seconds), way_b(body_b, seconds);
  for (int i = looks - 1; i >= 1; --i) {
    const double part = static_cast<double>(i) / looks;
    process(overlap, dispatcher_, info_, {*a.object, way_a.at(part)}, {*b.object, way_b.at(part)});
    if (!any_inside(overlap)) continue;
    passages_.push_back({&body_a, &body_b, part});
    return;
  }
}

void Collision::look_into_triggers(double seconds, const std::vector<BodyState*>& carriers) {
  passages_.clear();
  if (!overlaps_.has_triggers()) return;
  const auto look = [&] {
    for (Overlap* overlap : overlaps_.active(Overlap::triggers)) look_into(*overlap, seconds);
  };
  look();  // along the ways for which the boxes were made; those stay until what they found has been read
  bool strayed = false;
  const auto follow = [&](BodyState& body) {
    for (const Occupant* occupant : {&body.solid_box, &body.trigger_box}) {
      if (!occupant->leaf || Intersect(box_of(*occupant), occupant->box())) continue;
      fit(body);
      strayed = true;
    }
  };
  for (BodyState* body : awake_.bodies()) follow(*body);
  for (BodyState* body : carriers) follow(*body);
  if (strayed) look();
}

}  // namespace tumble
