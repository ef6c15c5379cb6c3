#include "engine/storage.h"

#include <catch2/catch.hpp>

#include <cmath>

#include "base/error.h"

using namespace tumble;
using Catch::Contains;

namespace {

Stored sample() {
  Stored stored;
  stored.values = {{"best", 12},
                   {"time", 7.0},
                   {"name", "Grüße \"x\"\n"},
                   {"muted", true},
                   {"spawn", Vec3{1, -2.5, 0.1}},
                   {"turn", Quat{0, 0.6, 0, 0.8}},
                   {"paint", Color{0.1, 0.2, 0.3, 0.4}},
                   {"scores", List{Map{{"who", "Ada"}, {"score", 3}}, Map{{"$vec3", 1}, {"at", Vec3{0, 1, 0}}}}},
                   {"odd", Map{{"$color", "no color"}}},
                   {"none", Map{}}};
  stored.bindings = {{"jump", {"k", "pad_b"}}, {"left", {}}};
  return stored;
}

Storage begun(Stored stored = {}) {
  Storage storage;
  storage.begin(std::move(stored));
  return storage;
}

}  // namespace

TEST_CASE("storage: what was written is read back equal, each value of its kind", "[engine][storage]") {
  CHECK(read_stored(write_stored(sample()), "storage.json") == sample());
  CHECK(read_stored(write_stored({}), "storage.json") == Stored{});
}

TEST_CASE("storage: a run sees what was stored and what it saves, and knows what it began with", "[engine][storage]") {
  Storage storage = begun(sample());

  storage.save("best", 20, "storage.save");
  storage.save("name", {}, "storage.save");

  CHECK(*storage.load("best") == Value(20));
  CHECK(*storage.load_first("best") == Value(12));
  CHECK(storage.load("name") == nullptr);
  CHECK(storage.first() == sample());
  CHECK(storage.take_changed());
  CHECK_FALSE(storage.take_changed());
}

TEST_CASE("storage: saving what is stored already changes nothing", "[engine][storage]") {
  Storage storage = begun(sample());

  storage.save("best", 12, "storage.save");
  storage.save("nobody", {}, "storage.save");
  storage.save_binding("jump", {"k", "pad_b"});
  storage.forget_binding("duck");

  CHECK_FALSE(storage.take_changed());
}

TEST_CASE("storage: what cannot be stored is refused with its place", "[engine][storage]") {
  Storage storage = begun();
  const auto save = [&](const Value& value) { storage.save("best", value, "storage.save"); };

  CHECK_THROWS_WITH(save(std::nan("")), Contains("storage.save: best: a finite number expected"));
  CHECK_THROWS_WITH(save(Map{{"times", List{1, INFINITY}}}), Contains("storage.save: best.times[2]: a finite number expected"));
  CHECK_THROWS_WITH(save(Map{{"who", Reference{}}}), Contains("best.who: a node cannot be stored; store its name or its position"));
  CHECK_THROWS_WITH(save("\xff"), Contains("best: the text is not UTF-8"));
  CHECK_THROWS_WITH(storage.save("", 1, "storage.save"), Contains("a key of at least one letter"));
  CHECK(storage.now() == Stored{});
}

TEST_CASE("storage: a game may store a megabyte, and removing a key makes room", "[engine][storage]") {
  Storage storage = begun();
  const std::string half(Storage::kMostBytes / 2, 'x');
  storage.save("a", half, "storage.save");

  CHECK_THROWS_WITH(storage.save("b", half, "storage.save"), Contains("storage.save: b: with it the game would store 1 MB; it may store 1 MB in all"));
  storage.save("a", "short", "storage.save");
  CHECK_NOTHROW(storage.save("b", half, "storage.save"));
  storage.save("b", {}, "storage.save");
  CHECK_NOTHROW(storage.save("c", half, "storage.save"));
}

TEST_CASE("storage: a file that is none of ours is refused in a sentence", "[engine][storage]") {
  const auto refused = [](const std::string& text, const std::string& why) { CHECK_THROWS_WITH(read_stored(text, "storage.json"), Contains(why)); };

  refused("", "storage.json:1:1: not JSON");
  refused("{}", "storage.json: no 'tumble_storage' in it");
  refused("[1]", "storage.json: no 'tumble_storage' in it");
  refused(R"({"tumble_storage": 2})", "storage.json: of version 2; this runtime reads version 1");
  refused(R"({"tumble_storage": 1, "values": [1]})", "values: a table expected, got a list");
  refused(R"({"tumble_storage": 1, "values": {"a": {"$vec3": [1, 2]}}})", "a: a list of 3 numbers expected, got { 1, 2 }");
  refused(R"({"tumble_storage": 1, "values": {"a": {"$color": "oragne"}}})", "a: a list of 4 numbers expected, got \"oragne\"");
  refused(R"({"tumble_storage": 1, "values": {"a": {"$mesh": 1}}})", "a: unknown kind '$mesh'; it comes from a later version");
  refused(R"({"tumble_storage": 1, "bindings": {"jump": "k"}})", "bindings: jump: a list expected, got a string");
  refused(R"({"tumble_storage": 1, "bindings": {"jump": [1]}})", "bindings: jump: names expected, got 1");
}

TEST_CASE("storage: no cut of a file crashes the reader", "[engine][storage]") {
  const std::string whole = write_stored(sample());
  for (std::size_t size = 0; size + 2 < whole.size(); ++size) CHECK_THROWS_AS(read_stored(whole.substr(0, size), "storage.json"), Error);
}
