#include "physics/bullet/solver.h"

#include <algorithm>

#include "physics/bullet/materials.h"
#include "physics/dynamics/impact.h"
#include "physics/world.h"

namespace tumble {

namespace {

using dynamics::Contact;
using dynamics::Mechanism;
using dynamics::Mover;
using dynamics::TouchPoint;

// A contact swings this many times in a substep, so that its stiffness grows with the number of substeps.
constexpr double kContactFrequency = 0.25;
constexpr double kContactDamping = 10;
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
constexpr double kLoad = 6, kGrain = 1.4e-3;  // of the weight; m, of the radius of gyration
constexpr int kMostWork = 3000;
// Points whose normals differ by more than 10 degrees do not share a patch.
constexpr double kOneNormal = 0.985;
// A body rests on what is nearer than this, m; a seam's points lie in its plane up to this, m, and its normal does not look
// further down than so, nor where the floor's does (cosines).
constexpr double kResting = 2e-3, kSeam = 2e-3, kSeamSteepest = -0.1, kSameNormal = 0.99999;
constexpr double kApart = 1;  // m: what is written of points that are not near any more

double reciprocal(double x) { return x > 0 ? 1 / x : 0; }

BodyState* pushed(const btCollisionObject* object) {
  BodyState* body = state_of(object);
  return body->dynamic() && object->isActive() ? body : nullptr;
}

double nearest(const Contact& contact) {
  double least = INFINITY;
  for (int i = 0; i < contact.count; ++i) least = std::min(least, contact.points[i].separation);
  return least;
}

// Where the ground is touched, and its normal.
Vec3 ground_point(const Contact& contact, int i) {
  return contact.a->pushable ? contact.b->position + contact.points[i].arm_b : contact.a->position + contact.points[i].arm_a;
}
Vec3 ground_normal(const Contact& contact) { return contact.a->pushable ? contact.normal : -contact.normal; }

bool is_seam(const Contact& contact, const Contact& floor) {
  const Vec3 up = ground_normal(floor);
  const double along = dot(ground_normal(contact), up);
  if (along < kSeamSteepest || along > kSameNormal) return false;
  if (nearest(floor) > kResting || nearest(contact) < nearest(floor)) return false;
  const Vec3 place = ground_point(floor, 0);
  for (int i = 0; i < contact.count; ++i)
    if (std::abs(dot(ground_point(contact, i) - place, up)) > kSeam) return false;
  return true;
}

// The friction that a point held at the end of the last step: along the contact's tangents.
Vec3 kept_grip(const btManifoldPoint& point, const Contact& contact, Vec3 arm) {
  const Vec3 force = contact.tangent_1 * point.m_appliedImpulseLateral1 + contact.tangent_2 * point.m_appliedImpulseLateral2;
  return {point.m_appliedImpulseLateral1, point.m_appliedImpulseLateral2, dot(contact.normal, cross(arm, force))};
}

double ball_radius(const BodyState& body) {
  const btCollisionShape* shape = body.rigid->getCollisionShape();
  return shape->getShapeType() == SPHERE_SHAPE_PROXYTYPE ? static_cast<const btSphereShape*>(shape)->getRadius() : 0;
}

void note_balls(Contact& contact, const BodyState& a, const BodyState& b) {
  const double radius_a = ball_radius(a), radius_b = ball_radius(b);
  if (radius_a <= 0 || radius_b <= 0) return;
  contact.radius_a = radius_a;
  contact.radius_b = radius_b;
  contact.fixed_a = from_bullet(a.rigid->getWorldTransform().getOrigin());
  contact.fixed_b = from_bullet(b.rigid->getWorldTransform().getOrigin());
}

// What of a contact's arm turns with the body: corners and edges wholly; of what is round, the axle about which it rolls.
Vec3 hub_of(const BodyState& body, int part, int index, Vec3 arm, bool& corner) {
  const btCollisionShape* shape = body.rigid->getCollisionShape();
  Vec3 center, axis = from_bullet(body.rigid->getWorldTransform().getBasis().getColumn(1));
  if (part < 0 && shape->isCompound() && index >= 0 && index < static_cast<int>(body.solids->pieces().size())) {
    const Piece& piece = body.solids->pieces()[static_cast<std::size_t>(index)];
    const btMatrix3x3& turned = body.rigid->getWorldTransform().getBasis();
    shape = piece.shape;
    center = from_bullet(turned * piece.local.getOrigin());
    axis = from_bullet((turned * piece.local.getBasis()).getColumn(1));
  }
  corner = shape->isConcave() || shape->isPolyhedral();
  if (corner) return arm;
  if (shape->getShapeType() == SPHERE_SHAPE_PROXYTYPE) return center;
  return center + axis * dot(axis, arm - center);
}

Vec3 middle(const Contact& contact) {
  Vec3 sum;
  for (int i = 0; i < contact.count; ++i) sum += contact.points[i].arm_a;
  return sum / contact.count;
}

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

double mass_of(const Mover& mover) { return reciprocal(std::max({mover.inverse_mass.x, mover.inverse_mass.y, mover.inverse_mass.z})); }

// Where something heavy comes to lie on something light nothing presses yet: their masses tell what will.
double first_load(const Contact& contact, double seconds) {
  if (!contact.a->pushable || !contact.b->pushable || contact.pressing() > 0) return 0;
  const Vec3 coming = contact.b->velocity - contact.a->velocity;
  if (nearest(contact) > std::max(1e-3, dot(coming, contact.normal) * seconds)) return 0;
  const double a = mass_of(*contact.a), b = mass_of(*contact.b);
  const bool a_above = dot(contact.normal, contact.a->acceleration) < 0;
  const double above = a_above ? a : b, below = a_above ? b : a;
  return below > 0 ? above / below / kLoad : 0;
}

// What presses there, over the weight of the lighter of the bodies and over what may be: the contact gives way by 0.07 mm
// times this at 4 substeps of 1/60 s, which is nothing to a brick and much to a grain. Impulses still are forces here.
double load_on(const Contact& contact, double seconds) {
  double load = first_load(contact, seconds);
  for (const Mover* mover : {contact.a, contact.b}) {
    const double pull = length(mover->acceleration), lightness = std::max({mover->inverse_mass.x, mover->inverse_mass.y, mover->inverse_mass.z});
    if (!mover->pushable || !(pull > 0)) continue;
    const Vec3 i = mover->inertia;
    const double gyration = std::sqrt(std::max({i.x, i.y, i.z}) * lightness), most = std::min(kLoad, gyration / kGrain);
    if (most > 0) load = std::max(load, contact.pressing() * lightness / pull / most);
  }
  return load;
}

}  // namespace

// ---- bodies

Mover& Solver::add_mover(BodyState& body) {
  movers_.emplace_back();
  bodies_.push_back(&body);
  Mover& mover = movers_.back();
  const btTransform& at = body.rigid->getWorldTransform();
  mover.position = from_bullet(at.getOrigin());
  mover.rotation = from_bullet(at.getRotation());
  mover.velocity = from_bullet(body.rigid->getLinearVelocity());
  mover.spin = from_bullet(body.rigid->getAngularVelocity());
  body.mover = &mover;
  return mover;
}

Mover& Solver::mover_of(const BodyState* body) { return body && body->mover ? *body->mover : movers_.front(); }

void Solver::gather_bodies(const WorldSettings& settings, const std::vector<BodyState*>& dynamics, const std::vector<BodyState*>& carriers) {
  for (BodyState* body : dynamics) {
    if (!body->rigid->isActive()) continue;
    Mover& mover = add_mover(*body);
    mover.pushable = true;
    mover.inverse_mass = from_bullet(body->rigid->getLinearFactor()) * reciprocal(body->mass.mass);
    mover.inertia = body->mass.inertia;
    mover.turn_factor = from_bullet(body->rigid->getAngularFactor());
    mover.acceleration = settings.gravity * body->def.gravity_factor + body->force * reciprocal(body->mass.mass);
    mover.torque = body->torque;
    mover.damping = body->def.damping;
    mover.angular_damping = body->def.angular_damping;
    mover.refresh();
  }
  for (BodyState* body : carriers)
    if (!body->dynamic()) add_mover(*body);
}

// ---- contacts

void Solver::gather_contacts(btDispatcher& dispatcher, double seconds) {
  for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
    btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(i);
    const btCollisionObject *a = manifold.getBody0(), *b = manifold.getBody1();
    if (manifold.getNumContacts() == 0 || is_ghost(a) || is_ghost(b) || (!pushed(a) && !pushed(b))) continue;
    gather_contacts(manifold, seconds);
  }
}

