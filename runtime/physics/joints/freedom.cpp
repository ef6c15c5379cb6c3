#include "physics/joints/freedom.h"

#include "base/text.h"

namespace tumble {

namespace {

template <class Def>
Freedom plain(const Def& def) {
  Freedom result{def.min, def.max, {}, {}, def.friction};
  if (def.motor) result.motor = *def.motor;
  if (def.spring && def.spring->frequency > 0) result.spring = *def.spring;
  return result;
}

[[noreturn]] void fail_limits(const char* unit, double min, double max) {
  fail("min must not be above max (got ", number_text(min), " and ", number_text(max), unit, "); leave both out for no limit");
}

void describe_common(SpringDef& spring, Schema& s) {
  s.add("frequency", spring.frequency, "How often it would swing in a second, Hz; 0 is no spring.").at_least(0);
  s.add("damping", spring.damping, "Ratio: 0 swings on, 1 comes to rest without swinging over.").at_least(0);
}

}  // namespace

void describe(SlideMotorDef& motor, Schema& s) {
  s.name("slide_motor", "Drives a sliding freedom at a speed or towards a target.");
  s.add("speed", motor.speed, "m/s; with a target, the most it uses on the way.");
  s.add("target", motor.target, "Position to go to and hold, m.");
  s.add("force", motor.strength, "The most it pushes, N; unlimited where it is not given.").at_least(0);
}

void describe(TurnMotorDef& motor, Schema& s) {
  s.name("turn_motor", "Drives a turning freedom at a speed or towards a target.");
  s.add("speed", motor.speed, "rad/s; with a target, the most it uses on the way.");
  s.angle("target", motor.target, "Angle to go to and hold.");
  s.add("torque", motor.strength, "The most it turns with, N m; unlimited where it is not given.").at_least(0);
}

void describe(SlideSpringDef& spring, Schema& s) {
  s.name("slide_spring", "Pulls a sliding freedom to its rest.");
  describe_common(spring, s);
  s.add("rest", spring.rest, "Where it pulls to, m.");
}

void describe(TurnSpringDef& spring, Schema& s) {
  s.name("turn_spring", "Pulls a turning freedom to its rest.");
  describe_common(spring, s);
  s.angle("rest", spring.rest, "Where it pulls to.");
}

void describe(SlideDef& freedom, Schema& s) {
  s.name("slide", "Moving along an axis; 0 is the pose at creation.");
  s.add("min", freedom.min, "Lower limit, m; none where it is not given.");
  s.add("max", freedom.max, "Upper limit, m; equal limits lock.");
  s.add("motor", freedom.motor, "Drives it.");
  s.add("spring", freedom.spring, "Pulls it back.");
  s.add("friction", freedom.friction, "Brakes it with up to this force, N.").at_least(0);
  s.check<SlideDef>([](const SlideDef& def) { check_limits(def); });
}

void describe(TurnDef& freedom, Schema& s) {
  s.name("turn", "Turning about an axis, right-handed; 0 is the pose at creation.");
  s.angle("min", freedom.min, "Lower limit; none where it is not given.");
  s.angle("max", freedom.max, "Upper limit; equal limits lock. More than one turn is allowed.");
  s.add("motor", freedom.motor, "Drives it.");
  s.add("spring", freedom.spring, "Pulls it back.");
  s.add("friction", freedom.friction, "Brakes it with up to this torque, N m.").at_least(0);
  s.check<TurnDef>([](const TurnDef& def) { check_limits(def); });
}

void check_limits(const SlideDef& def) {
  if (def.min && def.max && *def.min > *def.max) fail_limits(" m", *def.min, *def.max);
}

void check_limits(const TurnDef& def) {
  if (def.min && def.max && *def.min > *def.max) fail_limits(" rad", *def.min, *def.max);
}

Freedom freedom(const SlideDef& def) { return plain(def); }
Freedom freedom(const TurnDef& def) { return plain(def); }

}  // namespace tumble
