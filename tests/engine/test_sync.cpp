#include "test_engine_support.h"

using namespace tumble;

namespace {

Map box(const char* name, Vec3 position, const Value& body) {
  return {{"name", name}, {"position", position}, {"mesh", "box"}, {"body", body}};
}
const Value kFloating = Map{{"gravity_factor", 0}};

}  // namespace

TEST_CASE("sync: a falling body moves its node and the nodes below it", "[engine]") {
  PlainGame game;
  const NodeId parent = game.make({{"position", Vec3{0, 100, 0}}});
  const NodeId ball = game.make(box("ball", {0, 0, 0}, "dynamic"), parent);
  const NodeId hat = game.make({{"name", "hat"}, {"position", Vec3{0, 1, 0}}}, ball);

  game.run(60);

  // One second of free fall in steps of h and substeps: g/2 and a little more, at most g h / 2.
  const double fall = 100 - game.place(ball).y;
  CHECK(fall >= 9.81 / 2 - 1e-9);
  CHECK(fall <= 9.81 / 2 + 9.81 * PlainGame::kTick / 2 + 1e-9);
  CHECK(game.place(hat).y == Approx(game.place(ball).y + 1));
  CHECK(game.scene[ball].local.position.y == Approx(-fall));
}

TEST_CASE("sync: a dynamic body owns its pose; a parent that moves leaves it behind", "[engine]") {
  PlainGame game;
  const NodeId parent = game.make({{"name", "parent"}});
  const NodeId ball = game.make(box("ball", {1, 0, 0}, kFloating), parent);

  game.tick_with([&] { game.set_position(parent, {0, 50, 0}); });

  CHECK(game.place(ball) == Vec3{1, 0, 0});
  CHECK(game.world()->pose(game.body(ball)->id).position == Vec3{1, 0, 0});
}

TEST_CASE("sync: writing a dynamic body's position is a jump, seen at once by queries, that keeps the velocity", "[engine]") {
  PlainGame game;
  const NodeId ball = game.make(box("ball", {}, Map{{"gravity_factor", 0}, {"velocity", Vec3{1, 0, 0}}}));
  game.run(1);

  game.begin_tick();
  game.set_position(ball, {0, 10, 0});

  CHECK(game.world()->raycast_any({0, 20, 0}, {0, -1, 0}, 15));
  CHECK(game.velocity(ball) == Vec3{1, 0, 0});
  CHECK(game.scene.interpolated_world(ball, 0).position == Vec3{0, 10, 0});
}

TEST_CASE("sync: a dynamic body below another is told to be a joint's or a collider's job", "[engine]") {
  PlainGame game;
  const NodeId car = game.make(box("car", {}, "dynamic"));

  game.make(box("wheel", {0, -1, 0}, "dynamic"), car);

  REQUIRE(game.lines.size() == 1);
  CHECK(game.lines[0] == "node 'car/wheel': a dynamic body does not follow the dynamic body 'car' above it; use a joint or a second collider");
}

TEST_CASE("sync: a kinematic body follows its node with the velocity of the motion, and then stands still", "[engine]") {
  PlainGame game;
  const NodeId lift = game.make(box("lift", {}, "kinematic"));
  game.run(1);

  game.tick_with([&] { game.set_position(lift, {0, 0.1, 0}); });
  CHECK(game.velocity(lift).y == Approx(6).epsilon(1e-6));  // 0.1 m in 1/60 s
  CHECK(game.world()->pose(game.body(lift)->id).position.y == Approx(0.1));

  game.run(1);
  CHECK(length(game.velocity(lift)) == Approx(0).margin(1e-9));
  CHECK(game.place(lift) == Vec3{0, 0.1, 0});
}

TEST_CASE("sync: a kinematic body carries what stands on it, also when its parent is what moves", "[engine]") {
  PlainGame game;
  const NodeId carousel = game.make({{"name", "carousel"}});
  game.make({{"name", "plate"}, {"mesh", Map{{"shape", "box"}, {"size", Vec3{4, 1, 4}}}}, {"body", "kinematic"}}, carousel);
  const NodeId rider = game.make(box("rider", {0, 1, 0}, "dynamic"));
  game.run(30);

  for (int i = 1; i <= 60; ++i) game.tick_with([&] { game.set_position(carousel, {i / 60.0, 0, 0}); });

  // It is dragged along by friction 0.25 g, which reaches 1 m/s in 0.41 s and slips 0.2 m until then.
  CHECK(game.place(rider).x > 0.7);
  CHECK(game.place(rider).x < 1.05);
}

TEST_CASE("sync: teleport on a kinematic body carries nothing and leaves no velocity", "[engine]") {
  PlainGame game;
  const NodeId lift = game.make(box("lift", {}, "kinematic"));
  game.run(1);

  game.tick_with([&] { game.teleport(lift, {0, 5, 0}, std::nullopt); });

  CHECK(length(game.velocity(lift)) == 0);
  CHECK(game.world()->pose(game.body(lift)->id).position == Vec3{0, 5, 0});
}

