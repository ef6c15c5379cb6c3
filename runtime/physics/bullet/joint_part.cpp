#include "physics/bullet/joint_part.h"

#include <Eigen/Dense>

#include <algorithm>

namespace tumble {

namespace {

constexpr double kRepair = 0.2;        // part of a position error that one substep takes back
constexpr double kServoRate = 30;      // 1/s: a motor with a target nears it as exp(-30 t)

btRigidBody& body_a(const JointPart& joint) { return joint.constraint->getRigidBodyA(); }
btRigidBody& body_b(const JointPart& joint) { return joint.constraint->getRigidBodyB(); }

double velocity_along(const JointPart& joint, const JointRow& row) {
  const btRigidBody &a = body_a(joint), &b = body_b(joint);
  return dot(row.linear_a, from_bullet(a.getLinearVelocity())) + dot(row.angular_a, from_bullet(a.getAngularVelocity())) +
         dot(row.linear_b, from_bullet(b.getLinearVelocity())) + dot(row.angular_b, from_bullet(b.getAngularVelocity()));
}

// What an impulse of 1 along `by` changes along `along`.
double response(const JointPart& joint, const JointRow& along, const JointRow& by) {
  const btRigidBody &a = body_a(joint), &b = body_b(joint);
  const Vec3 turn_a = from_bullet(a.getInvInertiaTensorWorld() * to_bullet(by.angular_a));
  const Vec3 turn_b = from_bullet(b.getInvInertiaTensorWorld() * to_bullet(by.angular_b));
  return a.getInvMass() * dot(along.linear_a, by.linear_a) + dot(along.angular_a, turn_a) +
         b.getInvMass() * dot(along.linear_b, by.linear_b) + dot(along.angular_b, turn_b);
}

// A freedom as the held rows leave it: an impulse of 1 along it, with `helpers` along the held rows that keep those
// still, changes its velocity by `mobility`. So a door's spring feels the door's inertia about its hinge.
struct Effective {
  double mobility = 0;
  std::vector<double> helpers;
};

Effective effective(const JointPart& joint, const JointRow& free) {
  std::vector<const JointRow*> held;
  for (const JointRow& row : joint.rows.held)
    if (row.friction < 0) held.push_back(&row);
  const auto n = static_cast<Eigen::Index>(held.size());
  Eigen::MatrixXd k(n, n);
  Eigen::VectorXd coupling(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    coupling[i] = response(joint, *held[static_cast<std::size_t>(i)], free);
    for (Eigen::Index j = 0; j < n; ++j)
      k(i, j) = response(joint, *held[static_cast<std::size_t>(i)], *held[static_cast<std::size_t>(j)]);
  }
  Effective result{response(joint, free, free), std::vector<double>(held.size())};
  if (n == 0) return result;
  const Eigen::VectorXd helpers = -k.completeOrthogonalDecomposition().solve(coupling);
  result.mobility += coupling.dot(helpers);
  for (Eigen::Index i = 0; i < n; ++i) result.helpers[static_cast<std::size_t>(i)] = helpers[i];
  return result;
}

void apply_impulse(JointPart& joint, const JointRow& row, double impulse) {
  const auto push = [](btRigidBody& body, Vec3 linear, Vec3 angular) {
    if (body.getInvMass() == 0) return;
    body.setLinearVelocity(body.getLinearVelocity() + body.getInvMass() * to_bullet(linear) * body.getLinearFactor());
    body.setAngularVelocity(body.getAngularVelocity() +
                            body.getInvInertiaTensorWorld() * to_bullet(angular) * body.getAngularFactor());
  };
  push(body_a(joint), row.linear_a * impulse, row.angular_a * impulse);
  push(body_b(joint), row.linear_b * impulse, row.angular_b * impulse);
  const Vec3 arm = joint.frame().a.position - joint.frame().center_a;
  joint.impulse += row.linear_a * impulse;
  joint.twist += (row.angular_a - cross(arm, row.linear_a)) * impulse;
}

// The velocity that takes x exactly to where the damped oscillator x'' + 2 z w x' + w^2 x = 0 is after h, when x
// moves by h times it: x(t+h) = 2 a c x(t) - a^2 x(t-h), a = exp(-z w h), c = cos(w h sqrt(1 - z^2)). Stable for any h.
double oscillator_velocity(double x, double v, const SpringDef& spring, double h) {
  const double w = 2 * kPi * spring.frequency, z = spring.damping, a = std::exp(-z * w * h);
  const double root = w * h * std::sqrt(std::abs(1 - z * z));
  // Over-damped: a cosh(root) without overflow.
  const double ac = z <= 1 ? a * std::cos(root) : (std::exp(root - z * w * h) + std::exp(-root - z * w * h)) / 2;
  return a * a * v + (2 * ac - 1 - a * a) / h * x;
}

double servo_velocity(const JointPart& joint, const FreeRow& free, double position) {
  const MotorDef& motor = *free.freedom.motor;
  const double error = *motor.target - position;
  double speed = std::abs(error) * std::min(kServoRate, 0.5 / joint.seconds);
  if (motor.strength) {  // no faster than it can brake with four fifths of its strength
    const double braking = 0.8 * *motor.strength * effective(joint, free.row).mobility;
    speed = std::min(speed, std::sqrt(2 * braking * std::abs(error)));
  }
  if (motor.speed) speed = std::min(speed, std::abs(*motor.speed));
  return std::copysign(speed, error);
}

void add_free_rows(JointPart& joint, const FreeRow& free, double position) {
  const double h = joint.seconds, inf = SIMD_INFINITY;
  const Freedom& f = free.freedom;
  std::vector<SolverRow>& out = joint.solver_rows;
  if (f.friction > 0) out.push_back({free.row, 0, -f.friction * h, f.friction * h});
  if (f.motor && (f.motor->speed || f.motor->target)) {
    const double limit = f.motor->strength ? *f.motor->strength * h : inf;
    const double velocity = f.motor->target ? servo_velocity(joint, free, position) : *f.motor->speed;
    out.push_back({free.row, velocity, -limit, limit});
  }
  if (f.min && f.max && *f.min == *f.max) {
    out.push_back({free.row, -kRepair * (position - *f.min) / h, -inf, inf});
    return;
  }
  // Limits look ahead: it may come as near in this substep as there is room.
  const auto allowed = [&](double room) { return (room >= 0 ? room : kRepair * room) / h; };
  if (f.min) out.push_back({free.row, -allowed(position - *f.min), 0, inf});
  if (f.max) out.push_back({free.row, allowed(*f.max - position), -inf, 0});
}

void make_solver_rows(JointPart& joint) {
  joint.solver_rows.clear();
  const double h = joint.seconds, inf = SIMD_INFINITY;
  for (const JointRow& row : joint.rows.held) {
    if (row.friction >= 0) joint.solver_rows.push_back({row, 0, -row.friction * h, row.friction * h});
    else joint.solver_rows.push_back({row, -kRepair * row.error / h, -inf, inf});
  }
  for (std::size_t i = 0; i < joint.rows.free.size(); ++i) add_free_rows(joint, joint.rows.free[i], joint.positions[i]);
}

// Hands the rows to Bullet's solver.
class RowConstraint final : public btTypedConstraint {
 public:
  RowConstraint(JointPart& joint, btRigidBody& a, btRigidBody& b)
      : btTypedConstraint(MAX_CONSTRAINT_TYPE, a, b), joint_(joint) {}

