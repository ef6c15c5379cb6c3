// Sizes from half a millimetre to a kilometre: two cubes fall a part of their edge and lie on each other. Whatever an
// engine holds as a fixed length (margins, contact distances, slop) shows at one end, limits of impulses at the other.
#include "accuracy/cases/stacking/build.h"

namespace tumble::accuracy {

namespace {

constexpr double kDensity = 1000;

Outcome pair(Trial& trial, double edge) {
  Build build(trial, 0.5);
  const double side = std::max(40.0, 4 * edge), thick = std::max(2.0, edge);
  const BodyIndex floor = build.add(fixed(box({side, thick, side})), {{0, -thick / 2, 0}, {}});
  const double mass = kDensity * edge * edge * edge;
  for (const double height : {0.6, 1.8}) build.add(dynamic(box({edge, edge, edge}), mass), {{0, height * edge, 0}, {}});

  // The second cube of 1 km lands after 8 s. The floor's impulses of the last half second carry both.
  const double seconds = edge > 500 ? 10 : lasting(trial, 10, edge > 50 ? 5 : 2, edge > 50 ? 4 : 1);
  double carried = 0;
  build.scene().touches();
  build.run(seconds, [&](double time) {
    if (time <= seconds - 0.5 + kFrame / 2) return true;
    for (const Touch& touch : build.scene().touches())
      if (touch.a == floor) carried += touch.impulse * touch.normal.y;
    return true;
  });

  for (int i = 0; i < 2; ++i) {
    const Build::Way way = build.way(build.block(i).body, {0, (0.5 + i) * edge, 0});
    build.demand(way.up, 0.05 * edge);
    build.demand(way.across, 0.25 * edge);
  }
  const double weight = trial.reference(2 * mass * kGravity * 0.5);
  build.demand(std::abs(carried - weight), 0.005 * weight);
  return build.judge(false);
}

std::string name(double edge) {
  if (edge >= 1000) return "1 km";
  if (edge >= 1) return std::to_string(std::lround(edge)) + " m";
  if (edge < 0.001) return "0.5 mm";
  return std::to_string(std::lround(edge * 1000)) + " mm";
}

}  // namespace

Case b11_sizes() {
  Case c{"B11", "Sizes", "two cubes of 0.5 mm to 1 km edge, 1000 kg/m^3, fall 0.1 and 0.3 edges onto the floor and each other",
         "F: they rest at 0.5 and 1.5 edges, and the floor carries both", "height off over 5 % of an edge, aside over a quarter of it, load off over 0.5 %, after 10 s", {}};
  for (const double edge : {0.0005, 0.001, 0.005, 0.02, 0.1, 1.0, 100.0, 1000.0}) c.parts.push_back({name(edge), 1, [edge](Trial& t) { return pair(t, edge); }});
  return c;
}

}  // namespace tumble::accuracy
