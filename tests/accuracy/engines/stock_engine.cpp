// Debian's Bullet as it comes: its float build, its world, its solver, its defaults.
#include <BulletCollision/CollisionDispatch/btGhostObject.h>

#include <algorithm>
#include <deque>
#include <map>

#include "accuracy/engines/engines.h"
#include "accuracy/engines/stock_joints.h"

namespace tumble::accuracy {

namespace {

class StockWorld final : public btDiscreteDynamicsWorld {
 public:
  using btDiscreteDynamicsWorld::btDiscreteDynamicsWorld;
  // Exactly so many fixed steps: float sums of the time left over would now and then make one more or one less.
  void steps(int count, btScalar seconds) {
    m_localTime = seconds / 2;
    stepSimulation(seconds * static_cast<btScalar>(count), count, seconds);
  }
};

struct StockBody {
  std::unique_ptr<btRigidBody> rigid;        // null where it is a ghost or gone
  std::unique_ptr<btPairCachingGhostObject> ghost;
  BodyDef def;
  Vec3 center;
  bool enabled = true;
  std::vector<int> inside;                   // of a ghost: who was in it after the last step, by age

  btCollisionObject& object() const { return ghost ? static_cast<btCollisionObject&>(*ghost) : *rigid; }
  Pose pose() const { return from_stock(object().getWorldTransform()) * Pose{-center, {}}; }
  btTransform placed(const Pose& pose) const { return to_stock(pose * Pose{center, {}}); }
};

bool is_trigger(const BodyDef& def) { return def.trigger || (!def.colliders.empty() && def.colliders.front().trigger.value_or(false)); }

btVector3 unlocked(const std::string& axes) {
  return {axes.find('x') == std::string::npos ? btScalar(1) : 0, axes.find('y') == std::string::npos ? btScalar(1) : 0,
          axes.find('z') == std::string::npos ? btScalar(1) : 0};
}

class StockSimulation final : public Simulation {
 public:
  StockSimulation(const SceneSettings& settings, const Knobs& knobs) : settings_(settings), substeps_(knobs.substeps) {
    if (settings.threads > 1) throw Missing{"threads"};
    broadphase_.getOverlappingPairCache()->setInternalGhostPairCallback(&ghost_pairs_);
    world_.setGravity(to_stock(settings.gravity));
    world_.getSolverInfo().m_numIterations = knobs.iterations;
    world_.setInternalTickCallback([](btDynamicsWorld* world, btScalar) { static_cast<StockSimulation*>(world->getWorldUserInfo())->note_impulses(); }, this);
  }
  ~StockSimulation() override {
    for (StockJoint& joint : joints_)
      if (joint.constraint) world_.removeConstraint(joint.constraint.get());
    for (StockBody& body : bodies_) leave(body);
  }

  BodyIndex add(const BodyDef& def, const Pose& pose) override {
    bodies_.emplace_back();
    make(static_cast<int>(bodies_.size()) - 1, def, pose);
    enter(bodies_.back());
    return static_cast<int>(bodies_.size()) - 1;
  }
  JointIndex add(const JointSpec& spec) override {
    joints_.emplace_back();
    StockJoint& joint = joints_.back();
    joint.def = spec.def;
    joint.a = spec.a;
    joint.b = spec.b;
    make_constraint(joint, partner(spec.a), partner(spec.b), kStep / substeps_);
    world_.addConstraint(joint.constraint.get(), !spec.def.collide_connected);
    return static_cast<int>(joints_.size()) - 1;
  }
  void remove(BodyIndex index) override {
    StockBody& body = at(index);
    if (!body.rigid && !body.ghost) return;
    for (std::size_t i = 0; i < joints_.size(); ++i)
      if (joints_[i].a == index || joints_[i].b == index) remove_joint(static_cast<int>(i));
    leave(body);
    body.rigid.reset();
    body.ghost.reset();
    body.enabled = false;
  }
  void remove_joint(JointIndex index) override {
    StockJoint& joint = joints_.at(static_cast<std::size_t>(index));
    if (joint.constraint) world_.removeConstraint(joint.constraint.get());
    joint.constraint.reset();
  }
  // As a user of Bullet changes a living body: another shape, mass and material on the same object.
  void configure(BodyIndex index, const BodyDef& def) override {
    StockBody& body = at(index);
    if (!body.rigid || def.type != body.def.type) throw Missing{"a change of a body's type"};
    refuse_unknown(def);
    const Pose pose = body.pose();
    if (!same_shapes(body.def, def)) {
      body.rigid->setCollisionShape(shapes_.of_body(def, body.center));
      body.rigid->setWorldTransform(body.placed(pose));
    }
    const bool regroup = body.enabled && (def.group != body.def.group || def.collides_with != body.def.collides_with);
    if (regroup) leave(body);
    body.def = def;
    if (regroup) enter(body);
    set_mass(body);
    set_options(index);
  }
  void configure_joint(JointIndex index, const JointDef& def) override {
    StockJoint& joint = joints_.at(static_cast<std::size_t>(index));
    joint.def = def;
    accuracy::set_options(joint, kStep / substeps_);
  }
  void set_enabled(BodyIndex index, bool enabled) override {
    StockBody& body = at(index);
    if (enabled == body.enabled) return;
    body.enabled = enabled;
    if (enabled) enter(body);
    else leave(body);
  }
  void set_gravity(Vec3 gravity) override {
    settings_.gravity = gravity;
    world_.setGravity(to_stock(gravity));
  }

