#include "engine/scene_file.h"
#include "engine/json.h"

#include <catch2/catch.hpp>

using namespace tumble;

namespace {

using Files = std::map<std::string, std::string>;

FileReader reader(const Files& files) {
  return [files](const std::string& path) -> std::optional<std::string> {
    const auto found = files.find(path);
    return found == files.end() ? std::nullopt : std::optional(found->second);
  };
}

NodeDef load(const Files& files, const std::string& path = "one") { return load_scene_file(path, reader(files), "scene.load"); }

std::string error(const Files& files, const std::string& path = "one") {
  try {
    load(files, path);
  } catch (const Error& e) {
    return e.what();
  }
  return "no error";
}

// The only child's def, of a scene with a copy of this prefab under these keys.
NodeDef copy(const std::string& prefab, const std::string& keys) {
  return load({{"one.json", R"({"tumble": 1, "children": [{"prefab": "coin", )" + keys + "}]}"},
               {"coin.json", R"({"tumble": 1, )" + prefab + "}"}}).children.at(0);
}

}  // namespace

TEST_CASE("scene file: nodes are read with their short forms", "[engine]") {
  const NodeDef root = load({{"levels/one.json", R"({ "tumble": 1, "name": "one", "children": [
      { "name": "ground", "position": [0, -0.25, 0], "color": "seagreen", "body": "static", "tags": "floor",
        "mesh": { "shape": "box", "size": [12, 0.5, 12] } },
      { "name": "camera", "rotation_degrees": [0, 90, 0], "camera": { "field_of_view_degrees": 65 } } ] })"}}, "levels/one");

  CHECK(root.name == "one");
  const NodeDef& ground = root.children.at(0);
  CHECK(ground.position == Vec3{0, -0.25, 0});
  CHECK(ground.body->type == BodyType::fixed);
  CHECK(ground.tags == std::vector<std::string>{"floor"});
  CHECK(ground.mesh->size == Vec3{12, 0.5, 12});
  CHECK(root.children.at(1).camera->field_of_view == Approx(radians(65)));
}

TEST_CASE("scene file: the version is required and must be understood", "[engine]") {
  CHECK(error({{"one.json", "{}"}}) == "one.json: the version is missing; a scene file begins with \"tumble\": 1");
  CHECK(error({{"one.json", R"({"tumble": 2})"}}) ==
        "one.json: written for version 2 of scene files; this runtime reads up to 1, use a newer one");
  CHECK(error({{"one.json", R"({"tumble": "x"})"}}) == "one.json: tumble: version number expected, got \"x\"; write \"tumble\": 1");
  CHECK(error({{"one.json", "[]"}}) == "one.json: a scene file is one node table (got a list)");
}

TEST_CASE("scene file: mistakes are told with file and path", "[engine]") {
  CHECK(error({{"one.json", R"({"tumble": 1, "children": [{}, {"body": {"mas": 1}}]})"}}) ==
        "one.json: children[2].body has no field 'mas'; did you mean 'mass'?");
  CHECK(error({{"one.json", R"({"tumble": 1, "children": [{"tumble": 1}]})"}}).find("one.json: children[1] has no field 'tumble'") == 0);
  CHECK(error({{"one.json", R"({"tumble": 1, "scale": [1, 0, 1]})"}}) == "one.json: scale.y must be above 0 (got 0)");
  CHECK(error({{"one.json", R"({"tumble": 1, "behaviours": {"coin": 5}})"}}) ==
        "one.json: behaviours.coin: table of properties expected, got a number; write {} for none");
  CHECK(error({{"one.json", "{\n\"tumble\" 1}"}}).find("one.json:2:10: not JSON") == 0);
}

TEST_CASE("scene file: paths stay in the game and have no ending", "[engine]") {
  CHECK(error({}, "one") == "scene.load: no file 'one.json'");
  CHECK(error({}, "../one").find("scene.load: file '../one': '..' is not allowed") == 0);
  CHECK(error({}, "/one").find("scene.load: file '/one': ") == 0);
  CHECK(error({}, "one.json") == "scene.load: scenes and prefabs are written without '.json' (got 'one.json')");
  CHECK(error({{"one.json", R"({"tumble": 1, "children": [{}, {"prefab": "con"}]})"}}) ==
        "one.json: children[2]: prefab: no file 'con.json'");
}

