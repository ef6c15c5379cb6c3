#include "base/value.h"

#include <catch2/catch.hpp>

using namespace tumble;

TEST_CASE("value: entries are found by key and made where they are missing", "[base]") {
  Value value;
  value["size"]["x"] = 3;

  CHECK(value.find("size")->find("x")->number() == 3);
  CHECK(value.find("weight") == nullptr);
  CHECK(Value(3).find("size") == nullptr);
}

TEST_CASE("value: tables are equal whatever the order of their keys, lists are not", "[base]") {
  CHECK(Value(Map{{"a", 1}, {"b", 2}}) == Value(Map{{"b", 2}, {"a", 1}}));
  CHECK_FALSE(Value(Map{{"a", 1}, {"b", 2}}) == Value(Map{{"a", 1}, {"c", 2}}));
  CHECK_FALSE(Value(Map{{"a", 1}}) == Value(Map{{"a", 1}, {"b", 2}}));
  CHECK_FALSE(Value(List{1, 2}) == Value(List{2, 1}));
  CHECK(Value(List{Map{{"a", 1}, {"b", 2}}}) == Value(List{Map{{"b", 2}, {"a", 1}}}));
}

TEST_CASE("value: whole and real numbers differ", "[base]") {
  CHECK_FALSE(Value(1) == Value(1.0));
  CHECK(Value(1).number() == Value(1.0).number());
}

TEST_CASE("value: kinds have names for sentences", "[base]") {
  CHECK(kind_name({}) == "nil");
  CHECK(kind_name(true) == "a boolean");
  CHECK(kind_name(1) == "a number");
  CHECK(kind_name(1.5) == "a number");
  CHECK(kind_name("x") == "a string");
  CHECK(kind_name(Vec3{}) == "a vec3");
  CHECK(kind_name(Quat{}) == "a quat");
  CHECK(kind_name(Color{}) == "a color");
  CHECK(kind_name(Reference{}) == "a node");
  CHECK(kind_name(Reference{Reference::Kind::joint, 0, 1}) == "a joint");
  CHECK(kind_name(List{}) == "a list");
  CHECK(kind_name(Map{}) == "a table");
}

TEST_CASE("value: texts read like a script", "[base]") {
  CHECK(text({}) == "nil");
  CHECK(text(0.1) == "0.1");
  CHECK(text("red") == "\"red\"");
  CHECK(text(Vec3{1, 2.5, -3}) == "vec3(1, 2.5, -3)");
  CHECK(text(Color{1, 0, 0, 1}) == "\"#ff0000\"");
  CHECK(text(Map{{"a", List{1, true}}}) == "{ a = { 1, true } }");
}
