// Arches and a dome of loose stones: they stand by their shape alone, and theory says how thin they may be. A
// semicircle stands down to a thickness of 0.1075 of its radius (Milankovitch 1907; Heyman, The Stone Skeleton).
//
// The arch of 17 stones is that of Box2D's and Solver2D's samples in its proportions (span 8 m inside and 12 m outside,
// rise about 10 m, 2 m thick at the feet and 1.3 m at the crown), laid along a catenary rather than by their table.
#include "accuracy/cases/stacking/build.h"

namespace tumble::accuracy {

namespace {

constexpr double kCritical = 0.1075, kRadius = 10, kDensity = 1, kFriction = 0.8;

// A convex stone by its eight corners, the first four a face and the last four the face across, in the same order.
// It is put where its centre of mass is, by the sum over its tetrahedra.
void lay(Build& build, const std::vector<Vec3>& corners, double density) {
  constexpr int kFaces[6][4] = {{0, 1, 2, 3}, {7, 6, 5, 4}, {0, 4, 5, 1}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}};
  Vec3 middle, moment;
  for (const Vec3& corner : corners) middle += corner / static_cast<double>(corners.size());
  double volume = 0;
  const auto add = [&](Vec3 a, Vec3 b, Vec3 c) {
    const double part = std::abs(dot(a - middle, cross(b - middle, c - middle))) / 6;
    volume += part;
    moment += (a + b + c + middle) * (part / 4);
  };
  const auto at = [&](int i) { return corners[static_cast<std::size_t>(i)]; };
  for (const auto& f : kFaces) {
    add(at(f[0]), at(f[1]), at(f[2]));
    add(at(f[0]), at(f[2]), at(f[3]));
  }
  const Vec3 center = moment / volume;
  std::vector<Vec3> points;
  for (const Vec3& corner : corners) points.push_back(corner - center);
  build.add(dynamic(hull(points), volume * density), {center, {}});
}

// A stone between two cuts through an arch in the plane of x and y, a metre deep.
struct Cut {
  Vec3 inner, outer;
};
void lay_between(Build& build, const Cut& a, const Cut& b, double density) {
  const Vec3 half{0, 0, 0.5};
  lay(build, {a.inner - half, a.outer - half, b.outer - half, b.inner - half, a.inner + half, a.outer + half, b.outer + half, b.inner + half}, density);
}

// All must stay where they are: within a quarter of the stones' size across, and two hundredths of it in height.
Outcome judge_arch(Build& build, double seconds, double stone) {
  double aside = 0, lower = 0;
  build.run(seconds, [&](double time) {
    for (const Block& block : build.blocks()) {
      const Build::Way way = build.moved(block);
      aside = std::max(aside, way.across);
      lower = std::max(lower, way.up);
    }
    if (lower > 2 * stone) build.fail("fell at " + std::to_string(time).substr(0, 4) + " s");
    return !build.failed();
  });
  build.demand(aside, stone / 4);
  build.demand(lower, stone / 50);
  return build.judge();
}

Outcome catenary_arch(Trial& trial) {
  Build build(trial, 0.6);
  build.add_floor();
  constexpr int kStones = 17;
  constexpr double kHalfSpan = 5, kScale = 2, kFoot = 2, kCrown = 1.3;  // m; y = rise - a (cosh(x / a) - 1)
  const double half_length = kScale * std::sinh(kHalfSpan / kScale), rise = kScale * (std::cosh(kHalfSpan / kScale) - 1);
  std::vector<Cut> cuts;
  for (int i = 0; i <= kStones; ++i) {
    const double length_from_crown = half_length * (2.0 * i / kStones - 1);
    const double x = kScale * std::asinh(length_from_crown / kScale);
    const Vec3 on{x, rise - kScale * (std::cosh(x / kScale) - 1), 0};
    const Vec3 out = normalized(Vec3{std::sinh(x / kScale), 1, 0});
    const double thick = kCrown + (kFoot - kCrown) * std::abs(length_from_crown) / half_length;
    Cut cut{on - out * (thick / 2), on + out * (thick / 2)};
    if (i == 0 || i == kStones) cut = {{on.x - std::copysign(kFoot / 2, on.x), 0, 0}, {on.x + std::copysign(kFoot / 2, on.x), 0, 0}};
    cuts.push_back(cut);
  }
  for (std::size_t i = 0; i < kStones; ++i) lay_between(build, cuts[i], cuts[i + 1], 200);
  const double top = cuts[kStones / 2].outer.y;
  for (int i = 0; i < 4; ++i) build.add(dynamic(box({4, 1, 1}), 800), {{0, top + 0.5 + i, 0}, {}});
  return judge_arch(build, lasting(trial, 20, 2, 0.3), 1);
}

constexpr int kStones = 30;

void raise_semicircle(Build& build, double thickness) {
  build.add_floor();
  const auto cut = [&](int i) {
    const Vec3 out{-std::cos(kPi * i / kStones), i % kStones == 0 ? 0 : std::sin(kPi * i / kStones), 0};
    return Cut{out * (kRadius - thickness / 2), out * (kRadius + thickness / 2)};
  };
  for (int i = 0; i < kStones; ++i) lay_between(build, cut(i), cut(i + 1), kDensity);
}

Outcome semicircle(Trial& trial, double ratio) {
  Build build(trial, kFriction);
  raise_semicircle(build, ratio * kRadius);
  return judge_arch(build, lasting(trial, 20, 2, 0.3), 1);
}

// The height of the crown's lower stone after the run, of what it was.
double crown_left(Trial& trial, double ratio, double seconds) {
  Build build(trial, kFriction);
  raise_semicircle(build, ratio * kRadius);
  double left = 1;
  build.run(seconds, [&](double) {
    for (const int i : {kStones / 2 - 1, kStones / 2}) {
      const Block& stone = build.block(i);
      left = std::min(left, build.scene().pose(stone.body).position.y / stone.start.position.y);
    }
    return left > 0.5;
  });
  return left;
}

Outcome too_thin(Trial& trial) {
  const double left = crown_left(trial, 0.10, lasting(trial, 20, 8, 4));
  Outcome outcome;
  outcome.error = left / trial.reference(0.5);
  if (left > 0.5) outcome.failed = "stands, though no arch so thin can";
  return outcome;
}

// The thickness from which it stands, by halving.
Outcome critical(Trial& trial) {
  const double seconds = soaking(trial, 20, 10, 2, 0.4);
  const int halvings = as_many(trial, 6, 3, 1);
  double falls = 0.04, stands = 0.2;
  if (crown_left(trial, stands, seconds) < 0.9) stands = 0.4;
  for (int i = 0; i < halvings; ++i) {
    const double middle = (falls + stands) / 2;
    (crown_left(trial, middle, seconds) < 0.9 ? falls : stands) = middle;
  }
  Outcome outcome;
  const double found = (falls + stands) / 2, truth = trial.reference(kCritical);
  outcome.bias = (found - truth) / truth;
  outcome.error = std::abs(*outcome.bias) / 0.1;
  return outcome;
}

// Eight rings of sixteen stones each, the last ring's meet in a point.
Outcome dome(Trial& trial) {
  Build build(trial, kFriction);
  build.add_floor();
  constexpr int kRings = 8, kAround = 16;
  constexpr double kThick = 0.1 * kRadius;
  const auto corner = [&](int ring, int turn, double radius) {
    const double up = kPi / 2 * ring / kRings, around = 2 * kPi * turn / kAround;
    const double flat = ring == kRings ? 0 : std::cos(up);
    return Vec3{flat * std::cos(around), ring == 0 ? 0 : std::sin(up), flat * std::sin(around)} * radius;
  };
  constexpr double kIn = kRadius - kThick / 2, kOut = kRadius + kThick / 2;
  for (int ring = 0; ring < kRings; ++ring)
    for (int turn = 0; turn < kAround; ++turn)
      lay(build, {corner(ring, turn, kIn), corner(ring, turn + 1, kIn), corner(ring + 1, turn + 1, kIn), corner(ring + 1, turn, kIn),
                  corner(ring, turn, kOut), corner(ring, turn + 1, kOut), corner(ring + 1, turn + 1, kOut), corner(ring + 1, turn, kOut)}, kDensity);
  return judge_arch(build, soaking(trial, 20, 10, 0.2, 0.05), 1);
}

}  // namespace

Case b06_arches() {
  return {"B06", "Arches and a dome",
          "loose stones: 17 along a catenary with four boxes on top; 30 in a semicircle of radius 10 m and thickness t; a hemisphere of 8 x 16, t/R 0.1",
          "F: a semicircle stands from t/R = 0.1075 on", "any stone aside over a quarter of a metre or lower over 2 cm in 20 s (dome 10 s, in a soak 20 s); |critical t/R - 0.1075| over 0.01075",
          {{"arch of 17", 1, catenary_arch},
           {"t/R 0.15", 1, [](Trial& t) { return semicircle(t, 0.15); }},
           {"t/R 0.12", 1, [](Trial& t) { return semicircle(t, 0.12); }},
           {"t/R 0.10 must fall", 1, too_thin},
           {"critical t/R", 1, critical},
           {"dome", 1, dome}}};
}

}  // namespace tumble::accuracy