  void teleport(BodyIndex index, const Pose& pose) override {
    StockBody& body = at(index);
    const btTransform placed = body.placed(pose);
    body.object().setWorldTransform(placed);
    body.object().setInterpolationWorldTransform(placed);
    if (body.rigid) body.rigid->updateInertiaTensor();
    if (body.enabled) world_.updateSingleAabb(&body.object());
  }
  void move(BodyIndex index, const Pose& pose) override {
    StockBody& body = at(index);
    body.object().setWorldTransform(body.placed(pose));
    if (body.ghost && body.enabled) world_.updateSingleAabb(body.ghost.get());
  }
  void set_velocity(BodyIndex index, Vec3 velocity) override { rigid(index).setLinearVelocity(to_stock(velocity)); }
  void set_angular_velocity(BodyIndex index, Vec3 velocity) override { rigid(index).setAngularVelocity(to_stock(velocity)); }
  void apply_force(BodyIndex index, Vec3 force) override { rigid(index).applyCentralForce(to_stock(force)); }
  void apply_torque(BodyIndex index, Vec3 torque) override { rigid(index).applyTorque(to_stock(torque)); }
  void apply_impulse(BodyIndex index, Vec3 impulse, std::optional<Vec3> point) override {
    btRigidBody& body = rigid(index);
    if (point) body.applyImpulse(to_stock(impulse), to_stock(*point) - body.getCenterOfMassPosition());
    else body.applyCentralImpulse(to_stock(impulse));
  }
  void wake(BodyIndex index) override { rigid(index).activate(true); }

  void step(double seconds) override {
    if (!(seconds > 0)) {
      world_.stepSimulation(static_cast<btScalar>(seconds), substeps_);
      return;
    }
    impulses_.clear();
    for (StockJoint& joint : joints_) before_step(joint, seconds);
    world_.steps(substeps_, static_cast<btScalar>(seconds / substeps_));
    note_crossings();
  }
  // stepSimulation's own clock. It answers with the steps that were due; what is beyond those it may run is lost.
  Frame frame(double seconds) override {
    impulses_.clear();
    for (StockJoint& joint : joints_) before_step(joint, kStep);
    const int most = settings_.most_ticks * substeps_;
    const int due = world_.stepSimulation(static_cast<btScalar>(seconds), most, static_cast<btScalar>(kStep / substeps_));
    note_crossings();
    return {std::min(due, most) / substeps_, std::max(0, due - most) * kStep / substeps_};
  }

