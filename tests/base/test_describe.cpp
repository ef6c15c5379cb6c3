#include "base/describe.h"

#include <catch2/catch.hpp>
#include <limits>

using namespace tumble;

namespace {

enum class Sort { dynamic, fixed, kinematic };
const EnumNames& enum_names(Sort) {
  static const EnumNames names = {"dynamic", "static", "kinematic"};
  return names;
}

struct Part {
  std::string file;
  Vec3 size{1, 1, 1};
};
void describe(Part& part, Schema& s) {
  s.name("part", "A part.");
  s.main("file");
  s.add("file", part.file, "Its model.");
  s.add("size", part.size, "m.").above(0);
}

struct Paint {
  Color color;
  double gloss = 0.5;
};
void describe(Paint& paint, Schema& s) {
  s.name("paint", "A paint.");
  s.main("color");
  s.add("color", paint.color, "Its colour.");
  s.add("gloss", paint.gloss, "0 is matt.").between(0, 1);
}

struct Limit {
  std::optional<double> min, max;
};
void describe(Limit& limit, Schema& s) {
  s.name("limit", "Limits.");
  s.angle("min", limit.min, "rad.");
  s.angle("max", limit.max, "rad.").between(0, kPi);
  s.check<Limit>([](const Limit& l) {
    if (l.min && l.max && *l.min > *l.max) fail("min must not be above max; leave both out for no limit");
  });
}

struct Thing {
  std::string name;
  bool trigger = false;
  int count = 3;
  double mass = 1, force = 2, opening = kPi / 6;
  Sort type = Sort::dynamic;
  Vec3 position;
  Quat rotation;
  std::optional<double> friction;
  std::optional<Paint> paint;
  Part part{"start.glb", {2, 2, 2}};
  Limit limit;
  std::vector<std::string> tags;
  std::vector<Part> parts;
  std::map<std::string, std::vector<std::string>> actions;
  Value extra;
  std::vector<Thing> children;
};
void describe(Thing& thing, Schema& s) {
  s.name("thing", "A thing.");
  s.add("name", thing.name, "Its name.");
  s.add("trigger", thing.trigger, "Is it one?");
  s.add("count", thing.count, "How many.").at_least(0);
  s.add("mass", thing.mass, "kg.").above(0);
  s.add("force", thing.force, "N.").at_least(0).allow_infinite();
  s.angle("opening", thing.opening, "rad.").between(0, kPi);
  s.add("type", thing.type, "Its type.");
  s.add("position", thing.position, "m.");
  s.rotation("rotation", thing.rotation, "Its rotation.");
  s.add("friction", thing.friction, "0 is ice.").at_least(0);
  s.add("paint", thing.paint, "Its paint.");
  s.add("part", thing.part, "Its part.");
  s.add("limit", thing.limit, "Its limit.");
  s.add("tags", thing.tags, "Words.");
  s.add("parts", thing.parts, "More parts.");
  s.add("actions", thing.actions, "Names.");
  s.add("extra", thing.extra, "Anything.").not_saved();
  s.add("children", thing.children, "Below it.");
}

Thing read(const Value& value) {
  Thing thing;
  assign(thing, value, "scene.add");
  return thing;
}

std::string error(const Value& value) {
  try {
    read(value);
  } catch (const Error& e) {
    return e.what();
  }
  return "no error";
}

std::string error(const char* key, const Value& value) { return error(Map{{key, value}}); }

const double kNan = std::numeric_limits<double>::quiet_NaN();
const double kInf = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("describe: what a table gives is filled in and the rest stays", "[base]") {
  Thing thing;
  thing.mass = 7;

  assign(thing, Map{{"name", "crate"}, {"part", Map{{"size", Vec3{1, 2, 3}}}}, {"type", "static"}}, "scene.add");

  CHECK(thing.name == "crate");
  CHECK(thing.mass == 7);
  CHECK(thing.part.file == "start.glb");
  CHECK(thing.part.size == Vec3{1, 2, 3});
  CHECK(thing.type == Sort::fixed);
}

TEST_CASE("describe: a failed assignment changes nothing", "[base]") {
  Thing thing;

  CHECK_THROWS_AS(assign(thing, Map{{"name", "crate"}, {"mass", -1}}, "scene.add"), Error);

  CHECK(thing.name.empty());
}

TEST_CASE("describe: unknown fields are refused with the nearest one", "[base]") {
  CHECK(error("positon", Vec3{}) == "scene.add: no field 'positon'; did you mean 'position'?");
  CHECK(error("paint", Map{{"glos", 1}}) == "scene.add: paint has no field 'glos'; did you mean 'gloss'?");
  CHECK(error("paint", Map{{"weight", 1}}) == "scene.add: paint has no field 'weight'; it has color, gloss");
  CHECK(error("rotation_degree", Vec3{}) == "scene.add: no field 'rotation_degree'; did you mean 'rotation_degrees'?");
}

TEST_CASE("describe: numbers out of their range are refused with the range", "[base]") {
  CHECK(error("mass", -1) == "scene.add: mass must be above 0 (got -1)");
  CHECK(error("count", -2) == "scene.add: count must be at least 0 (got -2)");
  CHECK(error("friction", -0.5) == "scene.add: friction must be at least 0 (got -0.5)");
  CHECK(error("paint", Map{{"gloss", 2}}) == "scene.add: paint.gloss must be from 0 to 1 (got 2)");
  CHECK(error("part", Map{{"size", Vec3{1, 0, 1}}}) == "scene.add: part.size.y must be above 0 (got 0)");
  CHECK(error("opening_degrees", 200) == "scene.add: opening_degrees must be from 0 to 180 (got 200)");
  CHECK(error("count", 3e9) == "scene.add: count must be from -2147483648 to 2147483647 (got 3e+09)");
}

TEST_CASE("describe: a value of the wrong kind is shown beside what was expected", "[base]") {
  CHECK(error("mass", "heavy") == "scene.add: mass: number expected, got \"heavy\"");
  CHECK(error("mass", Value()) == "scene.add: mass: number expected, got nil");
  CHECK(error("count", 1.5) == "scene.add: count: whole number expected, got 1.5");
  CHECK(error("name", 5) == "scene.add: name: string expected, got 5");
  CHECK(error("trigger", 1) == "scene.add: trigger: true or false expected, got 1");
  CHECK(error("position", List{1, 2}) == "scene.add: position: vec3 expected, got a list of 2");
  CHECK(error("position", List{1, "a", 3}) == "scene.add: position.y: number expected, got \"a\"");
  CHECK(error("part", 5) == "scene.add: part: table or string expected, got 5");
  CHECK(error("limit", "x") == "scene.add: limit: table expected, got \"x\"");
  CHECK(error("tags", List{"a", 2}) == "scene.add: tags[2]: string expected, got 2");
  CHECK(error("tags", Map{{"a", 1}}) == "scene.add: tags: string expected, got a table");
  CHECK(error("type", 3) == "scene.add: type: one of dynamic, static, kinematic expected, got 3");
  CHECK(error(Value(3)) == "scene.add: table expected, got 3");
}

TEST_CASE("describe: unknown words are refused with the nearest one", "[base]") {
  CHECK(error("type", "statc") ==
        "scene.add: type: unknown 'statc'; expected one of dynamic, static, kinematic; did you mean 'static'?");
  CHECK(error("paint", "oragne") == "scene.add: paint.color: unknown name 'oragne'; did you mean 'orange'?");
}

TEST_CASE("describe: NaN is refused everywhere, infinity where it makes no sense", "[base]") {
  CHECK(error("position", Vec3{kNan, 0, 0}) == "scene.add: position.x is not a finite number (nan)");
  CHECK(error("mass", kInf) == "scene.add: mass is not a finite number (inf)");
  CHECK(error("mass", -kInf) == "scene.add: mass is not a finite number (-inf)");
  CHECK(error("force", kNan) == "scene.add: force is not a finite number (nan)");
  CHECK(error("rotation", Quat{kNan, 0, 0, 1}).find("scene.add: rotation is not finite") == 0);
  CHECK(read(Map{{"force", kInf}}).force == kInf);
}

TEST_CASE("describe: a plain value stands for the main field", "[base]") {
  CHECK(read(Map{{"part", "tree.glb"}}).part.file == "tree.glb");
  CHECK(read(Map{{"paint", "red"}}).paint->color == Color{1, 0, 0, 1});
  CHECK(read(Map{{"paint", List{0, 1, 0}}}).paint->color == Color{0, 1, 0, 1});
}

TEST_CASE("describe: a list of one may lose its braces", "[base]") {
  CHECK(read(Map{{"tags", "coin"}}).tags == std::vector<std::string>{"coin"});
  CHECK(read(Map{{"parts", "tree.glb"}}).parts.at(0).file == "tree.glb");
  CHECK(read(Map{{"parts", Map{{"file", "a"}}}}).parts.at(0).file == "a");
  CHECK(read(Map{{"actions", Map{{"jump", "space"}}}}).actions.at("jump").at(0) == "space");
}

TEST_CASE("describe: an empty table is an empty list and an empty table alike", "[base]") {
  CHECK(read(Map{{"tags", Map{}}}).tags.empty());
  CHECK(read(Map{{"actions", List{}}}).actions.empty());
  CHECK(read(Map{{"paint", List{}}}).paint.has_value());
  CHECK(read(List{}).mass == 1);
}

TEST_CASE("describe: nil clears what is optional, and a table replaces it whole", "[base]") {
  Thing thing = read(Map{{"friction", 0.3}, {"paint", Map{{"gloss", 1}}}});

  assign(thing, Map{{"friction", Value()}, {"paint", "red"}}, "set");

  CHECK(!thing.friction);
  CHECK(thing.paint->gloss == 0.5);
}

TEST_CASE("describe: angles and rotations are also read in degrees", "[base]") {
  CHECK(read(Map{{"opening_degrees", 90}}).opening == Approx(kPi / 2));
  CHECK(read(Map{{"limit", Map{{"min_degrees", -30}}}}).limit.min == Approx(-kPi / 6));
  const Quat q = read(Map{{"rotation_degrees", List{0, 90, 0}}}).rotation;
  CHECK(length(q * Vec3{0, 0, -1} - Vec3{-1, 0, 0}) < 1e-12);
}

TEST_CASE("describe: an angle given twice is refused", "[base]") {
  CHECK(error(Map{{"opening", 1}, {"opening_degrees", 2}}) ==
        "scene.add has both 'opening' and 'opening_degrees'; give one of them");
}

TEST_CASE("describe: quaternions are made of unit length, and none can be zero", "[base]") {
  CHECK(read(Map{{"rotation", List{0, 2, 0, 0}}}).rotation == Quat{0, 1, 0, 0});
  CHECK(length(read(Map{{"rotation", Quat{1e200, 1e200, 0, 0}}}).rotation) == Approx(1));
  CHECK(error("rotation", Quat{0, 0, 0, 0}).find("scene.add: rotation must not be zero (got 0, 0, 0, 0)") == 0);
  CHECK(error("rotation", Vec3{1, 2, 3}) ==
        "scene.add: rotation: quat expected, got vec3(1, 2, 3); for Euler angles write rotation_degrees");
}

TEST_CASE("describe: a check's sentence is told with its place", "[base]") {
  CHECK(error("limit", Map{{"min", 2}, {"max", 1}}) ==
        "scene.add: limit: min must not be above max; leave both out for no limit");
}

TEST_CASE("describe: list entries are counted from 1 in paths", "[base]") {
  const Value value = Map{{"children", List{Map{}, Map{{"part", Map{{"siez", 1}}}}}}};
  CHECK(error(value) == "scene.add: children[2].part has no field 'siez'; did you mean 'size'?");
}

TEST_CASE("describe: an object with default values is written as an empty table", "[base]") {
  CHECK(to_value(Thing{}, true) == Value(Map{}));
}

TEST_CASE("describe: only what differs from the owner's default is written", "[base]") {
  Thing thing;
  thing.part.size = {3, 3, 3};
  thing.opening = radians(30.5);
  thing.children.resize(1);
  thing.children[0].name = "lid";
  thing.extra = 5;

  const Value expected = Map{{"opening_degrees", 30.5}, {"part", Map{{"size", Vec3{3, 3, 3}}}}, {"children", List{Map{{"name", "lid"}}}}};
  CHECK(to_value(thing, true) == expected);
}

TEST_CASE("describe: what is written in full or in changes reads back the same", "[base]") {
  const Thing thing = read(Map{{"name", "a"}, {"mass", 2.5}, {"rotation_degrees", Vec3{10, 20, 30}}, {"friction", 0.25}, {"paint", "red"},
                               {"limit", Map{{"max_degrees", 45}}}, {"tags", List{"x", "y"}}, {"parts", List{"a.glb", "b.glb"}},
                               {"actions", Map{{"jump", List{"space"}}}}, {"children", List{Map{{"count", 9}}}}});
  const bool only_changes = GENERATE(true, false);

  const Thing copy = read(to_value(thing, only_changes));

  CHECK(to_value(copy) == to_value(thing));
}

TEST_CASE("describe: whole degrees come back as whole degrees", "[base]") {
  for (int angle = 0; angle <= 180; ++angle) {
    const Thing thing = read(Map{{"opening_degrees", angle}});
    CHECK(*field_value(type_of<Thing>(), &thing, "opening_degrees") == Value(double(angle)));
  }
}

TEST_CASE("describe: Euler angles come back as written", "[base]") {
  for (const Vec3& angles : {Vec3{0, 45, 0}, Vec3{10.5, -20.25, 30}, Vec3{90, 30, 0}, Vec3{-90, 0, 0}, Vec3{0, 180, 0}, Vec3{89, 1, 2}}) {
    const Thing thing = read(Map{{"rotation_degrees", angles}});
    CHECK(*field_value(type_of<Thing>(), &thing, "rotation_degrees") == Value(angles));
  }
}

TEST_CASE("describe: a rotation that Euler angles cannot hold exactly is saved as it is", "[base]") {
  const Quat q = from_euler({kPi / 2 - 1e-7, 0.3, 0.4});
  Thing thing;
  thing.rotation = q;

  CHECK(*to_value(thing, true).find("rotation") == Value(q));
}

TEST_CASE("describe: single fields are written and read by name", "[base]") {
  Thing thing;
  const Type& type = type_of<Thing>();

  CHECK(assign_field(type, &thing, "mass", 4, "body"));
  CHECK(assign_field(type, &thing, "rotation_degrees", Vec3{0, 90, 0}, "body"));
  CHECK_FALSE(assign_field(type, &thing, "weight", 4, "body"));

  CHECK(thing.mass == 4);
  CHECK(*field_value(type, &thing, "mass") == Value(4.0));
  CHECK(field_value(type, &thing, "friction")->is_nil());
  CHECK_FALSE(field_value(type, &thing, "weight").has_value());
  CHECK_THROWS_WITH(assign_field(type, &thing, "mass", 0, "body"), "body: mass must be above 0 (got 0)");
}

TEST_CASE("describe: types have texts for documents", "[base]") {
  CHECK(type_text(*type_of<Thing>().field("type")->type) == "\"dynamic\" | \"static\" | \"kinematic\"");
  CHECK(type_text(*type_of<Thing>().field("children")->type) == "list of thing");
  CHECK(type_text(*type_of<Thing>().field("friction")->type) == "number");
  CHECK(type_text(*type_of<Thing>().field("actions")->type) == "table of list of string");
}