// Points of one manifold that share a normal and a friction are one contact.
void Solver::gather_contacts(btPersistentManifold& manifold, double seconds) {
  const std::size_t first = contacts_.size();
  for (int p = 0; p < manifold.getNumContacts(); ++p) {
    btManifoldPoint& point = manifold.getContactPoint(p);
    const Vec3 normal = from_bullet(point.m_normalWorldOnB);
    std::size_t at = first;
    while (at < contacts_.size() &&
           (dot(contacts_[at].normal, normal) < kOneNormal || contacts_[at].friction != point.m_combinedFriction))
      ++at;
    if (at == contacts_.size()) {
      Contact& contact = contacts_.emplace_back();
      sources_.emplace_back();
      contact.a = &mover_of(state_of(manifold.getBody0()));
      contact.b = &mover_of(state_of(manifold.getBody1()));
      contact.set_normal(normal);
      contact.limit_push();
      contact.friction = point.m_combinedFriction;
      note_balls(contact, *state_of(manifold.getBody0()), *state_of(manifold.getBody1()));
      if (point.m_contactPointFlags & BT_CONTACT_FLAG_LATERAL_FRICTION_INITIALIZED)
        contact.belt = from_bullet(point.m_lateralFrictionDir1) * point.m_contactMotion1;
    }
    add_point(contacts_[at], sources_[at], manifold, point);
  }
  if (contacts_.size() == first + 1 && contacts_[first].radius_a == 0)
    sources_[first].chase = Chase::of(*state_of(manifold.getBody0()), *state_of(manifold.getBody1()), manifold.getContactPoint(0), seconds);
  for (std::size_t at = first; at < contacts_.size(); ++at) {
    Contact& contact = contacts_[at];
    const Vec3 center = middle(contact);
    for (int i = 0; i < contact.count; ++i)
      contact.grip += kept_grip(*sources_[at].points[i], contact, contact.points[i].arm_a - center);
  }
}

