// A house of cards: thin, light, and held by friction alone. Each card is a box of 2 mm, a twentieth of what many
// engines take as a margin.
#include "accuracy/cases/stacking/build.h"

namespace tumble::accuracy {

namespace {

constexpr Vec3 kCard{0.002, 0.4, 0.2};  // m
constexpr double kSpacing = 0.175, kLean = 25, kFriction = 0.7;
constexpr double kMass = 0.01;          // kg
constexpr double kMoved = 0.05;         // m: more, and a card no longer is in its place

// PEEL's house, with Box3D's offsets: it stands with small gaps and closes them in the first tenths of a second.
void raise(Build& build, int levels, double resistance) {
  BodyDef card = dynamic(box(kCard), kMass);
  card.rolling_friction = resistance;
  const Vec3 z{0, 0, 1};
  double left = 0, y = 0.18;
  for (int pairs = levels; pairs > 0; --pairs) {
    double x = left;
    for (int i = 0; i < pairs; ++i) {
      if (i + 1 < pairs) build.add(card, {{x + 0.25, y + 0.185, 0}, axis_angle(z, kPi / 2)});
      build.add(card, {{x, y, 0}, axis_angle(z, radians(-kLean))});
      x += kSpacing;
      build.add(card, {{x, y, 0}, axis_angle(z, radians(kLean))});
      x += kSpacing;
    }
    y += 0.37;
    left += kSpacing;
  }
}

Outcome house(Trial& trial, int levels, double resistance = 0) {
  Build build(trial, kFriction);
  build.add_floor();
  raise(build, levels, resistance);
  double most = 0;
  build.run(lasting(trial, 10, 2, 0.5), [&](double time) {
    most = std::max(most, build.furthest());
    if (most > 0.2) build.fail("fell at " + std::to_string(time).substr(0, 4) + " s");
    return !build.failed();
  });
  build.demand(most, kMoved);
  return build.judge();
}

}  // namespace

Case b05_card_house() {
  return {"B05", "Card house", "cards of 2 x 400 x 200 mm, pairs at 25 degrees, lying ones between the levels; friction 0.7", "the house as it was built",
          "furthest that any card moved in 10 s, over 5 cm",
          {{"1 level", 1, [](Trial& t) { return house(t, 1); }},
           {"5 levels", 1, [](Trial& t) { return house(t, 5); }},
           {"5 levels, rolling resistance 0.05", 1, [](Trial& t) { return house(t, 5, 0.05); }}}};
}

}  // namespace tumble::accuracy
