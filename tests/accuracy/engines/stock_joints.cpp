#include "accuracy/engines/stock_joints.h"

#include "accuracy/case.h"

namespace tumble::accuracy {

namespace {

btScalar number(double x) { return x > 1e18 ? btScalar(1e18) : static_cast<btScalar>(x); }

// A frame whose x is the axis.
Quat along(Vec3 axis) {
  const Vec3 x = normalized(axis);
  const Vec3 y = normalized(cross(std::abs(x.y) < 0.9 ? Vec3{0, 1, 0} : Vec3{0, 0, 1}, x)), z = cross(x, y);
  const double trace = x.x + y.y + z.z;
  Quat q{y.z - z.y, z.x - x.z, x.y - y.x, 1 + trace};
  if (trace < -0.999) q = std::abs(x.x) > 0.5 ? Quat{1, 0, 0, 0} : Quat{0, 0, 1, 0};
  return normalized(q);
}

// Bullet's hinge turns about z, its slider along x.
const Quat kFromXToZ{0, -0.70710678118654752, 0, 0.70710678118654752};

struct Frames {
  btTransform a, b;
};

bool is_turn(const JointDef& def) { return std::holds_alternative<HingeDef>(def.kind); }

// The runtime's own function for this lies in a library that this one must not link.
template <class Def>
Freedom plain(const Def& def) {
  Freedom out{def.min, def.max, {}, {}, def.friction};
  if (def.motor) out.motor = *def.motor;
  if (def.spring) out.spring = *def.spring;
  return out;
}

std::optional<Freedom> freedom_of(const JointDef& def) {
  if (const auto* hinge = std::get_if<HingeDef>(&def.kind)) return plain(hinge->angle);
  if (const auto* slider = std::get_if<SliderDef>(&def.kind)) return plain(slider->position);
  return {};
}

btTypedConstraint* with_spring(btRigidBody& b, btRigidBody& a, const Frames& frames, const JointDef& def, const Freedom& f) {
  auto* joint = new btGeneric6DofSpring2Constraint(b, a, frames.b, frames.a);
  const int index = is_turn(def) ? 3 : 0;
  const double sign = is_turn(def) ? -1 : 1;  // its angles count the other way round
  for (int i = 0; i < 6; ++i) joint->setLimit(i, 0, 0);
  if (f.min && f.max) joint->setLimit(index, number(sign > 0 ? *f.min : -*f.max), number(sign > 0 ? *f.max : -*f.min));
  else joint->setLimit(index, 1, -1);
  // As heavy as the bodies are along that freedom, as the runtime means it.
  double inverse = 0;
  for (const btRigidBody* body : {&a, &b}) {
    if (body->getInvMass() == 0) continue;
    const btVector3 axis = (body == &a ? body->getWorldTransform().getBasis() * frames.a.getBasis() : body->getWorldTransform().getBasis() * frames.b.getBasis()).getColumn(0);
    if (is_turn(def)) {
      // About the anchor rather than the centre of mass, as the joint holds the anchor.
      const btVector3 arm = body == &a ? frames.a.getOrigin() : frames.b.getOrigin();
      const btVector3 world_arm = body->getWorldTransform().getBasis() * arm;
      const double own = axis.dot(body->getInvInertiaTensorWorld().inverse() * axis);
      inverse += 1 / (own + (world_arm - axis * axis.dot(world_arm)).length2() / body->getInvMass());
    } else {
      inverse += body->getInvMass();
    }
  }
  const double omega = 2 * kPi * f.spring->frequency, heavy = inverse > 0 ? 1 / inverse : 0;
  joint->enableSpring(index, true);
  joint->setStiffness(index, number(heavy * omega * omega), false);
  joint->setDamping(index, number(2 * f.spring->damping * omega * heavy), false);
  joint->setEquilibriumPoint(index, number(sign * f.spring->rest));
  return joint;
}

template <class Def>
bool is_free(const Def& def) {
  bool limited = def.max.has_value();
  if constexpr (requires { def.min; }) limited |= def.min.has_value();
  return !limited && !def.motor && !def.spring && def.friction == 0;
}

btTypedConstraint* with_cone(btRigidBody& b, btRigidBody& a, const Frames& frames, const RagdollDef& def) {
  SwingDef swing_a = def.swing_a, swing_b = def.swing_b;
  swing_a.max.reset();
  swing_b.max.reset();
  if (def.swing_axis || !is_free(swing_a) || !is_free(swing_b) || !is_free(def.twist)) throw Missing{"a driven ragdoll joint, or one with twist limits"};
  auto* joint = new btConeTwistConstraint(b, a, frames.b, frames.a);
  joint->setLimit(number(def.swing_b.max.value_or(kPi)), number(def.swing_a.max.value_or(kPi)), number(kPi));
  return joint;
}

}  // namespace

void make_constraint(StockJoint& joint, const StockPartner& a, const StockPartner& b, double substep) {
  const JointDef& def = joint.def;
  if (def.break_torque < kInfinity) throw Missing{"a break torque"};
  if (const auto* ball = std::get_if<BallDef>(&def.kind); ball && ball->friction > 0) throw Missing{"joint friction"};
  btRigidBody& first = b.body ? *b.body : btTypedConstraint::getFixedBody();
  btRigidBody& second = a.body ? *a.body : btTypedConstraint::getFixedBody();
  const auto placed = [](const StockPartner& p) { return p.body ? from_stock(p.body->getWorldTransform()) : Pose{}; };
  const Pose world = (a.body ? placed(a) * Pose{def.anchor - a.center, {}} : Pose{def.anchor, {}}) * Pose{{}, along(def.axis)};
  joint.anchor_a = def.anchor - (a.body ? a.center : Vec3{});
  const auto frame = [&](const Pose& turned) { return Frames{to_stock(inverse(placed(a)) * turned), to_stock(inverse(placed(b)) * turned)}; };

  btTypedConstraint* made = nullptr;
  const std::optional<Freedom> f = freedom_of(def);
  if (f && f->spring && f->spring->frequency > 0) {
    made = with_spring(first, second, frame(world), def, *f);
  } else if (std::holds_alternative<HingeDef>(def.kind)) {
    const Frames frames = frame(world * Pose{{}, kFromXToZ});
    made = new btHingeConstraint(first, second, frames.b, frames.a);
  } else if (std::holds_alternative<SliderDef>(def.kind)) {
    const Frames frames = frame(world);
    auto* slider = new btSliderConstraint(first, second, frames.b, frames.a, true);
    slider->setLowerLinLimit(1);
    slider->setUpperLinLimit(-1);
    slider->setLowerAngLimit(0);
    slider->setUpperAngLimit(0);
    made = slider;
  } else if (std::holds_alternative<BallDef>(def.kind)) {
    const Frames frames = frame(world);
    made = new btPoint2PointConstraint(first, second, frames.b.getOrigin(), frames.a.getOrigin());
  } else if (const auto* ragdoll = std::get_if<RagdollDef>(&def.kind)) {
    made = with_cone(first, second, frame(world), *ragdoll);
  } else if (const auto* universal = std::get_if<UniversalDef>(&def.kind)) {
    if (!(is_free(universal->turn_a) && is_free(universal->turn_b))) throw Missing{"a driven or limited universal joint"};
    const Vec3 axis = world.rotation * Vec3{1, 0, 0}, given = universal->axis_b ? placed(a).rotation * *universal->axis_b : world.rotation * Vec3{0, 1, 0};
    made = new btUniversalConstraint(first, second, to_stock(world.position), to_stock(normalized(given - axis * dot(given, axis))), to_stock(axis));
  } else if (std::holds_alternative<CylindricalDef>(def.kind)) {
    throw Missing{"cylindrical joints"};
  } else {
    const Frames frames = frame(world);
    made = new btFixedConstraint(first, second, frames.b, frames.a);
  }
  joint.constraint.reset(made);
  joint.feedback = {};
  made->setJointFeedback(&joint.feedback);
  if (def.break_force < kInfinity) made->setBreakingImpulseThreshold(number(def.break_force * substep));
  set_options(joint, substep);
}

void set_options(StockJoint& joint, double) {
  const std::optional<Freedom> f = freedom_of(joint.def);
  if (!f || !joint.constraint) return;
  if (f->friction > 0) throw Missing{"joint friction"};
  const double strength = f->motor ? f->motor->strength.value_or(1e18) : 0;
  if (auto* hinge = dynamic_cast<btHingeConstraint*>(joint.constraint.get())) {
    // Bullet reads its angle within a turn and has no limits on one side only: three quarters of a turn are left.
    if (f->min || f->max) hinge->setLimit(number(f->min.value_or(f->max.value_or(0) - 1.5 * kPi)), number(f->max.value_or(f->min.value_or(0) + 1.5 * kPi)));
    // An impulse, whatever the step (bullet3 issue 210): right at 60 Hz.
    hinge->enableAngularMotor(f->motor.has_value(), f->motor ? number(f->motor->speed.value_or(0)) : 0, number(strength * kFrame));
  } else if (auto* slider = dynamic_cast<btSliderConstraint*>(joint.constraint.get())) {
    if (f->min || f->max) {
      slider->setLowerLinLimit(number(f->min.value_or(-1e6)));
      slider->setUpperLinLimit(number(f->max.value_or(1e6)));
    }
    slider->setPoweredLinMotor(f->motor.has_value());
    if (f->motor) {
      slider->setTargetLinMotorVelocity(number(f->motor->speed.value_or(0)));
      slider->setMaxLinMotorForce(number(strength));
    }
  } else if (f->motor) {
    throw Missing{"a motor beside a spring"};
  }
}

void before_step(StockJoint& joint, double frame) {
  const std::optional<Freedom> f = freedom_of(joint.def);
  if (!joint.constraint || !f || !f->motor || !f->motor->target) return;
  if (auto* hinge = dynamic_cast<btHingeConstraint*>(joint.constraint.get())) {
    hinge->setMotorTarget(number(*f->motor->target), number(frame));
  } else if (auto* slider = dynamic_cast<btSliderConstraint*>(joint.constraint.get())) {
    slider->setTargetLinMotorVelocity(number((*f->motor->target - slider->getLinearPos()) / frame));
  }
}

JointState state(const StockJoint& joint) {
  JointState out;
  if (!joint.constraint) {
    out.broken = true;
    return out;
  }
  const btTypedConstraint& c = *joint.constraint;
  out.broken = !c.isEnabled();
  out.force = from_stock(joint.feedback.m_appliedForceBodyB);
  const btTransform& at = c.getRigidBodyB().getWorldTransform();
  const Vec3 arm = from_stock(at.getBasis() * to_stock(joint.anchor_a));
  out.torque = from_stock(joint.feedback.m_appliedTorqueBodyB) - cross(arm, out.force);
  const btVector3 turning = c.getRigidBodyB().getAngularVelocity() - c.getRigidBodyA().getAngularVelocity();
  if (auto* hinge = dynamic_cast<const btHingeConstraint*>(&c)) {
    out.position = const_cast<btHingeConstraint*>(hinge)->getHingeAngle();
    out.speed = turning.dot((at.getBasis() * hinge->getBFrame().getBasis()).getColumn(2));
  } else if (auto* slider = dynamic_cast<const btSliderConstraint*>(&c)) {
    const_cast<btSliderConstraint*>(slider)->testLinLimits();
    const btVector3 axis = (c.getRigidBodyA().getWorldTransform().getBasis() * slider->getFrameOffsetA().getBasis()).getColumn(0);
    const btVector3 from = c.getRigidBodyA().getWorldTransform() * slider->getFrameOffsetA().getOrigin();
    const btVector3 to = at * slider->getFrameOffsetB().getOrigin();
    out.position = (to - from).dot(axis);
    out.speed = (c.getRigidBodyB().getVelocityInLocalPoint(to - at.getOrigin()) - c.getRigidBodyA().getVelocityInLocalPoint(from - c.getRigidBodyA().getWorldTransform().getOrigin())).dot(axis);
  } else if (auto* six = dynamic_cast<const btGeneric6DofSpring2Constraint*>(&c)) {
    auto* read = const_cast<btGeneric6DofSpring2Constraint*>(six);
    read->calculateTransforms();
    const btVector3 axis = read->getCalculatedTransformA().getBasis().getColumn(0);
    const bool turn = std::holds_alternative<HingeDef>(joint.def.kind);
    out.position = turn ? -read->getAngle(0) : (read->getCalculatedTransformB().getOrigin() - read->getCalculatedTransformA().getOrigin()).dot(axis);
    out.speed = turn ? turning.dot(axis) : (c.getRigidBodyB().getLinearVelocity() - c.getRigidBodyA().getLinearVelocity()).dot(axis);
  }
  return out;
}

}  // namespace tumble::accuracy
