#include "engine/joint_options.h"

#include "test_engine_support.h"

using namespace tumble;

namespace {

// A post in the world's middle and a weightless-looking door beside it.
struct DoorGame : PlainGame {
  NodeId post = make({{"name", "post"}, {"mesh", "box"}, {"body", "static"}});
  NodeId door = make({{"name", "door"}, {"position", Vec3{2, 0, 0}}, {"mesh", "box"}, {"body", Map{{"gravity_factor", 0}}}});
};

JointDef read(const std::string& type, const Map& options, const Transform& a = {}) { return read_joint(type, options, a, "joint." + type); }

}  // namespace

TEST_CASE("joint: options of all kinds and of its own kind are told apart", "[engine]") {
  const JointDef def = read("hinge", {{"anchor", Vec3{1, 2, 3}}, {"axis", Vec3{0, 0, 2}}, {"max_degrees", 90}, {"break_force", 900},
                                      {"collide_connected", true}, {"motor", Map{{"target_degrees", 45}, {"torque", 60}}}});

  CHECK(def.anchor == Vec3{1, 2, 3});
  CHECK(def.break_force == 900);
  CHECK(def.collide_connected);
  const TurnDef& angle = std::get<HingeDef>(def.kind).angle;
  CHECK(*angle.max == Approx(kPi / 2));
  CHECK(*angle.motor->target == Approx(kPi / 4));
}

TEST_CASE("joint: an anchor is stretched with its node, a world anchor and axis are turned into its frame", "[engine]") {
  const Transform a{{10, 0, 0}, axis_angle({0, 1, 0}, kPi / 2), {2, 3, 4}};

  CHECK(read("ball", {{"anchor", Vec3{1, 1, 1}}}, a).anchor == Vec3{2, 3, 4});
  // Looking along a's x axis, which points to the world's -z.
  const JointDef def = read("hinge", {{"world_anchor", Vec3{10, 5, -1}}, {"world_axis", Vec3{0, 0, -1}}}, a);
  CHECK(distance(def.anchor, {1, 5, 0}) < 1e-12);
  CHECK(distance(def.axis, {1, 0, 0}) < 1e-12);
}

TEST_CASE("joint: mistakes in options are worded", "[engine]") {
  CHECK_THROWS_WITH(read("hinge", {{"axis", Vec3{}}}), "joint.hinge: axis must not be zero (got 0, 0, 0); give a direction such as vec3.up");
  CHECK_THROWS_WITH(read("hinge", {{"world_axis", Vec3{}}}),
                    "joint.hinge: world_axis must not be zero (got 0, 0, 0); give a direction such as vec3.up");
  CHECK_THROWS_WITH(read("hinge", {{"ancor", Vec3{}}}), "joint.hinge: no field 'ancor'; did you mean 'anchor'?");
  CHECK_THROWS_WITH(read("hinge", {{"anchor", Vec3{}}, {"world_anchor", Vec3{}}}),
                    "joint.hinge: anchor and world_anchor are given both; give one of them");
  CHECK_THROWS_WITH(read("hing", {}), Catch::Contains("did you mean 'hinge'?"));
  CHECK_THROWS_WITH(read("hinge", {{"min", 2}, {"max", 1}}), Catch::Contains("min"));
}

TEST_CASE("joint: written options read back as the same joint", "[engine]") {
  const Transform a{{10, 0, 0}, axis_angle({0, 1, 0}, kPi / 2), {2, 3, 4}};
  const JointDef def = read("slider", {{"anchor", Vec3{1, 1, 1}}, {"max", 2}, {"spring", Map{{"frequency", 3}}}, {"break_torque", 7}}, a);

  const JointDef again = read_joint("slider", write_joint(def, a), a, "test");

  CHECK(again.anchor == def.anchor);
  CHECK(again.break_torque == 7);
  CHECK(*std::get<SliderDef>(again.kind).position.max == 2);
  CHECK(std::get<SliderDef>(again.kind).position.spring->frequency == 3);
}