  Pose pose(BodyIndex index) const override { return at(index).pose(); }
  Vec3 velocity(BodyIndex index) const override { return from_stock(rigid(index).getLinearVelocity()); }
  Vec3 angular_velocity(BodyIndex index) const override { return from_stock(rigid(index).getAngularVelocity()); }
  bool asleep(BodyIndex index) const override { return !rigid(index).isActive(); }
  bool enabled(BodyIndex index) const override { return at(index).enabled; }
  MassProperties mass_properties(BodyIndex index) const override {
    const btRigidBody& body = rigid(index);
    MassProperties out;
    out.center = at(index).center;
    if (body.getInvMass() == 0) return out;
    out.mass = 1 / static_cast<double>(body.getInvMass());
    const btVector3 inverse = body.getInvInertiaDiagLocal();
    out.inertia = {1 / static_cast<double>(inverse.x()), 1 / static_cast<double>(inverse.y()), 1 / static_cast<double>(inverse.z())};
    return out;
  }
  JointState joint_state(JointIndex index) const override { return state(joints_.at(static_cast<std::size_t>(index))); }
  std::vector<Touch> touches() const override {
    summing_ = true;
    std::map<std::pair<int, int>, Touch> found;
    for (int i = 0; i < dispatcher_.getNumManifolds(); ++i) {
      const btPersistentManifold& manifold = *dispatcher_.getManifoldByIndexInternal(i);
      for (int p = 0; p < manifold.getNumContacts(); ++p) add_point(found, manifold, manifold.getContactPoint(p));
    }
    std::vector<Touch> out;
    for (auto& [pair, touch] : found) {
      const auto sum = impulses_.find(pair);
      if (sum != impulses_.end()) touch.impulse = sum->second;
      out.push_back(touch);
    }
    return out;
  }
  std::vector<Crossing> take_crossings() override { return std::exchange(crossings_, {}); }
  std::optional<RayHit> raycast(Vec3 origin, Vec3 direction, double length) const override {
    const btVector3 from = to_stock(origin), to = to_stock(origin + normalized(direction) * length);
    btCollisionWorld::ClosestRayResultCallback result(from, to);
    world_.rayTest(from, to, result);
    if (!result.hasHit()) return {};
    const Vec3 point = from_stock(result.m_hitPointWorld);
    return RayHit{result.m_collisionObject->getUserIndex(), point, from_stock(result.m_hitNormalWorld), static_cast<double>(result.m_closestHitFraction) * length};
  }
  std::optional<RayHit> cast(const Shape& shape, const Pose& from, Vec3 direction, double length) const override {
    const auto* convex = static_cast<btConvexShape*>(shapes_.convex(shape));
    if (!convex) throw Missing{"casts of this shape"};
    const btTransform start = to_stock(from), end = to_stock(Pose{from.position + normalized(direction) * length, from.rotation});
    btCollisionWorld::ClosestConvexResultCallback result(start.getOrigin(), end.getOrigin());
    world_.convexSweepTest(convex, start, end, result);
    if (!result.hasHit()) return {};
    return RayHit{result.m_hitCollisionObject->getUserIndex(), from_stock(result.m_hitPointWorld), from_stock(result.m_hitNormalWorld),
                  static_cast<double>(result.m_closestHitFraction) * length};
  }
  int contact_points() const override {
    int count = 0;
    for (int i = 0; i < dispatcher_.getNumManifolds(); ++i) count += dispatcher_.getManifoldByIndexInternal(i)->getNumContacts();
    return count;
  }

 private:
  static constexpr double kStep = 1.0 / 60;

  StockBody& at(int index) { return bodies_.at(static_cast<std::size_t>(index)); }
  const StockBody& at(int index) const { return bodies_.at(static_cast<std::size_t>(index)); }
  btRigidBody& rigid(int index) const {
    const StockBody& body = at(index);
    if (!body.rigid) throw Missing{"velocities of a trigger"};
    return *body.rigid;
  }
  StockPartner partner(int index) const { return index == kWorld ? StockPartner{} : StockPartner{&rigid(index), at(index).center}; }

  static bool same_shapes(const BodyDef& a, const BodyDef& b) {
    if (a.colliders.size() != b.colliders.size()) return false;
    for (std::size_t i = 0; i < a.colliders.size(); ++i)
      if (!(a.colliders[i].shape == b.colliders[i].shape) || !(a.colliders[i].offset == b.colliders[i].offset)) return false;
    return true;
  }

