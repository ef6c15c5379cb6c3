#include "engine/json.h"
#include "base/error.h"

#include <catch2/catch.hpp>
#include <limits>

using namespace tumble;

namespace {

std::string error(const std::string& text) {
  try {
    parse_json(text, "a.json");
  } catch (const Error& e) {
    return e.what();
  }
  return "no error";
}

}  // namespace

TEST_CASE("json: each kind of value is read", "[engine]") {
  const Value value = parse_json(R"({"a": null, "b": true, "c": 3, "d": 2.5, "e": "x", "f": [1, 2, 3], "g": {}})", "a.json");

  const Value expected = Map{{"a", {}}, {"b", true}, {"c", 3}, {"d", 2.5}, {"e", "x"}, {"f", List{1, 2, 3}}, {"g", Map{}}};
  CHECK(value == expected);
}

TEST_CASE("json: keys keep their order", "[engine]") {
  const Value value = parse_json(R"({"z": 1, "a": 2})", "a.json");

  CHECK(value.get<Map>()->at(0).first == "z");
}

TEST_CASE("json: whole numbers become integers where they fit", "[engine]") {
  CHECK(parse_json("5", "a.json").is<std::int64_t>());
  CHECK(parse_json("5.0", "a.json").is<double>());
  CHECK(parse_json("9223372036854775807", "a.json") == Value(std::numeric_limits<std::int64_t>::max()));
  CHECK(parse_json("9223372036854775808", "a.json") == Value(9223372036854775808.0));
  CHECK(parse_json("-9223372036854775808", "a.json") == Value(std::numeric_limits<std::int64_t>::min()));
}

TEST_CASE("json: syntax errors name file, line and column", "[engine]") {
  CHECK(error("{\n  \"a\": 1,\n  \"b\" 2\n}") == "a.json:3:7: not JSON: unexpected number literal; expected ':'");
  CHECK(error("[1 2]").find("a.json:1:4: not JSON: ") == 0);
  CHECK(error("{\"a\": 1,}").find("a.json:1:9: not JSON: unexpected '}'") == 0);
  CHECK(error("").find("a.json:1:1: not JSON: unexpected end of input") == 0);
  CHECK(error("{} {}").find("a.json:1:4: not JSON: ") == 0);
}

TEST_CASE("json: what only looks like JSON is refused", "[engine]") {
  for (const char* text : {"NaN", "Infinity", "'a'", "// x\n{}", "[1,]", "\"\xff\"", "\"a\nb\"", "{a: 1}", "01", "1e999"})
    CHECK(error(text).find("a.json:") == 0);
}

TEST_CASE("json: a key that stands twice is refused with its place", "[engine]") {
  CHECK(error(R"({"a": 1, "a": 2})") == "a.json: the key 'a' stands here twice");
  CHECK(error(R"({"a": {"b": [1, {"c": 1, "c": 2}]}})") == "a.json: a.b[2]: the key 'c' stands here twice");
  CHECK(error(R"([{"c": 1}, {"c": 2}])") == "no error");
}

TEST_CASE("json: depth is bounded", "[engine]") {
  CHECK(error(std::string(100, '[') + std::string(100, ']')) == "no error");
  CHECK(error(std::string(101, '[') + std::string(101, ']')) == "a.json: tables stand in one another more than 100 deep");
  CHECK(error(std::string(1000000, '[')) == "a.json: tables stand in one another more than 100 deep");
}

TEST_CASE("json: what is written is read back equal", "[engine]") {
  const Value values[] = {
      Value(), true, 5, 5.0, -0.1, 1e300, 5e-324, "", "a \"b\"\n\\ \x01 gr\xc3\xbc\xc3\x9f", List{}, Map{},
      List{1, List{2.5, List{}}, Map{{"", 1}}}, Map{{"list", List{List{Map{{"deep", List{1, 2, 3}}}}}}, {"none", {}}},
      List{std::string(200, 'x'), std::string(200, 'y')}, std::numeric_limits<std::int64_t>::min()};
  for (const Value& value : values) CHECK(parse_json(write_json(value), "a.json") == value);
}

TEST_CASE("json: vectors, rotations and colours have forms of their own", "[engine]") {
  CHECK(write_json(Vec3{1, 2.5, -3}) == "[1, 2.5, -3]\n");
  CHECK(write_json(Quat{0, 0, 0, 1}) == "[0, 0, 0, 1]\n");
  CHECK(write_json(Color{1, 0, 0, 1}) == "\"#ff0000\"\n");
  CHECK(write_json(Color{0.3, 0, 0, 1}) == "[0.3, 0, 0, 1]\n");
}

TEST_CASE("json: short tables stay on one line, long ones do not", "[engine]") {
  const std::string text(60, 'x');
  const Value value = Map{{"a", Map{{"b", 1}}}, {"c", List{text, text}}};

  CHECK(write_json(value) == "{\n  \"a\": { \"b\": 1 },\n  \"c\": [\n    \"" + text + "\",\n    \"" + text + "\"\n  ]\n}\n");
}

TEST_CASE("json: what it cannot hold is refused when writing", "[engine]") {
  CHECK_THROWS_WITH(write_json(std::numeric_limits<double>::infinity()), "JSON cannot hold the number inf; leave the key out");
  CHECK_THROWS_AS(write_json(Vec3{std::numeric_limits<double>::quiet_NaN(), 0, 0}), Error);
  CHECK_THROWS_AS(write_json(Reference{}), Error);
}
