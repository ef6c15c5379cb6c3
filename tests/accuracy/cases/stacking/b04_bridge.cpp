// A block of 8000 times the weight falls on two small ones: impact and load through light bodies at once.
#include "accuracy/cases/stacking/build.h"

namespace tumble::accuracy {

namespace {

constexpr double kBig = 20, kSmall = 1, kSqueezed = 0.1;  // m

Outcome drop(Trial& trial, double gap) {
  Build build(trial, 0.6);
  const BodyIndex floor = build.add_floor(80);
  const BodyDef small = dynamic(box({kSmall, kSmall, kSmall}), 1);
  const BodyIndex left = build.add(small, {{-9, kSmall / 2, 0}, {}}), right = build.add(small, {{9, kSmall / 2, 0}, {}});
  const BodyIndex big = build.add(dynamic(box({kBig, kBig, kBig}), kBig * kBig * kBig), {{0, kSmall + gap + kBig / 2, 0}, {}});

  const double seconds = gap > 0 ? lasting(trial, 8, 4, 2.5) : lasting(trial, 8, 3, 0.5);
  const Vec3 right_place{0, kSmall + kBig / 2, 0};
  double squeezed = 0, lower = 0;
  build.run(seconds, [&](double time) {
    for (const BodyIndex body : {left, right}) {
      double sum = 0;
      for (const Overlap& o : build.overlaps())
        if (o.a == body || o.b == body) sum += o.depth;
      squeezed = std::max(squeezed, sum);
    }
    for (const Overlap& o : build.overlaps())
      if (o.a == floor && o.b == big && o.depth > kSmall / 2) build.fail("the big block sank into the floor");
    if (time > seconds - 0.25) lower = std::max(lower, build.way(big, right_place).up);
    return !build.failed();
  });
  build.demand(squeezed, kSqueezed);
  build.demand(lower, kSqueezed);
  return build.judge();
}

}  // namespace

Case b04_bridge() {
  return {"B04", "A big block on two small ones", "a block of 20 m and 8000 kg bridges two of 1 m and 1 kg, set down or dropped from 16 m above them",
          "the small blocks keep their height", "overlap of a small block with floor and big block together, and the big block's height at the end, over 10 % of the small edge",
          {{"set down", 1, [](Trial& t) { return drop(t, 0); }}, {"dropped 16 m", 1, [](Trial& t) { return drop(t, 16); }}}};
}

}  // namespace tumble::accuracy
