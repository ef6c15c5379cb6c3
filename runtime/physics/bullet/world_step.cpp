// One step: what may touch, how it moves, what there is to tell.
#include <ctime>

#include "physics/bullet/impl.h"

namespace tumble {

namespace {

// A body of which no point has moved farther than this, or this part of its size, for so long may sleep. A pendulum
// that turns back moves more; a speed alone would stop it there.
constexpr double kStillWay = 2.5e-3, kStillPart = 0.01;  // m
constexpr double kStillSeconds = 0.5;
// A step longer than this is cut: what may touch is looked for anew. But a step of an hour is not worth an hour's work.
constexpr double kLongestPass = 0.05;  // s
constexpr int kMostPasses = 400;
// A carrier that speeds up evenly does so within a step too: its rider then need not be torn along at each one's start. It
// does where its velocity changes as in the step before, up to this part.
constexpr double kSteady = 0.25;
// Beyond these a state counts as lost: squares in Bullet would become infinite.
constexpr double kFarthest = 1e12, kFastest = 1e12;

double thread_ms() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
}

bool sane(const btVector3& v, double limit) {
  return std::isfinite(v.x()) && std::isfinite(v.y()) && std::isfinite(v.z()) && v.length2() < limit * limit;
}

// Forces that would make it faster than anything in a second, or that are none.
bool driven(const BodyState& body) {
  const auto small = [](Vec3 v) { return std::abs(v.x) < kFastest && std::abs(v.y) < kFastest && std::abs(v.z) < kFastest; };
  const Vec3 i = body.mass.inertia;
  const double least = std::min({i.x, i.y, i.z});
  return small(body.force / body.mass.mass) && (small(body.torque) || small(body.torque / least));
}

// Nothing is near any bound, and none is no number: most bodies, at a glance.
bool plainly_sane(const BodyState& body) {
  constexpr double kFar = 1e6;
  const Vec3 p = body.center.position;
  const Quat q = body.center.rotation;
  const btVector3 &v = body.rigid->getLinearVelocity(), &w = body.rigid->getAngularVelocity();
  const double most = std::abs(p.x) + std::abs(p.y) + std::abs(p.z) + std::abs(v.x()) + std::abs(v.y()) + std::abs(v.z()) + std::abs(w.x()) +
                      std::abs(w.y()) + std::abs(w.z());
  return most < kFar && std::abs(q.x) + std::abs(q.y) + std::abs(q.z) + std::abs(q.w) < kFar && body.force == Vec3{} && body.torque == Vec3{};
}

bool sane(const BodyState& body) {
  if (plainly_sane(body)) return true;
  const Quat q = body.center.rotation;
  return sane(body.rigid->getWorldTransform().getOrigin(), kFarthest) && sane(body.rigid->getLinearVelocity(), kFastest) &&
         sane(body.rigid->getAngularVelocity(), kFastest) && driven(body) &&
         is_finite(q);
}

}  // namespace

void World::step(double seconds) { impl_->step(seconds); }

void World::Impl::step(double seconds) {
  if (!(seconds > 0)) return;
  const double started = thread_ms();
  begin_step(seconds);
  const int passes = static_cast<int>(std::ceil(std::min<double>(kMostPasses, seconds / kLongestPass)));
  if (passes > 1)
    for (BodyState* body : carriers) body->path.ramp = {0, 0, 0};
  const double part = seconds / passes;
  for (int pass = 0; pass < passes; ++pass) {
    collision.look(part, settings.gravity, carriers, *team);
    solver.begin(settings, awake.bodies(), carriers, live, collision, part);
    solver.run(part, settings.least_substeps(), std::max(1, settings.iterations), *team);
    solver.end(part);
    note_joint_forces(seconds, pass == 0);
  }
  end_step(seconds);
  step_ms = thread_ms() - started;
}

void World::Impl::begin_step(double seconds) {
  book.begin_step();
  for (JointPart* joint : live) {
    if (!joint->awake()) continue;
    for (BodyState* body : {joint->a, joint->b})  // one of two that are joined may have been put to sleep alone
      if (body && !body->active) wake(*body);
  }
  awake.sort();
  lose_insane();
  for (BodyState* body : awake.bodies()) {
    body->start_velocity = from_bullet(body->rigid->getLinearVelocity());
    body->start_turning = from_bullet(body->rigid->getAngularVelocity());
    body->last_good = body->rigid->getWorldTransform();
  }
  for (BodyState* body : carriers) {
    Path& path = body->path;
    path.from = body->rigid->getWorldTransform();
    const btVector3 before = path.velocity, change = path.change;
    path.velocity = path.turning = {0, 0, 0};
    if (body->moving) {
      path.velocity = (path.to.getOrigin() - path.from.getOrigin()) / seconds;
      const Quat turn = from_bullet(path.to.getRotation() * path.from.getRotation().inverse());
      const Vec3 half = turn.w < 0 ? Vec3{-turn.x, -turn.y, -turn.z} : Vec3{turn.x, turn.y, turn.z};
      const double sine = length(half);
      if (sine > 1e-15) path.turning = to_bullet(half * (2 * std::atan2(sine, std::abs(turn.w)) / sine / seconds));
      for (JointPart* joint : body->joints)
        for (BodyState* partner : {joint->a, joint->b})
          if (partner) wake(*partner);
    }
    path.change = path.velocity - before;
    const bool steady = body->moving && (path.change - change).length() <= kSteady * path.change.length();
    path.ramp = steady ? path.change : btVector3(0, 0, 0);
    body->rigid->setLinearVelocity(path.velocity);
    body->rigid->setAngularVelocity(path.turning);
    body->start_velocity = from_bullet(path.velocity);
    body->start_turning = from_bullet(path.turning);
  }
}