TEST_CASE("sync: teleporting an ancestor makes kinematic bodies below it jump", "[engine]") {
  PlainGame game;
  const NodeId parent = game.make({{"name", "parent"}});
  const NodeId lift = game.make(box("lift", {1, 0, 0}, "kinematic"), parent);
  game.run(1);

  game.tick_with([&] { game.teleport(parent, {0, 5, 0}, std::nullopt); });

  CHECK(length(game.velocity(lift)) == 0);
  CHECK(game.world()->pose(game.body(lift)->id).position == Vec3{1, 5, 0});
}

TEST_CASE("sync: a kinematic body below a dynamic one follows it", "[engine]") {
  PlainGame game;
  const NodeId car = game.make(box("car", {}, Map{{"gravity_factor", 0}, {"velocity", Vec3{6, 0, 0}}}));
  const NodeId arm = game.make(box("arm", {0, 3, 0}, "kinematic"), car);

  game.run(60);

  CHECK(game.place(arm).x == Approx(game.place(car).x));
  // The world hears of it at the next step: one tick of 6 m/s behind.
  CHECK(game.world()->pose(game.body(arm)->id).position.x == Approx(game.place(car).x - 0.1).margin(1e-6));
}

TEST_CASE("sync: a static body that is written stands elsewhere and wakes what slept on it", "[engine]") {
  PlainGame game;
  const NodeId floor = game.make({{"mesh", Map{{"shape", "box"}, {"size", Vec3{9, 1, 9}}}}, {"body", "static"}});
  const NodeId crate = game.make(box("crate", {0, 1, 0}, "dynamic"));
  game.run(300);
  REQUIRE(game.world()->asleep(game.body(crate)->id));

  game.tick_with([&] { game.set_position(floor, {0, -20, 0}); });
  game.run(30);

  CHECK(game.place(crate).y < 0.5);
}

TEST_CASE("sync: a static body written in sixty ticks in a row gets one hint", "[engine]") {
  PlainGame game;
  const NodeId wall = game.make(box("wall", {}, "static"));

  for (int i = 1; i <= 59; ++i) game.tick_with([&] { game.set_position(wall, {0.01 * i, 0, 0}); });
  CHECK(game.lines.empty());
  for (int i = 60; i <= 200; ++i) game.tick_with([&] { game.set_position(wall, {0.01 * i, 0, 0}); });

  REQUIRE(game.lines.size() == 1);
  CHECK(game.lines[0] == "node 'wall': its static body has been moved in 60 ticks in a row; with body = \"kinematic\" it pushes and carries "
                         "what it touches");
}

TEST_CASE("sync: a body that was moved while disabled is at its node when it is enabled", "[engine]") {
  PlainGame game;
  const NodeId lift = game.make(box("lift", {}, "kinematic"));
  game.set_enabled(lift, false);
  game.tick_with([&] { game.set_position(lift, {0, 8, 0}); });
  game.set_enabled(lift, true);
  game.run(1);

  CHECK(game.world()->pose(game.body(lift)->id).position == Vec3{0, 8, 0});
  CHECK(length(game.velocity(lift)) == 0);
}

TEST_CASE("sync: world positions and rotations are written through the parent", "[engine]") {
  PlainGame game;
  const NodeId parent = game.make({{"position", Vec3{1, 0, 0}}, {"rotation_degrees", Vec3{0, 90, 0}}, {"scale", Vec3{2, 2, 2}}});
  const NodeId child = game.make({{"name", "child"}}, parent);

  game.set_world_position(child, {1, 0, -4});
  game.set_world_rotation(child, {});

  CHECK(distance(game.scene[child].local.position, {2, 0, 0}) < 1e-12);
  CHECK(distance(game.scene.world(child).rotation * Vec3{0, 0, -1}, {0, 0, -1}) < 1e-12);
}

TEST_CASE("sync: a parent must be alive, and the root has none", "[engine]") {
  PlainGame game;
  const NodeId wall = game.make(box("wall", {}, "static"));
  const NodeId gone = game.make({{"name", "gone"}});
  game.destroy(gone);

  CHECK_THROWS_AS(game.set_parent(wall, gone), Error);
  CHECK_THROWS_AS(game.set_parent(game.scene.root(), wall), Error);
}

TEST_CASE("sync: a new parent leaves a node and its body where they are", "[engine]") {
  PlainGame game;
  const NodeId parent = game.make({{"position", Vec3{7, 0, 0}}});
  const NodeId wall = game.make(box("wall", {1, 2, 3}, "static"));

  game.tick_with([&] { game.set_parent(wall, parent); });

  CHECK(game.place(wall) == Vec3{1, 2, 3});
  CHECK(game.scene[wall].local.position == Vec3{-6, 2, 3});
}