void Solver::add_point(Contact& contact, Source& source, btPersistentManifold& manifold, btManifoldPoint& point) {
  source.points[contact.count] = &point;
  TouchPoint& touch = contact.points[contact.count++];
  touch.arm_a = from_bullet(point.getPositionWorldOnA()) - contact.a->position;
  touch.arm_b = from_bullet(point.getPositionWorldOnB()) - contact.b->position;
  touch.hub_a = hub_of(*state_of(manifold.getBody0()), point.m_partId0, point.m_index0, touch.arm_a, touch.corner_a);
  touch.hub_b = hub_of(*state_of(manifold.getBody1()), point.m_partId1, point.m_index1, touch.arm_b, touch.corner_b);
  touch.separation = point.getDistance();
  touch.restitution = contact_restitution(manifold, point);
  touch.impulse = point.m_prevRHS;  // a force yet; see run()
}

// A floor of several boxes or meshes has edges that are none: what slides or rolls over it would be stopped by the next
// piece's edge or side. A contact that lies within the plane of another one on which the body rests says nothing new.
void Solver::drop_seams() {
  std::map<const Mover*, std::vector<std::size_t>> on_ground;  // looked up, never walked through in its order
  std::vector<const Mover*> several;
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    const Contact& contact = contacts_[i];
    if (contact.a->pushable == contact.b->pushable) continue;
    const Mover* body = contact.a->pushable ? contact.a : contact.b;
    std::vector<std::size_t>& list = on_ground[body];
    list.push_back(i);
    if (list.size() == 2) several.push_back(body);
  }
  std::vector<bool> dropped(contacts_.size());
  for (const Mover* body : several)
    for (const std::size_t i : on_ground[body])
      for (const std::size_t k : on_ground[body])
        if (i != k && !dropped[k] && is_seam(contacts_[i], contacts_[k])) dropped[i] = true;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    if (dropped[i]) {
      contacts_[i].count = 0;
      write_contact(contacts_[i], sources_[i]);
      continue;
    }
    if (kept != i) {
      contacts_[kept] = contacts_[i];
      sources_[kept] = std::move(sources_[i]);
    }
    ++kept;
  }
  contacts_.resize(kept);
  sources_.resize(kept);
}

