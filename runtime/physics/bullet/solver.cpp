#include "physics/bullet/solver.h"

#include <algorithm>

#include "physics/bullet/materials.h"
#include "physics/world.h"

namespace tumble {

namespace {

using dynamics::Contact;
using dynamics::Mechanism;
using dynamics::Mover;
using dynamics::TouchPoint;

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

// Where the ground is touched, and its normal.
Vec3 ground_point(const Contact& contact, int i) {
  return contact.a->pushable ? contact.b->position + contact.points[i].arm_b : contact.a->position + contact.points[i].arm_a;
}
Vec3 ground_normal(const Contact& contact) { return contact.a->pushable ? contact.normal : -contact.normal; }

bool is_seam(const Contact& contact, const Contact& floor) {
  const Vec3 up = ground_normal(floor);
  const double along = dot(ground_normal(contact), up);
  if (along < kSeamSteepest || along > kSameNormal) return false;
  if (floor.nearest() > kResting || contact.nearest() < floor.nearest()) return false;
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
  islands_ = dynamics::find_islands(movers_, contacts_, awake_);
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    Contact& contact = contacts_[i];
    if (Chase* chase = sources_[i].chase ? &*sources_[i].chase : nullptr)
      islands_[static_cast<std::size_t>(contact.island())].looks.emplace_back([chase, &contact](double h) { chase->look(contact, h); });
  }
}

void Solver::run(double seconds, int least, int rounds) {
  for (dynamics::Island& island : islands_) {
    if (!dynamics::is_heap(island)) {
      dynamics::run(island, seconds, least, rounds);
      continue;
    }
    const int count = dynamics::substeps_of(island, seconds, least);
    if (!heaps_[count]) heaps_[count] = std::make_unique<dynamics::Heap>();
    heaps_[count]->add(island);
  }
  for (auto& [count, heap] : heaps_) heap->run(seconds, count, rounds);
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
