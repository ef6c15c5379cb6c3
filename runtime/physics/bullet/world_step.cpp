// One step: our own loop of substeps around Bullet's collision detection and solver.
#include <ctime>

#include "physics/bullet/impl.h"
#include "physics/dynamics/rotation.h"

namespace tumble {

namespace {

// Slower than this, its outermost point counted, for so long: it may sleep.
constexpr double kStillSpeed = 0.05;    // m/s
constexpr double kStillSeconds = 0.5;
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

bool sane(const BodyState& body) {
  const btQuaternion q = body.rigid->getWorldTransform().getRotation();
  return sane(body.rigid->getWorldTransform().getOrigin(), kFarthest) && sane(body.rigid->getLinearVelocity(), kFastest) &&
         sane(body.rigid->getAngularVelocity(), kFastest) && std::isfinite(q.x() + q.y() + q.z() + q.w());
}

// v after h under a constant acceleration and damping k: exact.
btVector3 after(const btVector3& v, const btVector3& acceleration, double k, double h) {
  if (k <= 0) return v + acceleration * h;
  return v * std::exp(-k * h) + acceleration * (-std::expm1(-k * h) / k);
}

// Along a kinematic path, at a part from 0 to 1 of it.
btTransform along(const Path& path, double seconds) {
  const btVector3 turn = path.turning * seconds;
  const double angle = turn.length();
  btQuaternion rotation = path.from.getRotation();
  if (angle > 1e-15) rotation = btQuaternion(turn / angle, angle) * rotation;
  return btTransform(rotation.normalized(), path.from.getOrigin() + path.velocity * seconds);
}

}  // namespace

void World::step(double seconds) { impl_->step(seconds); }

void World::Impl::step(double seconds) {
  if (!(seconds > 0)) return;
  const double started = thread_ms();
  begin_step(seconds);
  const int count = std::max(1, settings.substeps);
  const double h = seconds / count;
  for (int i = 0; i < count; ++i) {
    begin_substep(h, i * h);
    bullet.substep(h);
    ++substeps_done;
    book.observe(dispatcher, substeps_done);
    bullet.end_substep();
    end_substep(h, (i + 1) * h);
  }
  end_step(seconds);
  step_ms = thread_ms() - started;
}

void World::Impl::begin_step(double seconds) {
  book.begin_step();
  for (BodyState* body : dynamics) {
    body->start_velocity = from_bullet(body->rigid->getLinearVelocity());
    body->start_turning = from_bullet(body->rigid->getAngularVelocity());
    if (body->rigid->isActive()) body->last_good = body->rigid->getWorldTransform();
  }
  for (BodyState* body : carriers) {
    Path& path = body->path;
    path.from = body->rigid->getWorldTransform();
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
    body->rigid->setLinearVelocity(path.velocity);
    body->rigid->setAngularVelocity(path.turning);
    body->start_velocity = from_bullet(path.velocity);
    body->start_turning = from_bullet(path.turning);
  }
  for (JointPart* joint : live) joint->impulse = joint->twist = {};
}

void World::Impl::begin_substep(double h, double done) {
  for (BodyState* body : carriers) carry(*body, done);
  for (JointPart* joint : live) {
    joint->seconds = h;
    if (!joint->awake()) continue;
    joint->feedback = {};
    apply_springs(*joint);
  }
  std::vector<BodyState*> bad;
  for (BodyState* body : dynamics) {
    push(*body, h);
    if (body->rigid->isActive() && !sane(*body)) bad.push_back(body);
  }
  for (BodyState* body : bad) quarantine(*body);
}

void World::Impl::push(BodyState& body, double h) {
  btRigidBody& rigid = *body.rigid;
  if (!rigid.isActive()) {
    rigid.setLinearVelocity({0, 0, 0});
    rigid.setAngularVelocity({0, 0, 0});
    return;
  }
  body.free_velocity = rigid.getLinearVelocity();
  const Vec3 pull = settings.gravity * body.def.gravity_factor + body.force / body.mass.mass;
  rigid.setLinearVelocity(after(body.free_velocity, to_bullet(pull), body.def.damping, h) * rigid.getLinearFactor());
  const btVector3 spin_up = rigid.getInvInertiaTensorWorld() * to_bullet(body.torque) * rigid.getAngularFactor();
  btVector3 spin = after(rigid.getAngularVelocity(), spin_up, body.def.angular_damping, h);
  for (int i = 0; i < 3; ++i)
    if (rigid.getAngularFactor()[i] == 0) spin[i] = 0;
  rigid.setAngularVelocity(spin);
}

void World::Impl::carry(BodyState& body, double done) {
  if (!body.moving) return;
  body.place(along(body.path, done));
}

void World::Impl::end_substep(double h, double done) {
  for (BodyState* body : carriers) carry(*body, done);
  for (BodyState* body : dynamics) {
    if (!body->rigid->isActive()) continue;
    // In free flight the way is that of the mean velocity; Bullet took the last one.
    if (body->touched_substep != substeps_done && body->joints.empty()) {
      btTransform at = body->rigid->getWorldTransform();
      at.getOrigin() += (body->free_velocity - body->rigid->getLinearVelocity()) * body->rigid->getLinearFactor() * (h / 2);
      body->rigid->setWorldTransform(at);
    }
    turn(*body, h);
    if (body->ghost) {
      body->ghost->setWorldTransform(body->rigid->getWorldTransform());
      body->ghost->forceActivationState(ACTIVE_TAG);
    }
  }
  for (JointPart* joint : live)
    if (joint->awake()) collect(*joint);
}

// In place of Bullet's turn, which cuts fast spins and damps the gyroscopic moment. A body that Bullet stopped on its way
// because it was too fast for what it met keeps the pose in which it was stopped.
void World::Impl::turn(BodyState& body, double h) {
  btRigidBody& rigid = *body.rigid;
  const double sweep = rigid.getCcdSquareMotionThreshold();
  if (sweep > 0 && (rigid.getLinearVelocity() * h).length2() > sweep && rigid.getHitFraction() < 1) return;
  Quat rotation = body.rotation_before;
  Vec3 spin = from_bullet(rigid.getAngularVelocity());
  const Vec3 factor = from_bullet(rigid.getAngularFactor());
  if (factor == Vec3{1, 1, 1}) dynamics::turn(rotation, spin, body.mass.inertia, h);
  else rotation = dynamics::turned_by(rotation, spin * h);  // a bearing takes the gyroscopic moment
  rigid.setCenterOfMassTransform(btTransform(to_bullet(rotation), rigid.getWorldTransform().getOrigin()));
  rigid.setAngularVelocity(to_bullet(spin));
}

void World::Impl::end_step(double seconds) {
  std::vector<BodyState*> bad;
  for (BodyState* body : dynamics)
    if (body->rigid->isActive() && !sane(*body)) bad.push_back(body);
  for (BodyState* body : bad) quarantine(*body);

  book.end_step(events);
  break_joints(seconds);
  moved.clear();
  for (BodyState* body : dynamics) rest(*body, seconds);
  std::erase_if(carriers, [](BodyState* body) {
    // One more step after the last move, so that its new place is seen by those who sleep there.
    const bool keep = body->moving;
    if (body->moving) body->place(body->path.to);
    body->moving = false;
    if (keep) return false;
    body->rigid->forceActivationState(ISLAND_SLEEPING);
    if (body->ghost) body->ghost->forceActivationState(ISLAND_SLEEPING);
    return true;
  });
  bullet.updateAabbs();  // so that queries find everything where it is now
}

void World::Impl::rest(BodyState& body, double seconds) {
  btRigidBody& rigid = *body.rigid;
  body.force = body.torque = {};
  const bool asleep = !rigid.isActive();
  if (asleep != body.was_asleep) {
    body.was_asleep = asleep;
    events.sleeps.push_back({body.id, asleep});
    if (body.ghost && asleep) body.ghost->forceActivationState(ISLAND_SLEEPING);
  }
  if (asleep) return;
  moved.push_back(body.id);

  const double speed = rigid.getLinearVelocity().length() + rigid.getAngularVelocity().length() * body.extent;
  bool still = settings.sleeping && body.def.can_sleep && speed < kStillSpeed;
  for (const JointPart* joint : body.joints) still = still && !(joint->live && joint->has_motor);
  body.still_seconds = still ? body.still_seconds + seconds : 0;
  rigid.setActivationState(body.still_seconds >= kStillSeconds ? WANTS_DEACTIVATION : ACTIVE_TAG);
}

void World::Impl::break_joints(double seconds) {
  std::vector<JointPart*> broken;
  for (JointPart* joint : live) {
    if (!joint->awake()) continue;
    joint->force = joint->impulse / seconds;
    joint->torque = joint->twist / seconds;
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
