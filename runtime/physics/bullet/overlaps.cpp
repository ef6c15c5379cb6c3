#include "physics/bullet/overlaps.h"

#include <algorithm>

#include "physics/bullet/joint_part.h"

namespace tumble {

namespace {

bool agree(const BodyState& a, const BodyState& b) { return (a.group & b.mask) && (b.group & a.mask); }

bool joined_apart(const BodyState& a, const BodyState& b) {
  for (const JointPart* joint : a.joints)
    if (joint->live && !joint->def.collide_connected && (joint->a == &b || joint->b == &b)) return true;
  return false;
}

bool may_meet(const Occupant& one, const Occupant& other) {
  const BodyState &a = *one.body, &b = *other.body;
  if (&a == &b || !agree(a, b) || (one.triggers && other.triggers)) return false;
  if (one.triggers) return b.def.type != BodyType::fixed;
  if (other.triggers) return a.def.type != BodyType::fixed;
  return (a.dynamic() || b.dynamic()) && !joined_apart(a, b);
}

bool is_active(const Occupant& occupant) { return occupant.body->active || (occupant.triggers && occupant.body->stirred); }

// The older body first, so that a pair is the same whichever moved into the other's box.
bool comes_first(const Occupant& a, const Occupant& b) { return a.body->serial < b.body->serial; }

}  // namespace

Overlaps::~Overlaps() {
  each([this](Overlap& overlap) { drop(overlap); });
}

void Overlaps::set_box(Occupant& occupant, const btDbvtVolume& box) {
  if (!occupant.leaf) {
    triggers_ += occupant.triggers;
    occupant.fixed = occupant.body->def.type == BodyType::fixed;
    boxes_.add(occupant, box);
    meet(occupant, nullptr);
    return;
  }
  const btDbvtVolume before = occupant.box();
  boxes_.move(occupant, box);
  for (std::size_t i = occupant.overlaps.size(); i-- > 0;) {
    Overlap& overlap = *occupant.overlaps[i];
    const Occupant& other = overlap.a == &occupant ? *overlap.b : *overlap.a;
    if (!Intersect(occupant.box(), other.box())) drop(overlap);
  }
  meet(occupant, &before);
}

void Overlaps::leave(Occupant& occupant) {
  if (!occupant.leaf) return;
  while (!occupant.overlaps.empty()) drop(*occupant.overlaps.back());
  boxes_.remove(occupant);
  triggers_ -= occupant.triggers;
}

void Overlaps::renew(Occupant& occupant) {
  if (!occupant.leaf) return;
  while (!occupant.overlaps.empty()) drop(*occupant.overlaps.back());
  meet(occupant, nullptr);
}

void Overlaps::renew(BodyState& a, BodyState& b) {
  for (Occupant* one : {&a.solid_box, &a.trigger_box}) {
    if (!one->leaf) continue;
    for (std::size_t i = one->overlaps.size(); i-- > 0;) {
      Overlap& overlap = *one->overlaps[i];
      if ((overlap.a == one ? overlap.b : overlap.a)->body == &b) drop(overlap);
    }
    for (Occupant* other : {&b.solid_box, &b.trigger_box})
      if (other->leaf && Intersect(one->box(), other->box()) && may_meet(*one, *other)) add(*one, *other);
  }
}

// Whose box it meets now, and did not meet before.
void Overlaps::meet(Occupant& occupant, const btDbvtVolume* before) {
  boxes_.each_in(occupant.box(), !occupant.fixed, [&](Occupant& other) {
    if (before && Intersect(*before, other.box())) return;
    if (may_meet(occupant, other)) add(occupant, other);
  });
}

void Overlaps::meet_missing(Occupant& occupant) {
  if (!occupant.leaf) return;
  std::vector<const Occupant*> known;
  for (const Overlap* overlap : occupant.overlaps) known.push_back(overlap->a == &occupant ? overlap->b : overlap->a);
  std::sort(known.begin(), known.end());
  boxes_.each_in(occupant.box(), !occupant.fixed, [&](Occupant& other) {
    if (!std::binary_search(known.begin(), known.end(), &other) && may_meet(occupant, other)) add(occupant, other);
  });
}

void Overlaps::add(Occupant& one, Occupant& other) {
  if (count() >= kMost) {
    left_out_ = lacking_ = true;
    return;
  }
  if (unused_.empty()) unused_.push_back(&all_.emplace_back());
  Overlap& overlap = *unused_.back();
  unused_.pop_back();
  overlap.a = comes_first(one, other) ? &one : &other;
  overlap.b = overlap.a == &one ? &other : &one;
  overlap.at_a = static_cast<std::uint32_t>(overlap.a->overlaps.size());
  overlap.at_b = static_cast<std::uint32_t>(overlap.b->overlaps.size());
  overlap.a->overlaps.push_back(&overlap);
  overlap.b->overlaps.push_back(&overlap);
  BodyState &a = *overlap.a->body, &b = *overlap.b->body;
  overlap.kind = one.triggers || other.triggers ? Overlap::triggers : a.is_convex && b.is_convex ? Overlap::bodies : Overlap::solids;
  if (overlap.kind == Overlap::bodies) overlap.pair.emplace(a, b, found);
  if (is_active(one) || is_active(other)) activate(overlap);
}

void Overlaps::drop(Overlap& overlap) {
  deactivate(overlap);
  overlap.pair.reset();
  if (overlap.algorithm) {
    overlap.algorithm->~btCollisionAlgorithm();
    dispatcher_.freeCollisionAlgorithm(overlap.algorithm);
    overlap.algorithm = nullptr;
  }
  for (Occupant* side : {overlap.a, overlap.b}) {
    const std::uint32_t at = side == overlap.a ? overlap.at_a : overlap.at_b;
    Overlap& last = *side->overlaps.back();
    (last.a == side ? last.at_a : last.at_b) = at;
    side->overlaps[at] = &last;
    side->overlaps.pop_back();
  }
  overlap.a = overlap.b = nullptr;
  unused_.push_back(&overlap);
}

void Overlaps::activate(Overlap& overlap) {
  if (overlap.place != Overlap::kNowhere) return;
  std::vector<Overlap*>& list = active_[overlap.kind];
  overlap.place = static_cast<std::uint32_t>(list.size());
  list.push_back(&overlap);
}

void Overlaps::deactivate(Overlap& overlap) {
  if (overlap.place == Overlap::kNowhere) return;
  std::vector<Overlap*>& list = active_[overlap.kind];
  list[overlap.place] = list.back();
  list[overlap.place]->place = overlap.place;
  list.pop_back();
  overlap.place = Overlap::kNowhere;
}

void Overlaps::stir(BodyState& body) {
  for (Occupant* occupant : {&body.solid_box, &body.trigger_box}) {
    if (!is_active(*occupant)) continue;
    if (lacking_) meet_missing(*occupant);  // it may have slept while there was room again
    for (Overlap* overlap : occupant->overlaps) activate(*overlap);
  }
}

void Overlaps::settle(BodyState& body) {
  for (Occupant* occupant : {&body.solid_box, &body.trigger_box})
    for (Overlap* overlap : occupant->overlaps)
      if (!is_active(*overlap->a) && !is_active(*overlap->b)) deactivate(*overlap);
}

}  // namespace tumble
