#include "accuracy/cases/stacking/pile.h"

#include <algorithm>

namespace tumble::accuracy {

namespace {

constexpr double kSpacing = 1.3;  // m, more than any of the bodies is long

// A cube whose corners are cut off: eight triangles and six octagons.
Shape cut_cube(double half) {
  std::vector<Vec3> points;
  const double cut = half * 0.5;
  for (const double a : {-1.0, 1.0})
    for (const double b : {-1.0, 1.0})
      for (const double c : {-1.0, 1.0}) {
        points.push_back({a * cut, b * half, c * half});
        points.push_back({a * half, b * cut, c * half});
        points.push_back({a * half, b * half, c * cut});
      }
  return hull(std::move(points));
}

}  // namespace

Shape mixed_shape(Mix mix, int index) {
  const bool simple = mix == Mix::simple;
  switch (index % 3) {
    case 0: return box({0.9, 0.7, 0.8});
    case 1: return simple ? ball(0.45) : upright(ShapeKind::cylinder, 0.4, 0.8);
    default: return simple ? upright(ShapeKind::capsule, 0.35, 1.2) : cut_cube(0.42);
  }
}

bool Pit::holds(Vec3 place) const { return std::abs(place.x) < half && std::abs(place.z) < half && place.y > 0; }

Pit pour(Build& build, int count, Mix mix, double lowest) {
  const int side = std::max(2, static_cast<int>(std::lround(std::cbrt(count / 2.0))));
  Pit pit{side * kSpacing / 2 + 0.1};
  const double outside = 2 * pit.half + 4, high = 1.2 * lowest + kSpacing * (count / (side * side) + 1);
  build.add(fixed(box({outside, 2, outside})), {{0, -1, 0}, {}});
  for (const double sign : {-1.0, 1.0}) {
    build.add(fixed(box({2, high, outside})), {{sign * (pit.half + 1), high / 2, 0}, {}});
    build.add(fixed(box({outside, high, 2})), {{0, high / 2, sign * (pit.half + 1)}, {}});
  }
  Chance chance(2000);
  for (int i = 0; i < count; ++i) {
    const int layer = i / (side * side), row = i / side % side, column = i % side;
    const Vec3 place{(column - (side - 1) / 2.0) * kSpacing, lowest + layer * kSpacing, (row - (side - 1) / 2.0) * kSpacing};
    const Vec3 aside{chance.between(-0.05, 0.05), 0, chance.between(-0.05, 0.05)};
    build.add(dynamic(mixed_shape(mix, i + layer), 1), {place + aside, chance.rotation()});
  }
  return pit;
}

}  // namespace tumble::accuracy
