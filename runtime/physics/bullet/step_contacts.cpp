#include "physics/bullet/step_contacts.h"

#include <algorithm>

#include "physics/bullet/contacts.h"
#include "physics/bullet/convex_pair.h"
#include "physics/bullet/crowd.h"
#include "physics/bullet/materials.h"
#include "physics/pairs/hub.h"

namespace tumble {

namespace {

using dynamics::Contact;
using dynamics::Mover;
using dynamics::TouchPoint;

// Points whose normals differ by more than 10 degrees do not share a patch.
constexpr double kOneNormal = 0.985;
// A body rests on what is nearer than this, m; a seam's points lie in its plane up to this, m, and its normal does not look
// further down than so, nor where the floor's does (cosines).
constexpr double kResting = 2e-3, kSeam = 2e-3, kSeamSteepest = -0.1, kSameNormal = 0.99999;
constexpr double kApart = 1;  // m: what is written of points that are not near any more

bool moves(const BodyState& body) { return body.mover && body.mover->pushable; }
Mover& mover_of(const BodyState& body, std::deque<Mover>& movers) { return body.mover ? *body.mover : movers.front(); }

// ---- of manifolds

// The friction that a point held at the end of the last step: along the contact's tangents.
Vec3 kept_grip(const btManifoldPoint& point, const Contact& contact, Vec3 arm) {
  const Vec3 force = contact.tangent_1 * point.m_appliedImpulseLateral1 + contact.tangent_2 * point.m_appliedImpulseLateral2;
  return {point.m_appliedImpulseLateral1, point.m_appliedImpulseLateral2, dot(contact.normal, cross(arm, force))};
}

// What of a contact's arm turns with the body, and how.
pairs::Hub hub_of(const BodyState& body, int part, int index, Vec3 arm) {
  const btCollisionShape* shape = body.rigid->getCollisionShape();
  Pose at = body.center;
  if (part < 0 && shape->isCompound() && index >= 0 && index < static_cast<int>(body.solids->pieces().size())) {
    const Piece& piece = body.solids->pieces()[static_cast<std::size_t>(index)];
    shape = piece.shape;
    at = at * from_bullet(piece.local);
  }
  pairs::Convex convex;
  if (!shape->isConvex() || !convex_of(*shape, convex)) return {arm, true, {}};
  return pairs::hub_of(convex, at, body.center.position, arm);
}

void take_hub(const pairs::Hub& hub, Vec3& arm, bool& corner, Vec3& axis) {
  arm = hub.arm;
  corner = hub.corner;
  axis = hub.axis;
}

Vec3 middle(const Contact& contact) {
  Vec3 sum;
  for (int i = 0; i < contact.count; ++i) sum += contact.points[i].arm_a;
  return sum / contact.count;
}

// The friction is spread over the points as it would be by springs there: evenly along, and about their middle.
void write_contact(const Contact& contact, btManifoldPoint* const* points) {
  const Vec3 center = middle(contact);
  double spread = 0;
  for (int i = 0; i < contact.count; ++i) spread += dot(contact.points[i].arm_a - center, contact.points[i].arm_a - center);
  for (int i = 0; i < Contact::kMostPoints && points[i]; ++i) {
    const TouchPoint& touch = contact.points[i];
    btManifoldPoint& point = *points[i];
    point.m_appliedImpulse = (i < contact.count ? touch.sum : 0) + (i == 0 ? contact.lost.sum : 0);
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

// ---- of kept contacts

// One that turns about its own centre.
bool is_ball(const BodyState& body) { return body.convex.kind == pairs::Convex::sphere && body.convex_at.position == Vec3{}; }

// How far what is round reaches from its axis or centre towards the other; of two such, as if one rolled on a flat.
double rolling_radius(const Contact& contact) {
  const TouchPoint& point = contact.points[0];
  const double a = point.corner_a ? 0 : std::max(0.0, dot(point.hub_a - point.arm_a, contact.normal));
  const double b = point.corner_b ? 0 : std::max(0.0, dot(point.arm_b - point.hub_b, contact.normal));
  return a > 0 && b > 0 ? a * b / (a + b) : std::max(a, b);
}

void set_rolling(Contact& contact, const BodyState& a, const BodyState& b) {
  const double rolling = std::max(a.def.rolling_friction, b.def.rolling_friction);
  const double spinning = std::max(a.def.spinning_friction, b.def.spinning_friction);
  const double radius = rolling > 0 || spinning > 0 ? rolling_radius(contact) : 0;
  contact.rolling = rolling * radius;
  contact.spinning = spinning * radius;
}

// The mover that stands for all that does not move is at the origin.
void shift_arms(Contact& contact, Vec3 TouchPoint::*arm, Vec3 by) {
  for (int i = 0; i < contact.count; ++i) contact.points[i].*arm += by;
}

bool touches(const Contact& contact, bool already) {
  return contact.lost.sum > 0 || std::any_of(contact.points, contact.points + contact.count, [&](const TouchPoint& point) {
    return point.separation <= 0 || point.sum > 0 || (already && point.separation <= kStillTouching);
  });
}

void forget_forces(Contact& contact) {
  for (TouchPoint& point : contact.points) point.impulse = point.sum = 0;
  contact.grip = contact.roll = {};
  contact.lost = {};
}

// As if it were not there in this step.
void leave_out(KeptContact& kept) {
  forget_forces(kept.contact);
  for (TouchPoint& point : kept.contact.points) point.separation = kApart;
  kept.spoil();
}

// ---- seams

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

// The body that touches what cannot be pushed.
Mover* on_ground(const Contact& contact) {
  if (contact.a->pushable == contact.b->pushable) return nullptr;
  return contact.a->pushable ? contact.a : contact.b;
}

}  // namespace

void StepContacts::gather(Collision& collision, std::deque<Mover>& movers, double seconds) {
  list_.clear();
  kept_.clear();
  taken_.clear();
  made_.clear();
  chases_.clear();
  const Crowd crowd(collision.found());
  for (KeptContact* kept : collision.found()) {
    kept->touching = crowd.leaves_out(*kept);
    if (kept->touching) forget_forces(kept->contact);
    else if (moves(*kept->a) || moves(*kept->b)) take(*kept, movers, seconds);
  }
  collision.each_manifold(Overlap::solids, [&](btPersistentManifold& manifold) {
    if (moves(*state_of(manifold.getBody0())) || moves(*state_of(manifold.getBody1()))) make(manifold, movers, seconds);
  });
  drop_seams();
}

void StepContacts::take(KeptContact& kept, std::deque<Mover>& movers, double seconds) {
  const BodyState &a = *kept.a, &b = *kept.b;
  Contact& contact = kept.contact;
  contact.a = &mover_of(a, movers);
  contact.b = &mover_of(b, movers);
  contact.limit_push();
  contact.belt = belt_between(a, b);
  contact.lost = {};
  const Pose at_a = a.convex_pose(), at_b = b.convex_pose();
  for (int i = 0; i < contact.count; ++i) {
    TouchPoint& point = contact.points[i];
    take_hub(pairs::hub_of(a.convex, at_a, a.center.position, point.arm_a), point.hub_a, point.corner_a, contact.axis_a);
    take_hub(pairs::hub_of(b.convex, at_b, b.center.position, point.arm_b), point.hub_b, point.corner_b, contact.axis_b);
    point.sum = 0;
  }
  set_rolling(contact, a, b);
  if (is_ball(a) && is_ball(b)) {
    contact.radius_a = a.convex.radius;
    contact.radius_b = b.convex.radius;
    contact.center_a = a.mover ? Vec3{} : a.center.position;
    contact.center_b = b.mover ? Vec3{} : b.center.position;
  } else if (auto chase = Chase::of({a, -1, 0}, {b, -1, 0}, contact.points[0].separation, seconds)) {
    chases_.push_back({&contact, *chase});
    kept.spoil();
  }
  for (const bool first : {true, false}) {
    const BodyState& body = first ? a : b;
    if (body.mover) continue;
    shift_arms(contact, first ? &TouchPoint::arm_a : &TouchPoint::arm_b, body.center.position);
    shift_arms(contact, first ? &TouchPoint::hub_a : &TouchPoint::hub_b, body.center.position);
  }
  list_.push_back(&contact);
  kept_.push_back(&kept);
  taken_.push_back(&kept);
}

// Points of one manifold that share a normal and a friction are one contact.
void StepContacts::make(btPersistentManifold& manifold, std::deque<Mover>& movers, double seconds) {
  const BodyState &a = *state_of(manifold.getBody0()), &b = *state_of(manifold.getBody1());
  const std::size_t first = made_.size();
  for (int p = 0; p < manifold.getNumContacts(); ++p) {
    btManifoldPoint& point = manifold.getContactPoint(p);
    const Vec3 normal = from_bullet(point.m_normalWorldOnB);
    std::size_t at = first;
    while (at < made_.size() && (dot(made_[at].contact.normal, normal) < kOneNormal || made_[at].contact.friction != point.m_combinedFriction)) ++at;
    if (at == made_.size()) {
      Contact& contact = made_.emplace_back().contact;
      contact.a = &mover_of(a, movers);
      contact.b = &mover_of(b, movers);
      contact.set_normal(normal);
      contact.limit_push();
      contact.friction = point.m_combinedFriction;
      if (point.m_contactPointFlags & BT_CONTACT_FLAG_LATERAL_FRICTION_INITIALIZED)
        contact.belt = from_bullet(point.m_lateralFrictionDir1) * point.m_contactMotion1;
      list_.push_back(&contact);
      kept_.push_back(nullptr);
    }
    add_point(made_[at], manifold, point);
  }
  if (made_.size() == first + 1) {
    const btManifoldPoint& point = manifold.getContactPoint(0);
    if (auto chase = Chase::of({a, point.m_partId0, point.m_index0}, {b, point.m_partId1, point.m_index1}, point.getDistance(), seconds))
      chases_.push_back({&made_.back().contact, *chase});
  }
  for (std::size_t at = first; at < made_.size(); ++at) {
    Contact& contact = made_[at].contact;
    set_rolling(contact, a, b);
    const Vec3 center = middle(contact);
    for (int i = 0; i < contact.count; ++i)
      contact.grip += kept_grip(*made_[at].points[i], contact, contact.points[i].arm_a - center);
  }
}

void StepContacts::add_point(Made& made, btPersistentManifold& manifold, btManifoldPoint& point) {
  Contact& contact = made.contact;
  made.points[contact.count] = &point;
  TouchPoint& touch = contact.points[contact.count++];
  const BodyState &a = *state_of(manifold.getBody0()), &b = *state_of(manifold.getBody1());
  const Vec3 center_a = a.center.position, center_b = b.center.position;
  touch.arm_a = from_bullet(point.getPositionWorldOnA()) - center_a;
  touch.arm_b = from_bullet(point.getPositionWorldOnB()) - center_b;
  take_hub(hub_of(a, point.m_partId0, point.m_index0, touch.arm_a), touch.hub_a, touch.corner_a, contact.axis_a);
  take_hub(hub_of(b, point.m_partId1, point.m_index1, touch.arm_b), touch.hub_b, touch.corner_b, contact.axis_b);
  for (Vec3* arm : {&touch.arm_a, &touch.hub_a}) *arm += center_a - contact.a->position;  // the mover of what cannot move is elsewhere
  for (Vec3* arm : {&touch.arm_b, &touch.hub_b}) *arm += center_b - contact.b->position;
  touch.separation = point.getDistance();
  touch.restitution = contact_restitution(manifold, point);
  touch.impulse = point.m_prevRHS;  // a force yet; see run()
}

// A floor of several boxes or meshes has edges that are none: what slides or rolls over it would be stopped by the next
// piece's edge or side. A contact that lies within the plane of another one on which the body rests says nothing new.
void StepContacts::drop_seams() {
  bool any = false;
  for (const Contact* contact : list_)
    if (Mover* body = on_ground(*contact)) any |= ++body->grounds > 1;
  std::vector<std::vector<std::size_t>> grounds;  // of bodies that touch several, by `grounds`
  for (std::size_t i = 0; any && i < list_.size(); ++i) {
    Mover* body = on_ground(*list_[i]);
    if (!body || body->grounds == 1) continue;
    if (body->grounds > 0) {
      body->grounds = -static_cast<int>(grounds.size());
      grounds.emplace_back();
    }
    grounds[static_cast<std::size_t>(-body->grounds)].push_back(i);
  }
  std::vector<bool> dropped(grounds.empty() ? 0 : list_.size());
  for (const std::vector<std::size_t>& ground : grounds)
    for (const std::size_t i : ground)
      for (const std::size_t k : ground)
        if (i != k && !dropped[k] && is_seam(*list_[i], *list_[k])) dropped[i] = true;
  if (dropped.empty()) return;
  std::vector<const Contact*> gone;
  for (std::size_t i = 0; i < list_.size(); ++i)
    if (dropped[i]) gone.push_back(list_[i]);
  std::erase_if(chases_, [&](const Chased& chased) { return std::find(gone.begin(), gone.end(), chased.contact) != gone.end(); });
  std::size_t left = 0;
  for (std::size_t i = 0; i < list_.size(); ++i) {
    if (!dropped[i]) {
      kept_[left] = kept_[i];
      list_[left++] = list_[i];
      continue;
    }
    if (kept_[i]) leave_out(*kept_[i]);
    else list_[i]->count = 0;
  }
  list_.resize(left);
  kept_.resize(left);
}

void StepContacts::write_back(const std::deque<Mover>& movers) {
  for (KeptContact* kept : taken_) {
    Contact& contact = kept->contact;
    if (contact.a == &movers.front()) shift_arms(contact, &TouchPoint::arm_a, -kept->a->center.position);
    if (contact.b == &movers.front()) shift_arms(contact, &TouchPoint::arm_b, -kept->b->center.position);
    kept->touching = touches(contact, kept->pair != nullptr);
  }
  for (const Made& made : made_) write_contact(made.contact, made.points);
}

}  // namespace tumble
