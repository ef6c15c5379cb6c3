// Bodies held together by joints and what is measured of them, shared by the cases of joints.
#pragma once

#include "accuracy/scenes.h"

namespace tumble::accuracy {

// How long, or how many: in the full run, in the quick one, and in a test.
double span(Trial& trial, double full, double quick, double test);

// A number in a part's name.
std::string text(double number);

// The bodies and joints of a scene. Bodies of a mechanism pass through each other, so that only its joints count.
class Mechanism {
 public:
  explicit Mechanism(Simulation& scene, Vec3 gravity = {0, -kGravity, 0}) : scene_(scene), gravity_(gravity) {}

  BodyIndex add(BodyDef body, const Pose& pose);
  JointIndex join(const JointSpec& joint);
  // Links from node to node, their x along it, each joined to the one before where they meet, about z where the kind has
  // an axis; the first one to `from`.
  std::vector<BodyIndex> chain(const std::vector<Vec3>& nodes, const BodyDef& link, const JointKind& kind, BodyIndex from = kWorld);

  double kinetic() const;
  double energy() const;            // kinetic and potential, J
  Vec3 momentum() const;
  Vec3 angular_momentum() const;    // about the origin
  double gap() const;               // m: of a joint's two anchors, the largest; of a slider across its axis
  double fastest() const;           // m/s
  bool finite() const;

 private:
  struct Held {
    BodyIndex a, b;
    Vec3 on_a, on_b, axis;          // anchors in the frames of their bodies; a slider's axis in b's frame, else zero
  };
  Pose pose(BodyIndex body) const { return body == kWorld ? Pose{} : scene_.pose(body); }

  Simulation& scene_;
  Vec3 gravity_;
  std::vector<BodyIndex> bodies_;   // that move by themselves
  std::vector<Held> held_;
};

// A rod of 1 m and 1 kg along its x, 0.1 m thick, and its moment of inertia across, about its centre.
BodyDef rod();
constexpr double kRodInertia = (1 + 0.01) / 12;
// The same, seen from its pivot: where a body of that arm points to, 0 down and positive towards x.
double angle_of(const Simulation& scene, BodyIndex body, Vec3 pivot);
// Period of a pendulum: its moment of inertia about the pivot, its mass times the arm, and how far it swings, by the
// arithmetic-geometric mean.
double swing_period(double inertia, double moment, double amplitude);

// Runs a mechanism of which nothing takes energy. The error is the energy's largest way from that of the start, over
// `scale` (J), or, for `gain`, its way up alone.
Outcome keep_energy(Trial& trial, Simulation& scene, const Mechanism& mechanism, double scale, double seconds, bool gain);

// A swinging value: when it goes through 0, between samples by a straight line, as nothing accelerates it there.
class Swing {
 public:
  void add(double seconds, double value);
  // Mean of all whole periods; 0 before there is one.
  double period() const { return crossings_ > 2 ? 2 * (last_ - first_) / (whole_ - 1) : 0; }

 private:
  double seconds_ = 0, value_ = 0, first_ = 0, last_ = 0;
  int crossings_ = 0, whole_ = 0;   // whole: an odd number of crossings spans whole periods
};

}  // namespace tumble::accuracy