  static void refuse_unknown(const BodyDef& def) {
    if (!(def.surface_velocity == Vec3{})) throw Missing{"surface velocity"};
  }

  void make(int index, const BodyDef& def, const Pose& pose) {
    StockBody& body = at(index);
    body.def = def;
    refuse_unknown(def);
    btCollisionShape* shape = shapes_.of_body(def, body.center);
    if (is_trigger(def)) {
      body.ghost = std::make_unique<btPairCachingGhostObject>();
      body.ghost->setCollisionShape(shape);
      body.ghost->setCollisionFlags(body.ghost->getCollisionFlags() | btCollisionObject::CF_NO_CONTACT_RESPONSE);
      body.ghost->setWorldTransform(body.placed(pose));
      body.ghost->setUserIndex(index);
      return;
    }
    body.rigid = std::make_unique<btRigidBody>(btRigidBody::btRigidBodyConstructionInfo(0, nullptr, shape));
    body.rigid->setUserIndex(index);
    body.rigid->setWorldTransform(body.placed(pose));
    body.rigid->setInterpolationWorldTransform(body.placed(pose));
    set_mass(body);
    set_options(index);
    body.rigid->setLinearVelocity(to_stock(def.velocity));
    body.rigid->setAngularVelocity(to_stock(def.angular_velocity));
  }

  void set_mass(StockBody& body) {
    if (body.def.type != BodyType::dynamic) return;
    const btScalar mass = static_cast<btScalar>(body.def.mass.value_or(1));
    bool dense = body.def.density.has_value();
    for (const ColliderDef& c : body.def.colliders) dense |= c.density.has_value();
    if (!body.def.mass && dense) throw Missing{"density in the suite's stock engine"};
    btVector3 inertia(0, 0, 0);
    body.rigid->getCollisionShape()->calculateLocalInertia(mass, inertia);
    if (body.def.inertia) inertia = to_stock(*body.def.inertia);
    body.rigid->setMassProps(mass, inertia);
    body.rigid->updateInertiaTensor();
  }

