// Bodies that a script created in one spot.
#include <random>

#include "physics/physical.h"

using namespace tumble;

namespace {

// All within a millimetre of a point five metres up.
std::vector<BodyId> burst(Scene& scene, const BodyDef& def, int count) {
  std::mt19937 random(23);
  std::uniform_real_distribution<double> off(-1e-3, 1e-3);
  std::vector<BodyId> bodies;
  for (int i = 0; i < count; ++i) {
    const Vec3 by{off(random), off(random), off(random)};
    bodies.push_back(scene.add(def, Vec3{0, 5, 0} + by));
  }
  return bodies;
}

}  // namespace

TEST_CASE("crowds: balls that were created in one spot come apart, and are not thrown", "[physics]") {
  Scene scene;
  scene.floor();
  constexpr double radius = 0.25;
  const std::vector<BodyId> balls = burst(scene, body(ball(radius)), 150);

  double fastest = 0;
  for (int tick = 0; tick < 240; ++tick) {
    scene.world.step(kTick);
    for (const BodyId id : balls) fastest = std::max(fastest, length(scene.world.velocity(id)));
  }

  double nearest = INFINITY;
  for (std::size_t i = 0; i < balls.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) nearest = std::min(nearest, distance(scene.at(balls[i]), scene.at(balls[k])));
  CHECK(nearest > 0.99 * 2 * radius);
  CHECK(fastest < 15);  // from five metres a ball falls with 9.9 m/s
}

TEST_CASE("crowds: those who overlap are told so, each pair once", "[physics]") {
  Scene scene(weightless());
  constexpr int count = 60;
  burst(scene, body(ball(0.25)), count);
  scene.world.step(kTick);

  CHECK(tumble::count(scene.world.take_events().contacts, EventKind::enter, false) == count * (count - 1) / 2);
  scene.world.step(kTick);
  CHECK(scene.world.take_events().contacts.empty());
}

TEST_CASE("crowds: many that lie deep in one large body are no crowd", "[physics]") {
  // Each is pushed out as one alone would be.
  const auto height_after = [](int rows) {
    Scene scene;
    scene.floor();
    BodyDef plate = body(box({8, 0.4, 8}));
    plate.mass = 1e5;
    scene.add(plate, {0, 0.2, 0});
    std::vector<BodyId> boxes;
    for (int x = 0; x < rows; ++x)
      for (int z = 0; z < rows; ++z) boxes.push_back(scene.add(body(box({0.3, 0.3, 0.3})), {x - 2.5, 0.4 + 0.05, z - 2.5}));
    scene.run(0.5);
    double lowest = INFINITY;
    for (const BodyId id : boxes) lowest = std::min(lowest, scene.at(id).y);
    return lowest;
  };
  CHECK(height_after(6) == Approx(height_after(1)).margin(1e-3));
}