TEST_CASE("prefab: a copy overrides field by field", "[engine]") {
  const NodeDef coin = copy(R"("name": "coin", "material": {"color": "gold", "metalness": 0.8}, "mesh": "cylinder",
                               "body": {"type": "static", "trigger": true})",
                            R"("name": "coin 1", "position": [2, 0, 0], "material": {"metalness": 0.5}, "mesh": {"radius": 2},
                               "body": {"type": "kinematic"})");

  CHECK(coin.name == "coin 1");
  CHECK(coin.position == Vec3{2, 0, 0});
  CHECK(coin.material->color == parse_color("gold"));
  CHECK(coin.material->metalness == 0.5);
  CHECK(coin.mesh->shape == ShapeKind::cylinder);
  CHECK(coin.mesh->radius == 2);
  CHECK(coin.body->type == BodyType::kinematic);
  CHECK(coin.body->trigger);
  CHECK(coin.prefab == "coin");
}

TEST_CASE("prefab: behaviours merge property by property, lists are replaced", "[engine]") {
  const NodeDef coin = copy(R"("tags": ["a", "b"], "behaviours": {"pickup": {"value": 1, "sound": "x"}, "spin": {}, "glow": {}})",
                            R"("tags": "c", "behaviours": {"pickup": {"value": 5}, "fly": {}, "glow": null})");

  CHECK(coin.tags == std::vector<std::string>{"c"});
  CHECK(coin.behaviours.at("pickup") == Value(Map{{"value", 5}, {"sound", "x"}}));
  CHECK(coin.behaviours.count("spin") == 1);
  CHECK(coin.behaviours.count("fly") == 1);
  CHECK(coin.behaviours.count("glow") == 0);
}

TEST_CASE("prefab: children of the same name merge, others are appended", "[engine]") {
  const NodeDef chest = copy(R"("children": [{"name": "lid", "color": "red", "position": [0, 1, 0]}, {"name": "lock"}])",
                             R"("children": [{"name": "gem"}, {"name": "lid", "color": "blue"}])");

  REQUIRE(chest.children.size() == 3);
  CHECK(chest.children[0].color == parse_color("blue"));
  CHECK(chest.children[0].position == Vec3{0, 1, 0});
  CHECK(chest.children[1].name == "lock");
  CHECK(chest.children[2].name == "gem");
}

TEST_CASE("prefab: null takes a component away", "[engine]") {
  CHECK_FALSE(copy(R"("body": "static", "mesh": "box")", R"("body": null)").body);
}

TEST_CASE("prefab: an angle is overridden under either of its names", "[engine]") {
  const NodeDef lamp = copy(R"("light": {"type": "spot", "angle_degrees": 30}, "rotation_degrees": [0, 90, 0])",
                            R"("light": {"angle": 1}, "rotation": [0, 0, 0, 1])");

  CHECK(lamp.light->angle == 1);
  CHECK(lamp.light->type == LightType::spot);
  CHECK(lamp.rotation == Quat{});
}

TEST_CASE("prefab: the copy's colour holds under either of its names", "[engine]") {
  const NodeDef coin = copy(R"("color": "gold")", R"("material": "red")");

  CHECK_FALSE(coin.color);
  CHECK(coin.material->color == parse_color("red"));
  CHECK(copy(R"("color": "gold")", R"("material": {"glow": 1})").color == parse_color("gold"));
}

TEST_CASE("prefab: prefabs may hold prefabs", "[engine]") {
  const NodeDef root = load({{"one.json", R"({"tumble": 1, "prefab": "two", "name": "top"})"},
                             {"two.json", R"({"tumble": 1, "prefab": "three", "color": "red"})"},
                             {"three.json", R"({"tumble": 1, "body": {"mass": 3}, "color": "blue"})"}});

  CHECK(root.name == "top");
  CHECK(root.color == parse_color("red"));
  CHECK(root.body->mass == 3);
}

TEST_CASE("prefab: a circle is refused with the chain", "[engine]") {
  const Files files = {{"a.json", R"({"tumble": 1, "children": [{"prefab": "b"}]})"}, {"b.json", R"({"tumble": 1, "prefab": "a"})"}};

  CHECK(error(files, "a") == "b.json: prefab: prefabs hold one another in a circle (a -> b -> a); take one of them out");
}