TEST_CASE("joint: its partners must be two, alive, and not the same", "[engine]") {
  DoorGame game;

  CHECK_THROWS_WITH(game.tie("hinge", {}, {}), Catch::Contains("a and b are both missing (nil)"));
  CHECK_THROWS_WITH(game.tie("hinge", game.door, game.door), Catch::Contains("the same node 'door'"));
  game.destroy(game.post);
  CHECK_THROWS_WITH(game.tie("hinge", game.door, game.post), Catch::Contains("one of its nodes was destroyed"));
}

TEST_CASE("joint: a hinge lets a door turn about the post and holds it there", "[engine]") {
  DoorGame game;
  game.tie("hinge", game.door, game.post, {{"world_anchor", Vec3{}}});
  game.world()->set_velocity(game.body(game.door)->id, {0, 0, -2});
  game.world()->set_angular_velocity(game.body(game.door)->id, {0, 1, 0});

  game.run(60);

  // It goes round at 1 rad/s on a circle of 2 m. A hundredth allows for the solver's drift in a second.
  CHECK(length(game.place(game.door)) == Approx(2).margin(0.02));
  CHECK(game.place(game.door).x == Approx(2 * std::cos(1.0)).margin(0.05));
}

TEST_CASE("joint: it waits until both bodies are there, and works from then on", "[engine]") {
  PlainGame game;
  const NodeId hook = game.make({{"name", "hook"}});
  const NodeId lamp = game.make({{"name", "lamp"}, {"position", Vec3{0, -1, 0}}, {"mesh", "sphere"}, {"body", "dynamic"}});
  const JointRef joint = game.tie("ball", lamp, hook, {{"world_anchor", Vec3{}}});
  CHECK_FALSE(game.joint(joint)->id);

  game.set_body(hook, PlainGame::read({{"body", Map{{"type", "static"}, {"fit", "node"}}}}).body, "node.body");
  REQUIRE(game.joint(joint)->id);
  CHECK(game.joint_of(game.joint(joint)->id) == joint);
  game.run(60);
  CHECK(game.place(lamp).y == Approx(-1).margin(0.01));

  game.set_body(hook, {}, "node.body");
  CHECK_FALSE(game.joint(joint)->id);
  game.run(60);
  CHECK(game.place(lamp).y < -3);
}

TEST_CASE("joint: a field is set live, and a wrong one changes nothing", "[engine]") {
  DoorGame game;
  const JointRef joint = game.tie("hinge", game.door, game.post, {{"world_anchor", Vec3{}}, {"motor", Map{{"target", 0}}}});

  game.set_joint_field(joint, "motor.target_degrees", 90, "joint");
  game.set_joint_field(joint, "break_force", 1e6, "joint");

  const JointDef& def = game.world()->def(game.joint(joint)->id);
  CHECK(*std::get<HingeDef>(def.kind).angle.motor->target == Approx(kPi / 2));
  CHECK(def.break_force == 1e6);
  CHECK_THROWS_WITH(game.set_joint_field(joint, "axis", Vec3{}, "joint"), Catch::Contains("axis must not be zero"));
  CHECK_THROWS_WITH(game.set_joint_field(joint, "motr.target", 1, "joint"), "joint: no field 'motr'; did you mean 'motor'?");
  CHECK(game.joint(joint)->def.axis == Vec3{0, 1, 0});

  game.run(300);
  CHECK(game.world()->state(game.joint(joint)->id).position == Approx(kPi / 2).margin(0.02));
}

TEST_CASE("joint: it goes with the first of its nodes", "[engine]") {
  DoorGame game;
  const JointRef joint = game.tie("hinge", game.door, game.post);

  game.destroy(game.post);
  game.end_tick();

  CHECK(game.joint(joint) == nullptr);
  CHECK(game.joints_of(game.door).empty());
  CHECK(game.world()->stats().joints == 0);
}

