// What rests lies on what is below it, not in it by what a soft contact gives way.
#include "physics/physical.h"

using namespace tumble;

namespace {

// How deep each box of a tower lies in the one below, m.
std::vector<double> depths(const Scene& scene, const std::vector<BodyId>& tower) {
  std::vector<double> all;
  for (std::size_t i = 0; i < tower.size(); ++i) {
    const double below = i == 0 ? -0.5 : scene.at(tower[i - 1]).y;
    all.push_back(below + 1 - scene.at(tower[i]).y);
  }
  return all;
}

Scene awake() {
  WorldSettings settings;
  settings.sleeping = false;
  return Scene(settings);
}

}  // namespace

TEST_CASE("lift: a tower's weight does not press its boxes into each other", "[physics]") {
  Scene scene = awake();
  scene.floor();
  std::vector<BodyId> tower;
  for (int i = 0; i < 8; ++i) tower.push_back(scene.add(body(box({1, 1, 1})), {0, 0.5 + i, 0}));

  scene.run(6);

  // A spring that swings 0.25 times in a substep of 1/240 s gives way by g over its frequency squared for each box on it:
  // by 0.55 mm under eight. What is left is what touches by, 0.05 mm.
  for (const double depth : depths(scene, tower)) CHECK(depth == Approx(5e-5).margin(3e-5));
}

TEST_CASE("lift: bodies that were put into each other are pushed out and not thrown", "[physics]") {
  Scene scene = awake();
  scene.floor();
  const BodyId deep = scene.add(body(box({1, 1, 1})), {0, 0.3, 0});
  std::vector<BodyId> tower;
  for (int i = 0; i < 4; ++i) tower.push_back(scene.add(body(box({1, 1, 1})), {3, 0.5 + 0.9 * i, 0}));

  double highest = 0, top = 0;
  for (int i = 0; i < 240; ++i) {
    scene.run(kTick);
    highest = std::max(highest, scene.at(deep).y);
    top = std::max(top, scene.at(tower.back()).y);
  }

  CHECK(highest < 0.5 + 1e-3);
  CHECK(top < 3.5 + 4e-3);  // four gaps of that kind
  for (const double depth : depths(scene, tower)) CHECK(depth == Approx(5e-5).margin(1e-4));
}

TEST_CASE("lift: is gone once the load is", "[physics]") {
  Scene scene = awake();
  scene.floor();
  std::vector<BodyId> tower;
  for (int i = 0; i < 8; ++i) tower.push_back(scene.add(body(box({1, 1, 1})), {0, 0.5 + i, 0}));
  scene.run(4);

  for (std::size_t i = 1; i < tower.size(); ++i) scene.world.remove(tower[i]);
  double highest = 0;
  for (int i = 0; i < 120; ++i) {
    scene.run(kTick);
    highest = std::max(highest, scene.at(tower[0]).y);
  }

  CHECK(highest < 0.5 + 1e-3);
  CHECK(scene.at(tower[0]).y == Approx(0.5).margin(1e-4));
}
