// Bullet's own constraints for the runtime's joints.
#pragma once

#include "accuracy/engines/stock_shapes.h"

namespace tumble::accuracy {

// A body of the scene with its centre of mass, as a joint needs it. The body of the world has none.
struct StockPartner {
  btRigidBody* body = nullptr;
  Vec3 center;
};

struct StockJoint {
  std::unique_ptr<btTypedConstraint> constraint;  // null once its body is gone
  btJointFeedback feedback;
  JointDef def;
  int a = kWorld, b = kWorld;
  Vec3 anchor_a;  // from a's centre of mass, in its frame
};

// The constraint as it stands at creation: b is Bullet's first body, a its second, so that angles are those of a.
void make_constraint(StockJoint& joint, const StockPartner& a, const StockPartner& b, double substep);
// Limits and motors from the def, live.
void set_options(StockJoint& joint, double substep);
// Servo motors: Bullet wants the speed anew for each step.
void before_step(StockJoint& joint, double frame);
JointState state(const StockJoint& joint);

}  // namespace tumble::accuracy
