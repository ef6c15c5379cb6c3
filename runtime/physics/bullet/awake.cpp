#include "physics/bullet/awake.h"

#include <algorithm>

#include "physics/bullet/joint_part.h"

namespace tumble {

namespace {

bool older(const BodyState* a, const BodyState* b) { return a->serial < b->serial; }

void begin_rest(BodyState& body) {
  body.still_seconds = 0;
  body.still_at = body.center;
}

}  // namespace

void Awake::note(BodyState& body) {
  if (body.changed) return;
  body.changed = true;
  changes_.push_back(&body);
}

void Awake::wake(BodyState& first) {
  if (!first.dynamic() || !first.enabled) return;
  begin_rest(first);
  if (first.active) return;
  std::vector<BodyState*> fresh;
  const auto rouse = [&](BodyState& body) {
    begin_rest(body);
    // Where the step begins for it, if it is woken in the middle of one.
    body.last_good = body.rigid->getWorldTransform();
    body.start_velocity = from_bullet(body.rigid->getLinearVelocity());
    body.start_turning = from_bullet(body.rigid->getAngularVelocity());
    body.active = true;
    body.island = -1;
    bodies_.push_back(&body);
    note(body);
    fresh.push_back(&body);
  };
  rouse(first);
  sorted_ = false;
  while (!fresh.empty()) {
    BodyState& body = *fresh.back();
    fresh.pop_back();
    overlaps_.stir(body);
    for (const JointPart* joint : body.joints)
      for (BodyState* partner : {joint->a, joint->b})
        if (joint->live && partner && partner->dynamic() && partner->enabled && !partner->active) rouse(*partner);
  }
}

void Awake::sleep(BodyState& body) {
  if (!body.awake()) return;
  std::erase(bodies_, &body);
  lay_down(body);
}

void Awake::lay_down(BodyState& body) {
  body.active = false;
  body.rigid->setLinearVelocity({0, 0, 0});
  body.rigid->setAngularVelocity({0, 0, 0});
  body.force = body.torque = {};
  overlaps_.settle(body);
  note(body);
}

void Awake::leave(BodyState& body) {
  if (body.active) std::erase(bodies_, &body);
  if (body.changed) std::erase(changes_, &body);
  body.active = body.changed = false;
}

void Awake::sort() {
  if (!sorted_) std::sort(bodies_.begin(), bodies_.end(), older);
  sorted_ = true;
}

void Awake::settle_restful() {
  std::size_t left = 0;
  for (BodyState* body : bodies_) {
    if (body->island < 0 || restless_[static_cast<std::size_t>(body->island)]) {
      bodies_[left++] = body;
      continue;
    }
    lay_down(*body);
  }
  bodies_.resize(left);
}

std::vector<BodyState*> Awake::take_changes() {
  std::vector<BodyState*> changed;
  for (BodyState* body : std::exchange(changes_, {})) {
    body->changed = false;
    if (body->was_asleep == body->active) changed.push_back(body);
    body->was_asleep = !body->active;
  }
  std::sort(changed.begin(), changed.end(), older);
  return changed;
}

}  // namespace tumble