TEST_CASE("joint: found by its name from either end", "[engine]") {
  DoorGame game;
  const JointRef first = game.tie("hinge", game.door, game.post);
  const JointRef second = game.add_joint("ball", "second", game.door, {}, {}, Origin::added, "joint.ball");

  CHECK(game.find_joint(game.door, "second") == second);
  CHECK_FALSE(game.find_joint(game.post, "second"));
  CHECK(game.joints_of(game.door) == std::vector<JointRef>{first, second});
}

TEST_CASE("joint: a break frees the bodies and leaves the joint, marked", "[engine]") {
  PlainGame game;
  const NodeId lamp = game.make({{"position", Vec3{0, -1, 0}}, {"mesh", "sphere"}, {"body", Map{{"mass", 1}}}});
  const JointRef joint = game.tie("fixed", lamp, {}, {{"break_force", 5}});

  game.run(30);  // it weighs 9.81 N

  CHECK(game.joint(joint)->broken);
  CHECK(game.place(lamp).y < -1.5);
}

TEST_CASE("joint: in files it names its partner by id, name or path, in any order", "[engine]") {
  PlainGame game;
  const auto box = [](const char* name, const char* partner) {
    return Map{{"name", name}, {"mesh", "box"}, {"body", "dynamic"}, {"joints", List{Map{{"type", "fixed"}, {"name", name}, {"b", partner}}}}};
  };
  Map anchor{{"name", "anchor"}, {"id", "A1"}, {"mesh", "box"}, {"body", "static"}};

  game.make({{"name", "root"}, {"children", List{box("one", "A1"), box("two", "anchor"), box("three", "inner/anchor"), box("four", ""),
                                                 Map{{"name", "inner"}, {"children", List{anchor}}}}}});

  const NodeId target = game.scene.find("inner/anchor");
  for (const char* name : {"one", "two", "three"}) {
    const JointRef joint = game.find_joint(game.scene.find(name), name);
    REQUIRE(joint);
    CHECK(game.joint(joint)->b == target);
    CHECK(game.joint(joint)->id);
  }
  CHECK_FALSE(game.joint(game.find_joint(game.scene.find("four"), "four"))->b);
}

TEST_CASE("joint: a file's mistakes name their place", "[engine]") {
  PlainGame game;
  const auto with = [&](const Map& joint) { game.make({{"name", "r"}, {"mesh", "box"}, {"body", "dynamic"}, {"joints", List{joint}}}); };

  CHECK_THROWS_WITH(with({{"type", "hinge"}, {"b", "frme"}}), Catch::Contains("scene.add: joints[1].b: no node 'frme'"));
  CHECK_THROWS_WITH(with({{"b", ""}}), Catch::Contains("scene.add: joints[1]: type is missing"));
  CHECK_THROWS_WITH(with({{"type", "hinge"}, {"axis", Vec3{}}}), Catch::Contains("scene.add: joints[1]: axis must not be zero"));
  CHECK(game.scene.size() == 1);
}

TEST_CASE("joint: a node's def holds its joints as files do", "[engine]") {
  DoorGame game;
  game.add_joint("hinge", "hinge", game.door, game.post, Map{{"max_degrees", 90}}, Origin::added, "joint.hinge");

  const NodeDef def = game.def(game.door);

  REQUIRE(def.joints.size() == 1);
  CHECK(*def.joints[0].find("type") == Value("hinge"));
  CHECK(*def.joints[0].find("b") == Value(game.scene[game.post].id));
  CHECK(def.joints[0].find("max_degrees")->number() == Approx(90));
  CHECK(game.def(game.post).joints.empty());
}

TEST_CASE("joint: an anchor keeps its place on a body that grows", "[engine]") {
  DoorGame game;
  const JointRef joint = game.tie("ball", game.door, game.post, {{"anchor", Vec3{-0.5, 0, 0}}});

  game.tick_with([&] { game.set_scale(game.door, {2, 2, 2}); });

  CHECK(game.joint(joint)->def.anchor == Vec3{-1, 0, 0});
}