// ---- joints

void Solver::find_mechanisms(const std::vector<JointPart*>& live) {
  mechanisms_.clear();
  std::map<const BodyState*, std::size_t> group_of;  // looked up, never walked through
  std::vector<std::vector<JointPart*>>& groups = groups_;
  groups.clear();
  for (JointPart* joint : live) {
    std::size_t group = groups.size();
    groups.push_back({joint});
    for (const BodyState* body : {joint->a, joint->b}) {
      if (!body || !body->dynamic()) continue;
      const auto [at, fresh] = group_of.emplace(body, group);
      if (fresh || at->second == group) continue;
      const std::size_t kept = std::min(group, at->second), gone = std::max(group, at->second);
      groups[kept].insert(groups[kept].end(), groups[gone].begin(), groups[gone].end());
      groups[gone].clear();
      for (auto& [other, number] : group_of)
        if (number == gone) number = kept;
      group = kept;
    }
  }
  std::erase_if(groups, [](const std::vector<JointPart*>& group) { return group.empty(); });
  for (std::vector<JointPart*>& group : groups) {
    std::sort(group.begin(), group.end(), [](const JointPart* x, const JointPart* y) { return x->serial < y->serial; });
    std::vector<dynamics::Link*> links;
    for (JointPart* joint : group) links.push_back(&joint->link);
    mechanisms_.push_back(std::make_unique<Mechanism>(links));
  }
  mechanisms_known_ = true;
}

// What touched one of them may have woken it after its island was left asleep.
void Solver::wake_together() {
  for (const std::vector<JointPart*>& group : groups_) {
    if (std::none_of(group.begin(), group.end(), [](const JointPart* joint) { return joint->awake(); })) continue;
    for (const JointPart* joint : group)
      for (BodyState* body : {joint->a, joint->b})
        if (body && body->dynamic() && !body->rigid->isActive()) body->rigid->forceActivationState(ACTIVE_TAG);
  }
}

void Solver::gather_mechanisms(const std::vector<JointPart*>& live) {
  for (JointPart* joint : live) {
    if (!joint->awake()) continue;
    dynamics::Link& link = joint->link;
    for (BodyState* body : {joint->a, joint->b})
      if (body && !body->mover) add_mover(*body);
    link.kind = &joint->def.kind;
    link.a = &mover_of(joint->a);
    link.b = &mover_of(joint->b);
    link.local_a = joint->a ? inverse(joint->a->frame) * joint->local_a : joint->local_a;
    link.local_b = joint->b ? inverse(joint->b->frame) * joint->local_b : joint->local_b;
    link.impulse = link.twist = {};
    link.a->bound = link.b->bound = true;
  }
  const auto pushable = [](const dynamics::Link* link) { return link->a && (link->a->pushable || link->b->pushable); };
  for (const auto& mechanism : mechanisms_) {
    const auto& links = mechanism->links();
    if (std::none_of(links.begin(), links.end(), pushable)) continue;
    awake_.push_back(mechanism.get());
  }
}

// ---- a step

