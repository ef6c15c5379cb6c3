// Two bodies that touch, or soon may: up to four points with one normal, and the friction between them.
//
// A substep goes through a contact as begin, foresee, warm_start, solve (to be apart after the drift), drifted, warm_start,
// solve (to be at rest against each other), end; impact.h has what bounces. Normals and tangents stay as the collision
// pass found them; separations follow the bodies.
#pragma once

#include <optional>

#include "physics/dynamics/mover.h"

namespace tumble::dynamics {

// A contact as a damped spring that is solved implicitly, so that it may be as stiff as the substep allows and still
// gives way where many press on few (E. Catto, Soft Constraints, GDC 2011; Solver2D, box2d.org 2024).
struct Softness {
  double rate = 0;           // part of an overlap that is taken back in a second, 1/s
  double mass_scale = 1, impulse_scale = 0;
};
Softness softness(double frequency, double damping_ratio, double h);
Softness contact_softness(double h);  // of contacts in substeps of h

// The way from the axis of a cylinder or cone, of length 1, to where it reaches farthest along `out`, if `spoke` was it
// before: not where that is nearly along the axis or elsewhere, as on a flat end, nor without an axis.
std::optional<Vec3> rolled(Vec3 spoke, Vec3 axis, Vec3 out);

struct TouchPoint {
  Vec3 arm_a, arm_b;         // from the centres of mass, world, m
  // What of the arm turns with the body: all of it to a corner; to what is round, up to the axle about which it rolls.
  Vec3 hub_a, hub_b;
  bool corner_a = false, corner_b = false;
  double separation = 0;     // m; negative where they overlap
  double restitution = 0;
  double impulse = 0;        // N s, in this substep
  double last = 0;           // in the one before; the first guess
  double sum = 0;            // in this step
  double mobility = 0;       // 1/kg: speed that an impulse of 1 gives
  double hit = 0;            // N s, what bouncing took in this substep, beside `impulse`
  double pull = 0;           // m/s^2: how fast forces make them close faster
};

struct Contact {
  static constexpr int kMostPoints = 4;
  Mover *a = nullptr, *b = nullptr;
  Vec3 normal;               // from b to a
  Vec3 tangent_1, tangent_2;
  Vec3 belt;                 // velocity of b's surface against a's own, m/s
  double friction = 0;
  double lift = 0;           // m, see raise()
  int count = 0;
  TouchPoint points[kMostPoints];
  // The axis of a body that is round about one, of length 1; zero of all others. Its rim or side touches where it comes
  // lowest, and that goes round as the axis turns.
  Vec3 axis_a, axis_b;
  // The friction's impulse: along both tangents, N s, and about the normal, N m s.
  Vec3 grip, last_grip;
  // What stops rolling and spinning on the spot, where asked for: the most that its moment may be, over what presses, m;
  // and its impulse along both tangents and the normal, N m s.
  double rolling = 0, spinning = 0;
  Vec3 roll, last_roll;
  // Of two balls about their centres of mass: their normal is taken anew in each substep, where they meet. 0 of all others.
  double radius_a = 0, radius_b = 0;
  Vec3 center_a, center_b;   // from the movers' places, m: those of what does not move have only one
  // What pressed at points that were lost within the step, N s, and where that was, in the world, with the normal.
  struct Lost {
    double sum = 0;
    Vec3 on_a, on_b, normal;
  };
  Lost lost;

  double fastest_push = 0;   // m/s, see limit_push()

  // How fast an overlap may be taken back, by the normal and the forces on the bodies.
  void limit_push();
  // Takes tangents that depend on the normal alone.
  void set_normal(Vec3 from_b_to_a);
  // Between steps impulses are kept as forces: substeps may differ.
  void scale(double factor);
  // Velocities are those at the start of the substep, not kicked yet.
  void begin(double h);
  // After the first kick, which gave `h / 2` of the accelerations.
  void foresee(double h);
  // When after `from` and within h will a point meet that bounces? Infinity where none does.
  double next_hit(double from, double h);
  // Does one meet then?
  bool meets(double time, double h);
  // Its points that meet at that time are to leave each other with what their restitution says; the impulses for it, given
  // at once: again where others took a part of it. Tells by how much the speeds still had to change, m/s.
  void aim_hit(double time, double h);
  double hit(double time, double h);
  void end_hit();
  bool bounces() const;
  // How fast each point closes, m/s: to be told after a hit somewhere else at that time, so that separations follow.
  void note_closing();
  void hit_elsewhere(double time, double h);
  // Gives half of what the substep before needed.
  void warm_start();
  // `soft` is nullptr where overlap is to stay.
  // Tells the largest change of a speed, m/s.
  double solve(double h, const Softness* soft);
  void drifted(double h);
  void end();
  // After a step, with its forces: what rests does not stay as deep as a soft contact gives way under it. The spring's end
  // is moved on until it bears the load where the bodies only just touch.
  void raise(double seconds);

  // Where the friction of all points acts: about both bodies, and what twist may hold over what the tangents may, m. By how
  // hard each point presses, or evenly.
  struct Place {
    Vec3 arm_a, arm_b;
    double lever = 0;
  };
  Place friction_place(double TouchPoint::*pressing) const;
  double pressing() const;   // N s, all points
  double nearest() const;    // m, of the points' separations
  int island() const { return a->pushable ? a->island : b->island; }

 private:
  double closing(const TouchPoint& point) const;
  bool hits_next(const TouchPoint& point) const;  // right when the next substep begins
  double gap_at(const TouchPoint& point, double time, double h) const;
  double closing_at(const TouchPoint& point, double time, double h) const;
  void push(const TouchPoint& point, double impulse);
  void solve_friction();
  void solve_rolling();
  void twist(Vec3 change);
  double solve_normals(double h, const Softness* soft);
  void place_friction();
  void note_mobility();
  void meet(double h);
  double carried_by_a(const TouchPoint& point) const;
  Vec3 slip() const;
  Vec3 evenly(Vec3 moving) const;
  void drag(Vec3 change);

  bool placed_ = false;      // is what follows of the friction known?
  double ahead_ = 0;         // s, to the middle of the drift that it is to act in
  Vec3 arm_a_, arm_b_;       // of the friction
  double lever_ = 0;         // m: what twist may hold over what the tangents may
  Symmetric slip_, stop_;    // speeds by impulse, (tangent, tangent, lever times twist), and the inverse
  double stiffest_ = 0;      // an upper bound of slip_'s eigenvalues
  Vec3 slid_a_, slid_b_;               // of the arms, within a hit
  double leave_[kMostPoints] = {};     // m/s, of the last hit; below 0 of what did not meet
  double closing_[kMostPoints] = {};   // m/s; when the substep began, or before the last hit
};

}  // namespace tumble::dynamics
