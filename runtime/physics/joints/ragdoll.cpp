#include "physics/joints/ragdoll.h"

#include <algorithm>

#include "physics/joints/ellipse.h"

namespace tumble {

namespace {

// Nearer to a swing of half a turn than this, swing and twist are no longer told apart, rad.
constexpr double kNearHalfTurn = 1e-3;

// The swing of a against b in b's frame, and what turns a spin into its rates (of a rotation vector: J. E. Bortz, 1971).
struct Swing {
  double a = 0, b = 0;          // the rotation vector's parts about y and z, rad
  Vec3 around{0, 1, 0};         // its direction, across x
  double angle = 0;
  Vec3 rate_a, rate_b, twist;   // swing_a' = rate_a . spin, and so on; in b's frame
};

Swing swing_of(const JointFrame& frame) {
  const Vec3 axis = conjugate(frame.b.rotation) * (frame.a.rotation * Vec3{1, 0, 0});
  Swing swing;
  const double sine = std::hypot(axis.y, axis.z);
  if (sine > 0) swing.around = {0, -axis.z / sine, axis.y / sine};  // x cross axis
  swing.angle = std::atan2(sine, axis.x);
  swing.a = swing.angle * swing.around.y;
  swing.b = swing.angle * swing.around.z;

  // With n around which it swings, m = x cross n and s the angle: s' = spin . n, and the direction turns about x by
  // spin . (x + m / tan s); the twist by spin . (x - m tan(s / 2)).
  const double s = std::min(swing.angle, kPi - kNearHalfTurn);
  const Vec3 x{1, 0, 0}, n = swing.around, m = cross(x, n);
  const Vec3 turning = x * s + m * (s < 1e-4 ? 1 - s * s / 3 : s / std::tan(s));  // times s
  swing.rate_a = n * n.y + turning * m.y;
  swing.rate_b = n * n.z + turning * m.z;
  swing.twist = x - m * std::tan(s / 2);
  return swing;
}

Freedom freedom_of(const SwingDef& def, bool limited) {
  TurnDef turn{{}, {}, def.motor, def.spring, def.friction};
  if (limited && def.max) {
    turn.min = -*def.max;
    turn.max = def.max;
  }
  return freedom(turn);
}

}  // namespace

void describe(SwingDef& swing, Schema& s) {
  s.name("swing", "Swinging about a direction across the axis, to both sides alike; 0 is the pose at creation.");
  s.angle("max", swing.max, "How far, to both sides; 0 locks. None where it is not given.").between(0, kPi);
  s.add("motor", swing.motor, "Drives it.");
  s.add("spring", swing.spring, "Pulls it back.");
  s.add("friction", swing.friction, "Brakes it with up to this torque, N m.").at_least(0);
}

void describe(RagdollDef& def, Schema& s) {
  s.name("ragdoll",
         "Lets a bone swing within a cone and twist about its axis, as a shoulder (a cone-twist joint). With both swings "
         "limited the cone is elliptic. Swings of near half a turn cannot be told from twists: keep limits below 170 degrees.");
  s.add("swing_axis", def.swing_axis,
        "What `swing_a` is about, in a's frame as the joint is made; the part of it across `axis` counts. Some direction "
        "across `axis` where it is not given.");
  s.add("swing_a", def.swing_a, "About `swing_axis`.");
  s.add("swing_b", def.swing_b, "About the direction across `axis` and `swing_axis`.");
  s.add("twist", def.twist, "About `axis`.");
}

void rows(const RagdollDef& def, const JointFrame& frame, JointRows& out) {
  hold_point(frame, out);

  const Swing swing = swing_of(frame);
  const auto row = [&](Vec3 rate) { return about(frame.b.rotation * rate, 0); };
  const bool cone = def.swing_a.max && def.swing_b.max && *def.swing_a.max > 0 && *def.swing_b.max > 0;
  out.free.push_back({row(swing.rate_a), swing.a, false, freedom_of(def.swing_a, !cone), true, "swing_a"});
  out.free.push_back({row(swing.rate_b), swing.b, false, freedom_of(def.swing_b, !cone), true, "swing_b"});
  out.free.push_back({row(swing.twist), twisted(frame), true, freedom(def.twist), true, "twist"});
  if (!cone) return;

  // How far inside the cone, across its nearest boundary.
  const Boundary boundary = ellipse_boundary(*def.swing_a.max, *def.swing_b.max, swing.a, swing.b);
  Freedom inside;
  inside.min = 0;
  out.free.push_back({row(-(swing.rate_a * boundary.normal_a + swing.rate_b * boundary.normal_b)), boundary.inside, false, inside, true, ""});
}

}  // namespace tumble
