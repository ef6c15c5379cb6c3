#include "scene/scene.h"

#include <catch2/catch.hpp>

using namespace tumble;

namespace {

// arm > hand > finger, each one metre along x from the one above; the arm is turned by a quarter about y.
struct Arm : Scene {
  NodeId arm = add("arm"), hand = add("hand", arm), finger = add("finger", hand);
  Arm() {
    set_rotation(arm, axis_angle({0, 1, 0}, kPi / 2));
    set_position(arm, {0, 1, 0});
    set_position(hand, {1, 0, 0});
    set_position(finger, {1, 0, 0});
  }
  Vec3 place(NodeId node) const { return world(node).position; }
};

bool near(Vec3 a, Vec3 b) { return distance(a, b) < 1e-12; }

}  // namespace

TEST_CASE("transforms: world places follow the chain of parents", "[scene]") {
  Arm scene;

  // A quarter turn about y takes x to -z.
  CHECK(near(scene.place(scene.finger), {0, 1, -2}));

  scene.set_position(scene.arm, {5, 0, 0});
  CHECK(near(scene.place(scene.finger), {5, 0, -2}));
  scene.set_scale(scene.hand, {3, 3, 3});
  CHECK(near(scene.place(scene.finger), {5, 0, -4}));
}

TEST_CASE("transforms: a new parent leaves a node where it is, or takes it along", "[scene]") {
  Arm scene;
  const NodeId table = scene.add("table");
  scene.set_position(table, {0, 0, 7});

  scene.set_parent(scene.finger, table, true);
  CHECK(near(scene.place(scene.finger), {0, 1, -2}));

  scene.set_position(scene.finger, {1, 0, 0});
  scene.set_parent(scene.finger, scene.root(), false);
  CHECK(near(scene.place(scene.finger), {1, 0, 0}));
}

TEST_CASE("transforms: drawing lies between the last tick and this one", "[scene]") {
  Arm scene;
  scene.begin_tick(1);
  scene.set_position(scene.arm, {4, 1, 0});
  scene.set_position(scene.arm, {8, 1, 0});

  CHECK(near(scene.interpolated_world(scene.finger, 0.25).position, {2, 1, -2}));
  CHECK(near(scene.interpolated_world(scene.finger, 1).position, {8, 1, -2}));
  CHECK(near(scene.place(scene.finger), {8, 1, -2}));
}

TEST_CASE("transforms: what did not move in this tick is drawn where it is", "[scene]") {
  Arm scene;
  scene.begin_tick(1);
  scene.set_position(scene.arm, {4, 1, 0});
  scene.begin_tick(2);

  CHECK(near(scene.interpolated_world(scene.arm, 0).position, {4, 1, 0}));
}

TEST_CASE("transforms: a jump is not drawn in between", "[scene]") {
  Arm scene;
  scene.begin_tick(1);
  Transform there = scene[scene.arm].local;
  there.position = {100, 0, 0};
  scene.jump(scene.arm, there);

  CHECK(near(scene.interpolated_world(scene.arm, 0).position, {100, 0, 0}));
}

TEST_CASE("transforms: only watched nodes are listed, each once, also where an ancestor moved", "[scene]") {
  Arm scene;
  scene.set_watched(scene.finger, true);
  scene.take_touched();

  scene.set_position(scene.arm, {1, 0, 0});
  scene.set_position(scene.hand, {2, 0, 0});
  CHECK(scene.take_touched() == std::vector<NodeId>{scene.finger});
  CHECK(scene.take_touched().empty());

  scene.set_position(scene.arm, {2, 0, 0});
  CHECK(scene.take_touched() == std::vector<NodeId>{scene.finger});
}

TEST_CASE("transforms: a jump of an ancestor is a jump of what is watched, even after a move", "[scene]") {
  Arm scene;
  scene.set_watched(scene.finger, true);

  scene.set_position(scene.arm, {1, 0, 0});
  scene.jump(scene.arm, {});

  REQUIRE(scene.take_touched() == std::vector<NodeId>{scene.finger});
  CHECK(scene[scene.finger].jumped);
}

TEST_CASE("transforms: a free node stays in the world while its parent moves and turns", "[scene]") {
  Arm scene;
  scene.set_free(scene.hand, true);
  const Transform before = scene.world(scene.hand);

  scene.set_local(scene.arm, {{3, 4, 5}, axis_angle({1, 1, 0}, 2), {1, 1, 1}});

  CHECK(scene.place(scene.hand) == before.position);
  CHECK(near(scene.place(scene.finger), {0, 1, -2}));
  const Transform chain = scene.world(scene.arm) * scene[scene.hand].local;
  CHECK(near(chain.position, before.position));
}

TEST_CASE("transforms: a free node is drawn at rest while its parent moves", "[scene]") {
  Arm scene;
  scene.set_free(scene.hand, true);
  scene.begin_tick(1);

  scene.set_position(scene.arm, {0, 6, 0});

  CHECK(near(scene.interpolated_world(scene.hand, 0.5).position, {0, 1, -1}));
}

TEST_CASE("transforms: a free node grows with its parent and is listed for it", "[scene]") {
  Arm scene;
  scene.set_watched(scene.hand, true);
  scene.set_free(scene.hand, true);

  scene.set_scale(scene.arm, {2, 2, 2});

  CHECK(near(scene.world(scene.hand).scale, {2, 2, 2}));
  CHECK(near(scene.place(scene.hand), {0, 1, -1}));
  CHECK(scene.take_touched() == std::vector<NodeId>{scene.hand});
}

TEST_CASE("transforms: physics writes world poses, and children follow", "[scene]") {
  Arm scene;
  scene.set_watched(scene.finger, true);
  const Pose pose{{10, 0, 0}, axis_angle({0, 0, 1}, kPi / 2)};

  scene.set_from_physics(scene.hand, pose);

  CHECK(scene.place(scene.hand) == pose.position);
  CHECK(near(scene.place(scene.finger), {10, 1, 0}));
  CHECK(scene.take_touched() == std::vector<NodeId>{scene.finger});
}