void Solver::begin(const WorldSettings& settings, const std::vector<BodyState*>& dynamics, const std::vector<BodyState*>& carriers,
                   const std::vector<JointPart*>& live, btDispatcher& dispatcher, double seconds) {
  movers_.clear();
  bodies_.clear();
  contacts_.clear();
  sources_.clear();
  awake_.clear();
  movers_.emplace_back();  // what cannot move
  if (!mechanisms_known_) find_mechanisms(live);
  wake_together();
  gather_bodies(settings, dynamics, carriers);
  for (JointPart* joint : live) joint->link.a = joint->link.b = nullptr;
  if (!live.empty()) gather_mechanisms(live);
  gather_contacts(dispatcher, seconds);
  drop_seams();
  find_islands();
  separate_carriers();
}

// ---- islands

void Solver::find_islands() {
  islands_.clear();
  // Union by index: a mover's root is the first of its island.
  std::map<const Mover*, std::size_t> index;
  std::vector<std::size_t> parent;
  for (const Mover& mover : movers_) {
    if (!mover.pushable) continue;
    index.emplace(&mover, parent.size());
    parent.push_back(parent.size());
  }
  const auto root = [&parent](std::size_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  const auto unite = [&](const Mover* a, const Mover* b) {
    if (!a->pushable || !b->pushable) return;
    const std::size_t x = root(index[a]), y = root(index[b]);
    parent[std::max(x, y)] = std::min(x, y);
  };
  for (const Contact& contact : contacts_) unite(contact.a, contact.b);
  for (const Mechanism* mechanism : awake_)
    for (const dynamics::Link* link : mechanism->links()) {
      unite(link->a, link->b);
      const dynamics::Link* first = mechanism->links().front();
      unite(link->a->pushable ? link->a : link->b, first->a->pushable ? first->a : first->b);
    }

  std::vector<std::size_t> island_of(parent.size());
  for (Mover& mover : movers_) {
    if (!mover.pushable) continue;
    const std::size_t i = index[&mover], at = root(i);
    if (at == i) {
      island_of[i] = islands_.size();
      islands_.emplace_back();
    }
    islands_[island_of[at]].movers.push_back(&mover);
  }
  const auto island = [&](const Mover* a, const Mover* b) -> Island& { return islands_[island_of[root(index[a->pushable ? a : b])]]; };
  for (Contact& contact : contacts_) {
    Island& here = island(contact.a, contact.b);
    here.contacts.push_back(&contact);
    Source& source = sources_[static_cast<std::size_t>(&contact - contacts_.data())];
    if (source.chase) here.chases.emplace_back(&*source.chase, &contact);
    for (int i = 0; i < contact.count; ++i) here.bouncy |= contact.points[i].restitution > 0;
  }
  for (Mechanism* mechanism : awake_) {
    const dynamics::Link* first = mechanism->links().front();
    island(first->a, first->b).mechanisms.push_back(mechanism);
  }
}

// What moves and cannot be pushed goes its way in each island anew.
void Solver::separate_carriers() {
  for (Island& island : islands_) {
    std::map<const Mover*, Mover*> own;
    const auto take = [&](Mover*& mover) {
      if (mover->pushable || (mover->velocity == Vec3{} && mover->spin == Vec3{})) return;
      Mover*& copy = own[mover];
      if (!copy) {
        movers_.push_back(*mover);
        copy = &movers_.back();
        island.movers.push_back(copy);
      }
      mover = copy;
    };
    for (Contact* contact : island.contacts) {
      take(contact->a);
      take(contact->b);
    }
    for (Mechanism* mechanism : island.mechanisms)
      for (dynamics::Link* link : mechanism->links()) {
        take(link->a);
        take(link->b);
      }
    bool joined = false;
    for (const Contact* contact : island.contacts) joined |= contact->a->bound || contact->b->bound;
    for (Mechanism* mechanism : island.mechanisms) mechanism->touched = joined;
  }
}

// A gyroscope must not swing far in a substep, and what bears many times its own weight needs smaller ones; but a large
// heap is not to cost many times as much for a few of its bodies.
int Solver::substeps_of(const Island& island, double seconds, int least) const {
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

// ---- a step

void Solver::run(double seconds, int least, int rounds) {
  for (Island& island : islands_) {
    const int count = substeps_of(island, seconds, least);
    const double h = seconds / count;
    for (Mechanism* mechanism : island.mechanisms) mechanism->begin_step(h);
    for (Contact* contact : island.contacts) contact->scale(h);
    for (int i = 0; i < count; ++i) substep(island, h, rounds);
    for (Contact* contact : island.contacts) contact->scale(1 / h);
  }
}

void Solver::substep(Island& island, double h, int rounds) {
  const dynamics::Softness soft = dynamics::softness(kContactFrequency / h, kContactDamping, h);
  for (Mechanism* mechanism : island.mechanisms) mechanism->begin();
  for (const auto& [chase, contact] : island.chases) chase->look(*contact, h);
  for (Contact* contact : island.contacts) contact->begin(h);
  for (Mover* mover : island.movers)
    if (mover->pushable) kick_before(*mover, h);
  for (Contact* contact : island.contacts) contact->foresee(h);
  if (island.bouncy) dynamics::bounce(island.contacts, island.mechanisms, h);
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

// As often as asked, and on, where it still runs, while a blow goes through a stack.
void Solver::solve_in_rounds(Island& island, int least, double h, const dynamics::Softness* soft) {
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
      contact->a->stirred = contact->b->stirred = round;
      any = true;
    }
    if (round + 1 >= least && !any) break;
  }
}

void Solver::move(Island& island, double h) {
  for (Mover* mover : island.movers) drift(*mover, h);
  for (Mechanism* mechanism : island.mechanisms) mechanism->close_gaps(h);
  for (Mechanism* mechanism : island.mechanisms) mechanism->turn_to_now(h);
  for (Contact* contact : island.contacts) contact->drifted(h);
  for (Mover* mover : island.movers)
    if (mover->pushable) kick_after(*mover, h);
}

// ---- back

void Solver::end(double seconds) {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    BodyState& body = *bodies_[i];
    Mover& mover = movers_[i + 1];
    body.mover = nullptr;
    if (!mover.pushable) {
      if (mover.velocity == Vec3{} && mover.spin == Vec3{}) continue;
      drift(mover, seconds);  // islands moved copies of it
    }
    body.place(btTransform(to_bullet(mover.rotation), to_bullet(mover.position)));
    if (!mover.pushable) continue;
    body.rigid->setLinearVelocity(to_bullet(mover.velocity));
    body.rigid->setAngularVelocity(to_bullet(mover.spin));
  }
  for (std::size_t i = 0; i < contacts_.size(); ++i) write_contact(contacts_[i], sources_[i]);
}