TEST_CASE("prefab: depth and number of copies are bounded", "[engine]") {
  Files chain, bomb;
  for (int i = 0; i < 30; ++i) {
    const std::string next = R"({"prefab": "p)" + std::to_string(i + 1) + "\"}";
    chain["p" + std::to_string(i) + ".json"] = R"({"tumble": 1, "children": [)" + next + "]}";
    std::string ten = next;
    for (int k = 1; k < 10; ++k) ten += ", " + next;
    bomb["p" + std::to_string(i) + ".json"] = i < 10 ? R"({"tumble": 1, "children": [)" + ten + "]}" : R"({"tumble": 1})";
  }

  CHECK(error(chain, "p0").find("prefabs hold one another more than 16 deep") != std::string::npos);
  CHECK(error(bomb, "p0").find("prefabs give more than 100000 nodes; make fewer copies") != std::string::npos);
}

TEST_CASE("prefab: a mistake in a prefab names the prefab's file", "[engine]") {
  CHECK(error({{"one.json", R"({"tumble": 1, "children": [{"prefab": "coin"}]})"}, {"coin.json", R"({"tumble": 1, "boddy": {}})"}}) ==
        "coin.json: no field 'boddy'; did you mean 'body'?");
}

TEST_CASE("prefab: ids inside are the copy's own, and joints follow them", "[engine]") {
  const std::string door = R"("name": "door", "children": [{"name": "frame", "id": "f"},
                              {"name": "leaf", "joints": [{"type": "hinge", "b": "f"}, {"type": "fixed", "b": "door"}]}])";
  const NodeDef plain = copy(door, R"("name": "front")"), named = copy(door, R"("id": "d1")");

  CHECK(plain.children.at(0).id.empty());
  CHECK(plain.children.at(1).joints.at(0).find("b")->get<std::string>()->compare("frame") == 0);
  CHECK(plain.children.at(1).joints.at(1).find("b")->get<std::string>()->compare("front") == 0);
  CHECK(named.id == "d1");
  CHECK(named.children.at(0).id == "d1/f");
}

TEST_CASE("prefab: a script's table takes what its prefab has", "[engine]") {
  const Files files = {{"coin.json", R"({"tumble": 1, "name": "coin", "mesh": "cylinder", "behaviours": {"pickup": {}}})"}};
  const Value table = Map{{"prefab", "coin"}, {"position", Vec3{1, 2, 3}}, {"children", List{Map{{"prefab", "coin"}}}}};

  NodeDef def;
  assign(def, with_prefabs(table, reader(files), "scene.add"), "scene.add");

  CHECK(def.mesh->shape == ShapeKind::cylinder);
  CHECK(def.position == Vec3{1, 2, 3});
  CHECK(def.children.at(0).name == "coin");
  CHECK_THROWS_WITH(with_prefabs(Map{{"prefab", "con"}}, reader(files), "scene.add"), "scene.add: prefab: no file 'con.json'");
}

TEST_CASE("scene file: what is written reads back as the same scene", "[engine]") {
  const NodeDef root = load({{"one.json", R"({ "tumble": 1, "name": "one", "children": [
      { "name": "a", "id": "n1", "position": [0.1, 2, 3], "rotation_degrees": [10, 20, 30], "scale": [1, 2, 1], "color": "red",
        "body": { "mass": 2.5, "colliders": [{ "shape": "sphere", "radius": 0.4 }] }, "visible": false,
        "behaviours": { "spin": { "speed": 2.0, "count": 2 } }, "joints": [{ "type": "hinge", "b": "c", "max_degrees": 90 }] },
      { "prefab": "coin" }, { "name": "c", "light": "point", "camera": {} } ] })"},
                             {"coin.json", R"({"tumble": 1, "name": "coin", "body": "static"})"}});

  const std::string text = write_scene_file(root);
  const NodeDef again = load({{"one.json", text}});

  CHECK(write_scene_file(again) == text);
  CHECK(again.children.at(0).behaviours.at("spin").find("speed")->is<double>());
  CHECK(again.children.at(1).body->type == BodyType::fixed);
  CHECK(text.find("\"tumble\": 1") != std::string::npos);
  CHECK(text.find("prefab") == std::string::npos);
  CHECK(text.find("\"max_degrees\": 90") != std::string::npos);
  CHECK(text.find("\"rotation_degrees\": [10, 20, 30]") != std::string::npos);
}

TEST_CASE("scene file: only what differs from the defaults is written", "[engine]") {
  CHECK(write_scene_file({}) == "{\n  \"tumble\": 1\n}\n");
}
