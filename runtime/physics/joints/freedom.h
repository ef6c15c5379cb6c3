// One way in which joined bodies may move against each other, and what drives, limits and brakes it.
#pragma once

#include <optional>

#include "base/describe.h"

namespace tumble {

// Drives a freedom at a speed, or towards a target, with at most that force (N) or torque (N m). With both a target
// and a speed, the speed is the most it uses on the way.
struct MotorDef {
  std::optional<double> speed;     // m/s or rad/s
  std::optional<double> target;    // m or rad
  std::optional<double> strength;  // written `force` on a sliding freedom and `torque` on a turning one; none: unlimited
};
struct SlideMotorDef : MotorDef {};
struct TurnMotorDef : MotorDef {};

// Pulls a freedom to `rest` as a damped oscillator of the two bodies: as heavy as they are along that freedom.
struct SpringDef {
  double frequency = 0;  // Hz; 0 is no spring
  double damping = 0;    // ratio; 1 is critical
  double rest = 0;       // m or rad
};
struct SlideSpringDef : SpringDef {};
struct TurnSpringDef : SpringDef {};

// 0 is the pose at creation; equal limits lock, a limit that is left out does not limit.
struct SlideDef {  // metres
  std::optional<double> min, max;
  std::optional<SlideMotorDef> motor;
  std::optional<SlideSpringDef> spring;
  double friction = 0;  // N
};
struct TurnDef {  // radians
  std::optional<double> min, max;
  std::optional<TurnMotorDef> motor;
  std::optional<TurnSpringDef> spring;
  double friction = 0;  // N m
};

void describe(SlideMotorDef& motor, Schema& s);
void describe(TurnMotorDef& motor, Schema& s);
void describe(SlideSpringDef& spring, Schema& s);
void describe(TurnSpringDef& spring, Schema& s);
void describe(SlideDef& freedom, Schema& s);
void describe(TurnDef& freedom, Schema& s);
// Throws Error where min is above max.
void check_limits(const SlideDef& freedom);
void check_limits(const TurnDef& freedom);

// The same for slides and turns, as the solver reads it.
struct Freedom {
  std::optional<double> min, max;
  std::optional<MotorDef> motor;
  std::optional<SpringDef> spring;
  double friction = 0;
};
Freedom freedom(const SlideDef& def);
Freedom freedom(const TurnDef& def);

}  // namespace tumble