// Non-finite or beyond all bounds: such a body does not come near others.
void World::Impl::lose_insane() {
  std::vector<BodyState*> bad;
  for (BodyState* body : awake.bodies())
    if (!sane(*body)) bad.push_back(body);
  for (BodyState* body : bad) quarantine(*body);
}

void World::Impl::end_step(double seconds) {
  lose_insane();
  for (BodyState* body : carriers)
    if (body->moving) body->place(body->path.to);
  collision.look_into_triggers(seconds, carriers);
  book.observe(collision);
  book.end_step(seconds, awake.bodies(), carriers, events);
  break_joints();
  awake.sort();  // a joint that broke woke its bodies
  settle(seconds);
  settle_carriers();
  collision.fit_boxes(carriers);  // so that queries find everything where it is now
}

void World::Impl::settle(double seconds) {
  moved.clear();
  for (const BodyState* body : awake.bodies()) moved.push_back(body->id);
  awake.settle(solver.islands(), [&](BodyState& body) {
    body.force = body.torque = {};
    return is_still(body, seconds);
  });
  for (const BodyState* body : awake.take_changes()) events.sleeps.push_back({body->id, !body->active});
}

void World::Impl::settle_carriers() {
  std::erase_if(carriers, [this](BodyState* body) {
    // One more step after the last move, so that its new place is seen by those who sleep there.
    if (std::exchange(body->moving, false)) return false;
    body->active = body->stirred = false;
    overlaps.settle(*body);
    return true;
  });
}

bool World::Impl::is_still(BodyState& body, double seconds) const {
  bool still = settings.sleeping && body.def.can_sleep && keeps_still(body);
  for (const Pair* pair : body.pairs) still = still && (pair->trigger || !(pair->a == &body ? pair->b : pair->a)->has_belt);
  for (const JointPart* joint : body.joints) still = still && !(joint->live && joint->has_motor);
  body.still_seconds = still ? body.still_seconds + seconds : 0;
  return body.still_seconds >= kStillSeconds;
}

bool World::Impl::keeps_still(BodyState& body) const {
  const Pose &now = body.center, &then = body.still_at;
  const Quat turn = now.rotation * conjugate(then.rotation);
  const double way = distance(now.position, then.position) + 2 * length(Vec3{turn.x, turn.y, turn.z}) * body.extent;
  if (way <= std::min(kStillWay, kStillPart * body.extent)) return true;
  body.still_at = now;
  return false;
}

// Means over the step, of which this is a part.
void World::Impl::note_joint_forces(double seconds, bool first) {
  for (JointPart* joint : live) {
    if (!joint->awake()) continue;
    joint->force = (first ? Vec3{} : joint->force) + joint->link.impulse / seconds;
    joint->torque = (first ? Vec3{} : joint->torque) + joint->link.twist / seconds;
  }
}

void World::Impl::break_joints() {
  std::vector<JointPart*> broken;
  for (JointPart* joint : live) {
    if (!joint->awake()) continue;
    if (length(joint->force) > joint->def.break_force || length(joint->torque) > joint->def.break_torque) broken.push_back(joint);
  }
  for (JointPart* joint : broken) {
    joint->broken = true;
    const Vec3 force = joint->force, torque = joint->torque;
    update_live(*joint);
    joint->force = force;
    joint->torque = torque;
    events.breaks.push_back({joint->id});
  }
}

// Back to where it last was well, out of the world, and reported.
void World::Impl::quarantine(BodyState& body) {
  body.rigid->setLinearVelocity({0, 0, 0});
  body.rigid->setAngularVelocity({0, 0, 0});
  body.place(body.last_good);
  body.enabled = false;
  for (JointPart* joint : body.joints) update_live(*joint);
  body.enabled = true;
  leave(body);
  events.lost.push_back(body.id);
}

Events World::take_events() { return std::exchange(impl_->events, {}); }

}  // namespace tumble