  void set_options(int index) {
    StockBody& body = at(index);
    btRigidBody& rigid = *body.rigid;
    const BodyDef& def = body.def;
    rigid.setFriction(static_cast<btScalar>(def.friction.value_or(0.5)));
    rigid.setRollingFriction(static_cast<btScalar>(def.rolling_friction));
    rigid.setSpinningFriction(static_cast<btScalar>(def.spinning_friction));
    rigid.setRestitution(static_cast<btScalar>(def.restitution.value_or(0)));
    // Bullet's damping d is what is lost in a second: v(t) = v0 (1 - d)^t.
    rigid.setDamping(static_cast<btScalar>(1 - std::exp(-def.damping)), static_cast<btScalar>(1 - std::exp(-def.angular_damping)));
    rigid.setLinearFactor(unlocked(def.lock_position));
    rigid.setAngularFactor(unlocked(def.lock_rotation) * to_stock(def.rotation_factor));
    if (def.type == BodyType::kinematic) rigid.setCollisionFlags(rigid.getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
    if (def.type == BodyType::kinematic || (def.type == BodyType::dynamic && (!settings_.sleeping || !def.can_sleep))) rigid.setActivationState(DISABLE_DEACTIVATION);
    if (def.continuous.value_or(false)) {
      const auto radius = static_cast<btScalar>(StockShapes::inner_radius(def));
      rigid.setCcdMotionThreshold(radius);
      rigid.setCcdSweptSphereRadius(radius * btScalar(0.9));
    }
    if (def.gravity_factor != 1) {
      rigid.setFlags(rigid.getFlags() | BT_DISABLE_WORLD_GRAVITY);
      rigid.setGravity(to_stock(settings_.gravity * def.gravity_factor));
    }
  }

  void enter(StockBody& body) {
    const BodyDef& def = body.def;
    int mask = def.collides_with.empty() ? btBroadphaseProxy::AllFilter : 0;
    for (const std::string& name : def.collides_with) mask |= group_bits(name);
    if (body.ghost) world_.addCollisionObject(body.ghost.get(), btBroadphaseProxy::SensorTrigger, mask ^ (mask & btBroadphaseProxy::StaticFilter));
    else if (def.group.empty() && def.collides_with.empty()) world_.addRigidBody(body.rigid.get());
    else world_.addRigidBody(body.rigid.get(), def.group.empty() ? btBroadphaseProxy::DefaultFilter : group_bits(def.group), mask);
  }
  // The default group is that of Bullet's static and kinematic bodies too.
  int group_bits(const std::string& name) {
    if (name.empty()) return btBroadphaseProxy::DefaultFilter | btBroadphaseProxy::StaticFilter | btBroadphaseProxy::KinematicFilter;
    const auto at = std::find(groups_.begin(), groups_.end(), name) - groups_.begin();
    if (at == static_cast<std::ptrdiff_t>(groups_.size())) groups_.push_back(name);
    return 64 << at;  // Bullet's own are the six below
  }
  void leave(StockBody& body) {
    if (body.ghost) world_.removeCollisionObject(body.ghost.get());
    else if (body.rigid) world_.removeRigidBody(body.rigid.get());
  }

  void note_crossings() {
    for (int i = 0; i < static_cast<int>(bodies_.size()); ++i)
      if (bodies_[static_cast<std::size_t>(i)].ghost) note_crossings(i);
  }
  void note_crossings(int trigger) {
    StockBody& body = at(trigger);
    std::vector<int> inside;
    for (int i = 0; i < body.ghost->getNumOverlappingObjects(); ++i) inside.push_back(body.ghost->getOverlappingObject(i)->getUserIndex());
    std::sort(inside.begin(), inside.end());
    for (const int other : body.inside)
      if (!std::binary_search(inside.begin(), inside.end(), other)) crossings_.push_back({trigger, other, false, {}});
    for (const int other : inside)
      if (!std::binary_search(body.inside.begin(), body.inside.end(), other)) crossings_.push_back({trigger, other, true, {}});
    body.inside = std::move(inside);
  }

  // Bullet keeps only the last substep's impulses.
  void note_impulses() {
    if (!summing_ || substeps_ == 1) return;
    for (int i = 0; i < dispatcher_.getNumManifolds(); ++i) {
      const btPersistentManifold& manifold = *dispatcher_.getManifoldByIndexInternal(i);
      for (int p = 0; p < manifold.getNumContacts(); ++p) impulses_[pair_of(manifold)] += manifold.getContactPoint(p).getAppliedImpulse();
    }
  }

  static std::pair<int, int> pair_of(const btPersistentManifold& manifold) {
    const int a = manifold.getBody0()->getUserIndex(), b = manifold.getBody1()->getUserIndex();
    return {std::min(a, b), std::max(a, b)};
  }

  static void add_point(std::map<std::pair<int, int>, Touch>& found, const btPersistentManifold& manifold, const btManifoldPoint& point) {
    if (point.getDistance() > 0 && point.getAppliedImpulse() == 0) return;
    const std::pair<int, int> pair = pair_of(manifold);
    Touch& touch = found[pair];
    touch.a = pair.first;
    touch.b = pair.second;
    touch.point = from_stock(point.getPositionWorldOnB());
    // Bullet's normal is that of its second body, towards the first.
    const double sign = manifold.getBody1()->getUserIndex() == touch.a ? 1 : -1;
    touch.normal = from_stock(point.m_normalWorldOnB) * sign;
    touch.impulse += point.getAppliedImpulse();
    ++touch.points;
  }

  SceneSettings settings_;
  int substeps_;
  mutable StockShapes shapes_;
  btDefaultCollisionConfiguration configuration_;
  mutable btCollisionDispatcher dispatcher_{&configuration_};
  btGhostPairCallback ghost_pairs_;
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  StockWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
  std::vector<StockBody> bodies_;
  std::vector<std::string> groups_;
  std::deque<StockJoint> joints_;  // they do not move: Bullet points to their feedback
  std::vector<Crossing> crossings_;
  std::map<std::pair<int, int>, double> impulses_;
  mutable bool summing_ = false;
};

}  // namespace

std::unique_ptr<Simulation> make_stock(const SceneSettings& settings, const Knobs& knobs) { return std::make_unique<StockSimulation>(settings, knobs); }

}  // namespace tumble::accuracy
