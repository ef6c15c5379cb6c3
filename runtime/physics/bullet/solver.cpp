#include "physics/bullet/solver.h"

#include <algorithm>

#include "physics/world.h"

namespace tumble {

namespace {

using dynamics::Contact;
using dynamics::Mechanism;
using dynamics::Mover;
using dynamics::reciprocal;

}  // namespace

// ---- bodies

Mover& Solver::add_mover(BodyState& body) {
  movers_.emplace_back();
  bodies_.push_back(&body);
  Mover& mover = movers_.back();
  mover.position = body.center.position;
  mover.rotation = body.center.rotation;
  mover.velocity = from_bullet(body.rigid->getLinearVelocity());
  mover.spin = from_bullet(body.rigid->getAngularVelocity());
  body.mover = &mover;
  return mover;
}

Mover& Solver::mover_of(const BodyState* body) { return body && body->mover ? *body->mover : movers_.front(); }

void Solver::gather_bodies(const WorldSettings& settings, const std::vector<BodyState*>& awake, const std::vector<BodyState*>& carriers,
                           double seconds) {
  for (BodyState* body : awake) {
    Mover& mover = add_mover(*body);
    mover.pushable = true;
    mover.inverse_mass = from_bullet(body->rigid->getLinearFactor()) * reciprocal(body->mass.mass);
    mover.inertia = body->mass.inertia;
    mover.turn_factor = from_bullet(body->rigid->getAngularFactor());
    mover.acceleration = settings.gravity * body->def.gravity_factor + body->force * reciprocal(body->mass.mass);
    mover.torque = body->torque;
    mover.damping = body->def.damping;
    mover.angular_damping = body->def.angular_damping;
  }
  for (BodyState* body : carriers) {
    Mover& mover = add_mover(*body);
    mover.acceleration = from_bullet(body->path.ramp) / seconds;
  }
}

// ---- joints

// Joints that share bodies, over any number of others; in the order of their first ones.
void Solver::find_mechanisms(const std::vector<JointPart*>& live) {
  std::map<const BodyState*, std::size_t> joint_at;  // looked up, never walked through
  std::vector<std::size_t> parent(live.size());      // the root of a set is its smallest
  const auto root = [&](std::size_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (std::size_t i = 0; i < live.size(); ++i) {
    parent[i] = i;
    for (const BodyState* body : {live[i]->a, live[i]->b}) {
      if (!body || !body->dynamic()) continue;
      const auto [at, fresh] = joint_at.emplace(body, i);
      if (fresh) continue;
      const std::size_t x = root(i), y = root(at->second);
      parent[std::max(x, y)] = std::min(x, y);
    }
  }
  std::vector<std::vector<dynamics::Link*>> groups(live.size());
  for (std::size_t i = 0; i < live.size(); ++i) groups[root(i)].push_back(&live[i]->link);
  mechanisms_.clear();
  for (const auto& links : groups)
    if (!links.empty()) mechanisms_.push_back(std::make_unique<Mechanism>(links));
  mechanisms_known_ = true;
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

void Solver::begin(const WorldSettings& settings, const std::vector<BodyState*>& awake, const std::vector<BodyState*>& carriers,
                   const std::vector<JointPart*>& live, Collision& collision, double seconds) {
  movers_.clear();
  bodies_.clear();
  awake_.clear();
  movers_.emplace_back();  // what cannot move
  if (!mechanisms_known_) find_mechanisms(live);
  gather_bodies(settings, awake, carriers, seconds);
  for (JointPart* joint : live) joint->link.a = joint->link.b = nullptr;
  if (!live.empty()) gather_mechanisms(live);
  contacts_.gather(collision, movers_, seconds);
  islands_ = dynamics::find_islands(movers_, contacts_.list(), awake_);
  contacts_.each_chase([&](Contact& contact, Chase& chase) {
    islands_[static_cast<std::size_t>(contact.island())].looks.emplace_back([&](double h) { chase.look(contact, h); });
  });
}

void Solver::run(double seconds, int least, int rounds, Team& team) {
  constexpr std::size_t kIslands = 8;  // that are worth handing to another thread
  most_substeps_ = 0;
  small_.clear();
  for (dynamics::Island& island : islands_) {
    if (!dynamics::is_heap(island)) {
      small_.push_back(&island);
      continue;
    }
    const int count = dynamics::substeps_of(island, seconds, least);
    most_substeps_ = std::max(most_substeps_, count);
    if (!heaps_[count]) heaps_[count] = std::make_unique<dynamics::Heap>();
    heaps_[count]->add(island);
  }
  substeps_.assign(small_.size(), 0);
  team.each(small_.size(), kIslands, [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) substeps_[i] = dynamics::run(*small_[i], seconds, least, rounds);
  });
  for (const int count : substeps_) most_substeps_ = std::max(most_substeps_, count);
  for (auto& [count, heap] : heaps_) heap->run(seconds, count, rounds, team);
}

// ---- back

void Solver::end(double seconds) {
  contacts_.write_back(movers_);
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    BodyState& body = *bodies_[i];
    Mover& mover = movers_[i + 1];
    body.mover = nullptr;
    if (!mover.pushable) {
      if (mover.velocity == Vec3{} && mover.spin == Vec3{}) continue;
      drift(mover, seconds);  // islands moved copies of it
    }
    if (!mover.pushable) {
      body.place(to_bullet(Pose{mover.position, mover.rotation}));
      continue;
    }
    body.go({mover.position, mover.rotation});
    body.in_heap = mover.record > 0;
    body.island = mover.island;
    body.rigid->setLinearVelocity(to_bullet(mover.velocity));
    body.rigid->setAngularVelocity(to_bullet(mover.spin));
  }
}

}  // namespace tumble