// The friction is spread over the points as it would be by springs there: evenly along, and about their middle.
void Solver::write_contact(const Contact& contact, const Source& source) const {
  const Vec3 center = middle(contact);
  double spread = 0;
  for (int i = 0; i < contact.count; ++i) spread += dot(contact.points[i].arm_a - center, contact.points[i].arm_a - center);
  for (int i = 0; i < Contact::kMostPoints && source.points[i]; ++i) {
    const TouchPoint& touch = contact.points[i];
    btManifoldPoint& point = *source.points[i];
    point.m_appliedImpulse = touch.sum;
    if (i >= contact.count) {  // gone meanwhile; see Chase
      point.m_prevRHS = point.m_appliedImpulseLateral1 = point.m_appliedImpulseLateral2 = 0;
      point.setDistance(kApart);
      continue;
    }
    const Vec3 about = spread > 0 ? cross(contact.normal, touch.arm_a - center) * (contact.grip.z / spread) : Vec3{};
    point.m_prevRHS = touch.impulse;
    point.m_appliedImpulseLateral1 = contact.grip.x / contact.count + dot(about, contact.tangent_1);
    point.m_appliedImpulseLateral2 = contact.grip.y / contact.count + dot(about, contact.tangent_2);
    point.setDistance(touch.separation);
    point.m_positionWorldOnA = to_bullet(contact.a->position + touch.arm_a);
    point.m_positionWorldOnB = to_bullet(contact.b->position + touch.arm_b);
  }
}

}  // namespace tumble
