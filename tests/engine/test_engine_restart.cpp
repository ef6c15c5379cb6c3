#include "test_engine_support.h"

using namespace tumble;

namespace {

// A declared ball that falls on a declared floor, with a hinge door.
struct Court : PlainGame {
  NodeId floor = declare({{"name", "floor"}, {"position", Vec3{0, -1, 0}}, {"mesh", Map{{"shape", "box"}, {"size", Vec3{9, 1, 9}}}}, {"body", "static"}});
  NodeId ball = declare({{"name", "ball"}, {"id", "B"}, {"position", Vec3{0, 3, 0}}, {"mesh", "sphere"}, {"color", "orange"},
                         {"body", Map{{"restitution", 0.5}, {"velocity", Vec3{1, 0, 0}}}}});
  NodeId door = declare({{"name", "door"}, {"position", Vec3{3, 3, 0}}, {"mesh", "box"}, {"body", "dynamic"}});
  JointRef hinge = tie("hinge", door, {}, {{"anchor", Vec3{-0.5, 0, 0}}, {"axis", Vec3{0, 0, 1}}}, Origin::declared);
};

}  // namespace

TEST_CASE("restart: declared nodes get back what they were, in place", "[engine]") {
  Court game;
  game.run(40);
  game.set(game.ball, "color", "red");
  game.set(game.ball, "name", "moon");
  game.set(game.ball, "body.mass", 9);
  game.set(game.ball, "scale", Vec3{2, 2, 2});
  game.set(game.floor, "body", {});
  game.set(game.floor, "enabled", false);

  game.restart_scene();

  CHECK(game.scene.find("ball") == game.ball);
  CHECK(game.scene[game.ball].local == Transform{{0, 3, 0}, {}, {1, 1, 1}});
  CHECK(game.scene[game.ball].material->color == *parse_color("orange"));
  CHECK_FALSE(game.body(game.ball)->def.mass);
  CHECK(game.velocity(game.ball) == Vec3{1, 0, 0});
  CHECK(game.body(game.floor) != nullptr);
  CHECK(game.scene[game.floor].enabled);
}

TEST_CASE("restart: what follows is what followed the first start, to the last digit", "[engine]") {
  Court game;
  std::vector<std::uint64_t> first, second;
  for (int i = 0; i < 90; ++i) {
    game.run(1);
    first.push_back(game.world()->hash());
  }
  game.make({{"mesh", "box"}, {"position", Vec3{1, 1, 0}}, {"body", "dynamic"}});
  game.run(50);

  game.restart_scene();
  for (int i = 0; i < 90; ++i) {
    game.run(1);
    second.push_back(game.world()->hash());
  }

  CHECK(first == second);
}

TEST_CASE("restart: destroyed nodes and joints come back under their handles, at their old places in the tree", "[engine]") {
  Court game;
  const auto order = game.scene[game.scene.root()].children;
  game.destroy(game.door);
  game.destroy(game.floor);
  game.end_tick();
  CHECK(game.joint(game.hinge) == nullptr);
  game.make({{"name", "late"}});

  game.restart_scene();

  CHECK(game.alive(game.door));
  CHECK(game.scene[game.scene.root()].children == order);
  REQUIRE(game.joint(game.hinge));
  CHECK(game.joint(game.hinge)->id);
  CHECK(game.joints_of(game.door) == std::vector<JointRef>{game.hinge});
}

TEST_CASE("restart: a node that is just dying lives on", "[engine]") {
  Court game;
  game.destroy(game.ball);

  game.restart_scene();

  CHECK(game.alive(game.ball));
  CHECK(game.end_tick().empty());
}

TEST_CASE("restart: added nodes and joints go, and are told", "[engine]") {
  Court game;
  const NodeId coin = game.make({{"name", "coin"}}, game.ball);
  const JointRef rope = game.tie("ball", game.ball, {});

  game.restart_scene();

  CHECK(game.scene.get(coin) == nullptr);
  CHECK(game.joint(rope) == nullptr);
  CHECK(game.has_removals());
  CHECK(game.finish_removals() == std::vector<NodeId>{coin});
}

TEST_CASE("restart: a declared node that hung below an added one is saved", "[engine]") {
  Court game;
  const NodeId bag = game.make({{"name", "bag"}});
  game.set_parent(game.ball, bag);

  game.restart_scene();

  CHECK(game.scene[game.ball].parent == game.scene.root());
  CHECK(game.place(game.ball) == Vec3{0, 3, 0});
}

TEST_CASE("restart: a joint's motor and limits are those of its options again", "[engine]") {
  Court game;
  game.set_joint_field(game.hinge, "max", 0.1, "joint");

  game.restart_scene();

  CHECK_FALSE(std::get<HingeDef>(game.joint(game.hinge)->def.kind).angle.max);
}

TEST_CASE("restart: an id that an added node took meanwhile goes back to its owner", "[engine]") {
  Court game;
  game.destroy(game.ball);
  game.end_tick();
  game.make({{"name", "thief"}, {"id", "B"}});

  game.restart_scene();

  CHECK(game.scene.find_id("B") == game.ball);
}

TEST_CASE("restart: what a reload changed is the first state from then on", "[engine]") {
  Court game;
  game.update_first_state(game.ball, "position", Vec3{0, 7, 0});
  game.update_first_state(game.ball, "body.mass", 4);
  game.update_first_state(game.ball, "color", "blue");
  game.update_first_state(game.hinge, Map{{"max", 1}});

  game.restart_scene();

  CHECK(game.place(game.ball) == Vec3{0, 7, 0});
  CHECK(*game.body(game.ball)->def.mass == 4);
  CHECK(game.scene[game.ball].material->color == Color{0, 0, 1, 1});
  CHECK(*std::get<HingeDef>(game.joint(game.hinge)->def.kind).angle.max == 1);
}

TEST_CASE("restart: a forgotten declaration does not come back, and its handle is free", "[engine]") {
  Court game;
  game.destroy(game.door);
  game.end_tick();
  game.forget_first_state(game.door);
  game.forget_first_state(game.hinge);

  game.restart_scene();

  CHECK(game.scene.get(game.door) == nullptr);
  CHECK(game.joint(game.hinge) == nullptr);
  CHECK(game.make({{"name", "new"}}).index == game.door.index);
}

TEST_CASE("restart: a game without bodies has no world afterwards either", "[engine]") {
  PlainGame game;
  game.declare({{"name", "a"}});
  game.make({{"mesh", "box"}, {"body", "dynamic"}});

  game.restart_scene();
  game.run(1);

  CHECK(game.world() == nullptr);
}