  void getInfo1(btConstraintInfo1* info) override {
    refresh_rows(joint_);
    make_solver_rows(joint_);
    info->m_numConstraintRows = static_cast<int>(joint_.solver_rows.size());
    info->nub = 0;
  }

  void getInfo2(btConstraintInfo2* info) override {
    for (std::size_t i = 0; i < joint_.solver_rows.size(); ++i) {
      const SolverRow& from = joint_.solver_rows[i];
      const auto at = i * static_cast<std::size_t>(info->rowskip);
      put(info->m_J1linearAxis + at, from.row.linear_a);
      put(info->m_J1angularAxis + at, from.row.angular_a);
      put(info->m_J2linearAxis + at, from.row.linear_b);
      put(info->m_J2angularAxis + at, from.row.angular_b);
      info->m_constraintError[at] = from.velocity;
      info->m_lowerLimit[at] = from.lower;
      info->m_upperLimit[at] = from.upper;
    }
  }

  void setParam(int, btScalar, int) override {}
  btScalar getParam(int, int) const override { return 0; }

 private:
  static void put(btScalar* to, Vec3 v) {
    to[0] = v.x;
    to[1] = v.y;
    to[2] = v.z;
  }
  JointPart& joint_;
};

}  // namespace

JointFrame JointPart::frame() const {
  const auto center = [](const BodyState* body) { return body ? from_bullet(body->rigid->getWorldTransform().getOrigin()) : Vec3{}; };
  return {a ? a->pose() * local_a : local_a, b ? b->pose() * local_b : local_b, center(a), center(b)};
}

void build(JointPart& joint, btRigidBody& world) {
  joint.constraint = std::make_unique<RowConstraint>(joint, joint.a ? *joint.a->rigid : world, joint.b ? *joint.b->rigid : world);
  joint.constraint->setJointFeedback(&joint.feedback);
  note_drives(joint);
}

void note_drives(JointPart& joint) {
  refresh_rows(joint);
  joint.has_spring = joint.has_motor = false;
  for (const FreeRow& free : joint.rows.free) {
    joint.has_spring |= free.freedom.spring.has_value();
    joint.has_motor |= free.freedom.motor && free.freedom.motor->speed.value_or(0) != 0;
  }
}

void refresh_rows(JointPart& joint) {
  joint.rows.clear();
  const JointFrame frame = joint.frame();
  std::visit([&](const auto& kind) { rows(kind, frame, joint.rows); }, joint.def.kind);
  joint.positions.resize(joint.rows.free.size(), 0);
  for (std::size_t i = 0; i < joint.positions.size(); ++i) {
    const FreeRow& free = joint.rows.free[i];
    double& known = joint.positions[i];
    known = free.turn ? known + std::remainder(free.position - known, 2 * kPi) : free.position;
  }
}

void apply_springs(JointPart& joint) {
  if (!joint.has_spring) return;
  refresh_rows(joint);
  for (std::size_t i = 0; i < joint.rows.free.size(); ++i) {
    const FreeRow& free = joint.rows.free[i];
    if (!free.freedom.spring) continue;
    const Effective way = effective(joint, free.row);
    if (way.mobility <= 1e-12) continue;
    const double now = velocity_along(joint, free.row);
    const double wanted = oscillator_velocity(joint.positions[i] - free.freedom.spring->rest, now, *free.freedom.spring, joint.seconds);
    const double impulse = (wanted - now) / way.mobility;
    apply_impulse(joint, free.row, impulse);
    std::size_t helper = 0;
    for (const JointRow& row : joint.rows.held)
      if (row.friction < 0) apply_impulse(joint, row, impulse * way.helpers[helper++]);
  }
}

void collect(JointPart& joint) {
  const JointFrame frame = joint.frame();
  const Vec3 force = from_bullet(joint.feedback.m_appliedForceBodyA), torque = from_bullet(joint.feedback.m_appliedTorqueBodyA);
  joint.impulse += force * joint.seconds;
  joint.twist += (torque - cross(frame.a.position - frame.center_a, force)) * joint.seconds;
}

JointState state_of(const JointPart& joint) {
  JointState state{joint.force, joint.torque, 0, 0, joint.broken};
  JointRows now;
  const JointFrame frame = joint.frame();
  std::visit([&](const auto& kind) { rows(kind, frame, now); }, joint.def.kind);
  if (now.free.empty()) return state;
  const FreeRow& free = now.free[0];
  const double known = joint.positions.empty() ? 0 : joint.positions[0];
  state.position = free.turn ? known + std::remainder(free.position - known, 2 * kPi) : free.position;
  if (joint.constraint) state.speed = velocity_along(joint, free.row);
  return state;
}

}  // namespace tumble
