#include <memory>

#include "physical.h"

using namespace tumble;

namespace {

// Piles, joints, triggers, removals and additions; `noise` shifts what the heap looks like, nothing else.
std::vector<std::uint64_t> messy_run(int noise) {
  std::vector<std::unique_ptr<char[]>> rubbish;
  const auto litter = [&](int i) {
    if (noise == 0) return;
    rubbish.push_back(std::make_unique<char[]>(static_cast<std::size_t>(37 * (i % 11) + 16 * noise)));
    if (rubbish.size() > 5) rubbish.erase(rubbish.begin() + i % 5);
  };
  Scene scene;
  scene.floor();
  std::vector<BodyId> bodies;
  std::vector<std::uint64_t> hashes;
  const std::vector<Shape> shapes = {box({0.5, 0.4, 0.6}), ball(0.3), upright(ShapeKind::capsule, 0.2, 0.8),
                                     upright(ShapeKind::cylinder, 0.3, 0.4), ring(0.4, 0.15)};
  for (int i = 0; i < 240; ++i) {
    litter(i);
    if (i % 6 == 0) {
      BodyDef def = body(shapes[static_cast<std::size_t>(i / 6) % shapes.size()]);
      def.restitution = 0.3;
      def.trigger = i % 42 == 0;
      bodies.push_back(scene.add(def, {0.3 * ((i / 6) % 5) - 0.6, 2 + 0.01 * i, 0.2 * ((i / 6) % 3)}, axis_angle({1, 1, 0}, 0.1 * i)));
    }
    if (i % 30 == 20 && bodies.size() > 2) {
      JointDef def;
      def.a = bodies[bodies.size() - 1];
      def.b = bodies[bodies.size() - 2];
      def.kind = BallDef{};
      scene.world.add(def, 0);
    }
    if (i % 25 == 24) {
      scene.world.remove(bodies[bodies.size() / 2]);
      bodies.erase(bodies.begin() + static_cast<std::ptrdiff_t>(bodies.size() / 2));
    }
    scene.world.step(kTick);
    hashes.push_back(scene.world.hash());
  }
  return hashes;
}

}  // namespace

TEST_CASE("determinism: the same calls give the same bits, whatever the heap looked like before", "[physics]") {
  const auto first = messy_run(0);

  CHECK(messy_run(1) == first);
  CHECK(messy_run(7) == first);
}

TEST_CASE("determinism: two worlds stepped in turn do not disturb each other", "[physics]") {
  const auto build = [](Scene& scene, Combine rule) {
    WorldSettings settings = scene.world.settings();
    settings.friction_combine = rule;
    scene.world.configure(settings);
    scene.floor();
    for (int i = 0; i < 6; ++i) scene.add(body(box({1, 1, 1})), {0.1 * i, 0.6 + 1.1 * i, 0}, axis_angle({1, 2, 3}, 0.2 * i));
  };
  Scene alone, one, other;
  build(alone, Combine::multiply);
  build(one, Combine::multiply);
  build(other, Combine::max);

  alone.run(2);
  for (int i = 0; i < 120; ++i) {
    one.world.step(kTick);
    other.world.step(kTick);
  }

  CHECK(one.world.hash() == alone.world.hash());
  CHECK(other.world.hash() != alone.world.hash());
}

TEST_CASE("determinism: a bridge of hinges gives the same bits, whatever lies in freed memory", "[physics]") {
  const auto run = [](std::size_t litter) {
    Scene scene;
    std::vector<std::uint64_t> hashes;
    BodyId before = scene.add(body(box({1, 0.2, 1}), BodyType::fixed), {0, 4, 0});
    for (int i = 1; i <= 15; ++i) {
      const BodyId plank = scene.add(body(box({0.98, 0.2, 1})), {1.0 * i, 4, 0});
      JointDef hinge;
      hinge.a = before;
      hinge.b = plank;
      hinge.anchor = {0.5, 0, 0};
      hinge.axis = {0, 0, 1};
      hinge.kind = HingeDef{};
      scene.world.add(hinge, 0);
      before = plank;
    }
    for (int i = 0; i < 40; ++i) {
      std::vector<std::vector<double>> rubbish(litter, std::vector<double>(50 + static_cast<std::size_t>(i), 1e9));
      rubbish.clear();
      scene.world.step(kTick);
      hashes.push_back(scene.world.hash());
    }
    return hashes;
  };
  const auto first = run(0);

  CHECK(run(100) == first);
}
