// Ten links: a pendulum with whips in it. Of the engines compared none keeps more than a third of its energy for a
// minute; a mechanism that is solved directly and whose positions are projected can keep nearly all.
#include "accuracy/cases/joints/mechanisms.h"

namespace tumble::accuracy {

namespace {

constexpr int kLinks = 10;

Outcome swing(Trial& trial, const JointKind& kind, bool gain) {
  Simulation& scene = trial.scene();
  Mechanism mechanism(scene);
  std::vector<Vec3> nodes;
  for (int i = 0; i <= kLinks; ++i) nodes.push_back({static_cast<double>(i), 20, 0});
  mechanism.chain(nodes, rod(), kind);
  // Against hanging at rest.
  const double scale = kGravity * kLinks * kLinks / 2;
  return keep_energy(trial, scene, mechanism, scale, span(trial, 60, 15, 1), gain);
}

}  // namespace

Case s05_ten_links() {
  Case c{"S05", "Ten-link pendulum", "ten rods of 1 m end to end, released horizontally, 60 s", "C: energy",
         "|energy - start| / energy above hanging, worst, and gain alone", {}};
  for (const auto& [name, kind] : {std::pair<std::string, JointKind>{"hinges", HingeDef{}}, {"balls", BallDef{}}}) {
    c.parts.push_back({name + " energy", 2e-2, [=](Trial& t) { return swing(t, kind, false); }});
    c.parts.push_back({name + " energy gain", 1e-3, [=](Trial& t) { return swing(t, kind, true); }});
  }
  return c;
}

}  // namespace tumble::accuracy
