#include "scene/scene.h"

#include <catch2/catch.hpp>

using namespace tumble;

namespace {

std::vector<std::string> paths(const Scene& scene, const std::vector<NodeId>& nodes) {
  std::vector<std::string> result;
  for (const NodeId node : nodes) result.push_back(scene.path(node));
  return result;
}

// level/door/handle, level/window/handle, lamp
struct House : Scene {
  NodeId level = add("level"), door = add("door", level), handle = add("handle", door), window = add("window", level),
         other_handle = add("handle", window), lamp = add("lamp");
};

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("scene: a path goes from the root down", "[scene]") {
  const House scene;

  CHECK(scene.path(scene.handle) == "level/door/handle");
  CHECK(scene.path(scene.root()).empty());
}

TEST_CASE("scene: a node is found by its name, by the end of its path and by its whole path", "[scene]") {
  const House scene;

  CHECK(scene.find("door") == scene.door);
  CHECK(scene.find("door/handle") == scene.handle);
  CHECK(scene.find("level/window/handle") == scene.other_handle);
  CHECK(scene.find("handle", scene.window) == scene.other_handle);
  CHECK_FALSE(scene.find("lamp", scene.level));
  CHECK_FALSE(scene.find("lamp/handle"));
  CHECK_FALSE(scene.find(""));
}

TEST_CASE("scene: a whole path means its own node, not a longer one that ends so", "[scene]") {
  House scene;
  const NodeId inner = scene.add("level", scene.lamp);
  const NodeId inner_door = scene.add("door", inner);

  CHECK(scene.find_all("level/door") == std::vector<NodeId>{scene.door});
  CHECK(scene.find_all("lamp/level/door") == std::vector<NodeId>{inner_door});
  CHECK(scene.find_all("door") == std::vector<NodeId>{scene.door, inner_door});
}

TEST_CASE("scene: get names what is near where there is no such node", "[scene]") {
  const House scene;

  CHECK_THROWS_WITH(scene.get_by_path("dor", {}, "scene.get"), "scene.get: no node 'dor'; did you mean 'door'?");
  CHECK_THROWS_WITH(scene.get_by_path("lamp", scene.level, "node:get"), "node:get: no node 'lamp' below 'level'");
}

TEST_CASE("scene: get lists the paths of nodes that share a name", "[scene]") {
  const House scene;

  CHECK_THROWS_WITH(scene.get_by_path("handle", {}, "scene.get"),
                    "scene.get: 2 nodes fit 'handle': 'level/door/handle', 'level/window/handle'; rename some or give a longer path");
}

TEST_CASE("scene: a renamed node is found under its new name only", "[scene]") {
  House scene;

  scene.rename(scene.lamp, "sun");

  CHECK(scene.find("sun") == scene.lamp);
  CHECK_FALSE(scene.find("lamp"));
}

TEST_CASE("scene: a name may not look like a path", "[scene]") {
  Scene scene;

  CHECK_THROWS_WITH(scene.add("a/b"), "name 'a/b' must not contain '/', which parts the names in a path");
}

TEST_CASE("scene: a node without a name goes by its id", "[scene]") {
  Scene scene;
  const NodeId node = scene.add("", {}, "crate7");

  CHECK(scene.path(node) == "crate7");
  CHECK(scene.find("crate7") == node);
}

TEST_CASE("scene: tagged nodes come in tree order, whatever their age", "[scene]") {
  House scene;
  const NodeId late = scene.add("late", scene.door);
  for (const NodeId node : {scene.lamp, late, scene.window}) scene[node].tags = {"lit"};

  CHECK(paths(scene, scene.tagged("lit")) == Names{"level/door/late", "level/window", "lamp"});
}

TEST_CASE("scene: equal ids are refused with the node that has it", "[scene]") {
  House scene;
  scene.set_id(scene.door, "a1");

  CHECK_THROWS_WITH(scene.add("second", {}, "a1"),
                    "id 'a1' is taken by node 'level/door'; every id may stand once in a scene: change or leave out one of them");
  CHECK_FALSE(scene.find("second"));
}

TEST_CASE("scene: an id that was made up yields to an equal one from a file", "[scene]") {
  Scene scene;
  const NodeId first = scene.add("first");
  const std::string made = scene[first].id;

  const NodeId second = scene.add("second", {}, made);

  CHECK(scene.find_id(made) == second);
  CHECK(scene[first].id != made);
  CHECK(scene.find_id(scene[first].id) == first);
}

TEST_CASE("scene: removal takes descendants along and ends their handles", "[scene]") {
  House scene;
  const std::size_t before = scene.size();

  scene.remove(scene.level);

  CHECK(scene.size() == before - 5);
  CHECK(scene.get(scene.handle) == nullptr);
  CHECK_FALSE(scene.find("handle"));
  CHECK(scene[scene.root()].children == std::vector<NodeId>{scene.lamp});
}

TEST_CASE("scene: a kept handle names the node again that is added under it", "[scene]") {
  House scene;
  const std::uint64_t age = scene[scene.lamp].serial;

  scene.remove(scene.lamp, [](NodeId) { return true; });
  const NodeId other = scene.add("other");
  scene.add("lamp", {}, "", scene.lamp, age);

  CHECK_FALSE(other == scene.lamp);
  CHECK(scene[scene.lamp].name == "lamp");
  CHECK(scene[scene.lamp].serial == age);
  scene.sort_children(scene.root());
  CHECK(scene[scene.root()].children == std::vector<NodeId>{scene.level, scene.lamp, other});
}

TEST_CASE("scene: a node cannot hang below itself", "[scene]") {
  House scene;

  CHECK_THROWS_WITH(scene.set_parent(scene.level, scene.handle, true),
                    "node.parent: 'level/door/handle' is below 'level'; a node cannot hang below itself");
  CHECK_THROWS_WITH(scene.set_parent(scene.level, scene.level, true),
                    "node.parent: 'level' is the node itself; a node cannot hang below itself");
}

TEST_CASE("scene: a node is enabled while all above it are", "[scene]") {
  House scene;

  scene[scene.level].enabled = false;

  CHECK_FALSE(scene.enabled_in_tree(scene.handle));
  CHECK(scene.enabled_in_tree(scene.lamp));
}
