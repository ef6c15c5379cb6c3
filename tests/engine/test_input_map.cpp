#include "engine/input_map.h"
#include "base/error.h"

#include <algorithm>
#include <catch2/catch.hpp>

using namespace tumble;

namespace {

InputEvent press(const std::string& name) { return {InputKind::press, name}; }
InputEvent release(const std::string& name) { return {InputKind::release, name}; }
InputEvent analog(const std::string& name, double value) { return {InputKind::value, name, value}; }

// "+name" for a press, "-name" for a release, in order.
std::vector<std::string> told(InputMap& map, const std::vector<InputEvent>& events) {
  std::vector<std::string> texts;
  for (const InputNotice& notice : map.sample(events)) {
    if (notice.kind == InputNotice::Kind::press) texts.push_back("+" + notice.name);
    if (notice.kind == InputNotice::Kind::release) texts.push_back("-" + notice.name);
  }
  return texts;
}

using Texts = std::vector<std::string>;

}  // namespace

TEST_CASE("input: a key is pressed in one tick, down until its release", "[engine]") {
  InputMap map;

  CHECK(told(map, {press("space")}) == Texts{"+space"});
  CHECK(map.was_pressed("space"));
  CHECK(map.is_down("space"));
  CHECK(map.value("space") == 1);
  CHECK(told(map, {}) == Texts{});
  CHECK_FALSE(map.was_pressed("space"));
  CHECK(map.is_down("space"));
  CHECK(told(map, {release("space")}) == Texts{"-space"});
  CHECK(map.was_released("space"));
  CHECK_FALSE(map.is_down("space"));
  CHECK(map.value("space") == 0);
}

TEST_CASE("input: a press and release within a tick are both seen", "[engine]") {
  InputMap map;
  map.bind("jump", {"space"});

  CHECK(told(map, {press("space"), release("space")}) == Texts{"+space", "+jump", "-space", "-jump"});

  for (const char* name : {"space", "jump"}) {
    CHECK(map.was_pressed(name));
    CHECK(map.was_released(name));
    CHECK_FALSE(map.is_down(name));
  }
}

TEST_CASE("input: a repeated press and a release without press say nothing", "[engine]") {
  InputMap map;

  CHECK(told(map, {press("a"), press("a")}) == Texts{"+a"});
  CHECK(told(map, {press("a"), release("b")}) == Texts{});
  CHECK_FALSE(map.was_pressed("a"));
}

TEST_CASE("input: first the raw name is told, then its actions in alphabetical order", "[engine]") {
  InputMap map;
  map.set_actions({{"use", {"e"}}, {"act", {"e", "f"}}, {"jump", {"space"}}});

  CHECK(told(map, {press("e")}) == Texts{"+e", "+act", "+use"});
}

TEST_CASE("input: an action hides a key of its name", "[engine]") {
  InputMap map;
  map.set_actions({{"left", {"a", "left"}}, {"up", {"w"}}});

  CHECK(told(map, {press("left")}) == Texts{"+left"});
  CHECK(told(map, {release("left"), press("a")}) == Texts{"-left", "+a", "+left"});
  CHECK(map.is_down("left"));
  CHECK(told(map, {press("up")}) == Texts{});
  CHECK_FALSE(map.is_down("up"));
  CHECK_FALSE(map.was_pressed("up"));
}

TEST_CASE("input: an action is pressed with its first key and released with its last", "[engine]") {
  InputMap map;
  map.bind("jump", {"space", "w"});

  CHECK(told(map, {press("space")}) == Texts{"+space", "+jump"});
  CHECK(told(map, {press("w")}) == Texts{"+w"});
  CHECK_FALSE(map.was_pressed("jump"));
  CHECK(told(map, {release("space")}) == Texts{"-space"});
  CHECK(map.is_down("jump"));
  CHECK(told(map, {release("w")}) == Texts{"-w", "-jump"});
}

TEST_CASE("input: the name for any pad hears of every pad", "[engine]") {
  InputMap map;
  map.bind("jump", {"pad_a"});

  CHECK(told(map, {press("pad2_a")}) == Texts{"+pad2_a", "+pad_a", "+jump"});
  CHECK(told(map, {press("pad1_a")}) == Texts{"+pad1_a"});
  CHECK(told(map, {release("pad2_a")}) == Texts{"-pad2_a"});
  CHECK(map.is_down("pad_a"));
  CHECK_FALSE(map.is_down("pad2_a"));
  CHECK(told(map, {release("pad1_a")}) == Texts{"-pad1_a", "-pad_a", "-jump"});
}

TEST_CASE("input: a host may press the name for any pad itself", "[engine]") {
  InputMap map;

  CHECK(told(map, {press("pad_a")}) == Texts{"+pad_a"});
  CHECK(told(map, {press("pad1_a")}) == Texts{"+pad1_a"});
  CHECK(told(map, {release("pad_a")}) == Texts{});
  CHECK(told(map, {release("pad1_a")}) == Texts{"-pad1_a", "-pad_a"});
}

TEST_CASE("input: sticks have values between nothing and all", "[engine]") {
  InputMap map;
  map.bind("right", {"d", "pad_left_x+"});

  told(map, {analog("pad2_left_x+", 0.3), analog("pad1_left_x+", 0.2)});
  CHECK(map.value("pad2_left_x+") == 0.3);
  CHECK(map.value("pad_left_x+") == 0.3);
  CHECK(map.value("right") == 0.3);
  CHECK_FALSE(map.is_down("right"));
  told(map, {press("d")});
  CHECK(map.value("right") == 1);
  told(map, {analog("pad2_left_x+", 7)});
  CHECK(map.value("pad2_left_x+") == 1);
}

TEST_CASE("input: a stick's press is followed by its value", "[engine]") {
  InputMap map;

  told(map, {press("pad1_left_x+"), analog("pad1_left_x+", 0.6)});

  CHECK(map.is_down("pad_left_x+"));
  CHECK(map.value("pad_left_x+") == 0.6);
}

TEST_CASE("input: the pointer's motion and the wheel add up over a tick", "[engine]") {
  InputMap map;
  InputEvent first{InputKind::pointer_move, "", 0, 10, 20, 1, 2}, second{InputKind::pointer_move, "", 0, 13, 25, 3, 5};

  const auto notices = map.sample({first, second, {InputKind::wheel, "", 2}, {InputKind::wheel, "", -0.5}});

  CHECK(map.pointer_x == 13);
  CHECK(map.pointer_y == 25);
  CHECK(map.pointer_dx == 4);
  CHECK(map.pointer_dy == 7);
  CHECK(map.wheel == 1.5);
  REQUIRE(notices.size() == 2);
  CHECK(notices[0].kind == InputNotice::Kind::pointer_move);
  CHECK(notices[0].x == 4);
  CHECK(notices[1].kind == InputNotice::Kind::wheel);
  CHECK(notices[1].x == 1.5);
  map.sample({});
  CHECK(map.pointer_x == 13);
  CHECK(map.pointer_dx == 0);
  CHECK(map.wheel == 0);
}

TEST_CASE("input: a press between two motions keeps its place", "[engine]") {
  InputMap map;
  const InputEvent move{InputKind::pointer_move, "", 0, 1, 1, 1, 1};

  const auto notices = map.sample({move, press("pointer"), move, {InputKind::text, "a"}});

  REQUIRE(notices.size() == 4);
  CHECK(notices[1].name == "pointer");
  CHECK(notices[2].kind == InputNotice::Kind::pointer_move);
  CHECK(notices[3].kind == InputNotice::Kind::text);
  CHECK(notices[3].name == "a");
}

TEST_CASE("input: raw names that no device has are refused, and nothing is changed", "[engine]") {
  InputMap map;
  map.bind("jump", {"space"});

  CHECK_THROWS_WITH(map.bind("jump", {"spcae"}), "action 'jump': no key or button 'spcae'; did you mean 'space'?");
  CHECK_THROWS_AS(map.set_actions({{"act", {"e"}}, {"jump", {"spcae"}}}), Error);

  CHECK(map.actions().size() == 1);
  CHECK(map.actions().at("jump") == std::vector<std::string>{"space"});
}

TEST_CASE("input: actions and raw names are known, once each", "[engine]") {
  InputMap map;
  map.bind("left", {"a"});

  CHECK(map.knows("left"));
  CHECK(map.knows("pad3_a"));
  CHECK_FALSE(map.knows("lfet"));
  const auto names = map.known_names();
  CHECK(std::count(names.begin(), names.end(), "left") == 1);
}

TEST_CASE("input: a key bound while it is held counts from then on", "[engine]") {
  InputMap map;
  told(map, {press("e")});

  map.bind("use", {"e"});

  CHECK(map.is_down("use"));
  CHECK(told(map, {release("e")}) == Texts{"-e", "-use"});
}

TEST_CASE("input: a listener hears the next press, and nobody else does", "[engine]") {
  InputMap map;
  map.bind("jump", {"space"});
  map.sample({press("a")});
  map.listen();

  CHECK(told(map, {release("a"), press("space"), press("b")}) == Texts{"-a", "+b"});
  CHECK(map.take_heard() == "space");
  CHECK_FALSE(map.take_heard());
  CHECK_FALSE(map.is_down("jump"));
  CHECK(told(map, {press("space"), release("space")}) == Texts{});
  CHECK(told(map, {press("space")}) == Texts{"+space", "+jump"});
}

TEST_CASE("input: a listener hears pads by the name for any pad", "[engine]") {
  InputMap map;
  map.listen();

  CHECK(told(map, {press("pad2_a"), press("pad_a")}) == Texts{});
  CHECK(map.take_heard() == "pad_a");
  CHECK(told(map, {release("pad2_a"), release("pad_a")}) == Texts{});
  CHECK(told(map, {press("pad2_a"), press("pad_a")}) == Texts{"+pad2_a", "+pad_a"});
}

TEST_CASE("input: what a stick tells on its way to a listener stays unheard, what it lets go does not", "[engine]") {
  InputMap map;
  map.sample({analog("pad1_left_x-", 0.3)});
  map.listen();

  map.sample({analog("pad1_left_x-", 0), analog("pad1_left_x+", 0.4), press("pad1_left_x+"), analog("pad1_left_x+", 0.9)});

  CHECK(map.value("pad1_left_x-") == 0);
  CHECK(map.value("pad_left_x+") == 0);
  CHECK(map.take_heard() == "pad_left_x+");
  map.sample({release("pad1_left_x+"), analog("pad1_left_x+", 0.3)});
  map.sample({analog("pad1_left_x+", 0.4)});
  CHECK(map.value("pad_left_x+") == 0.4);
}

TEST_CASE("input: what a listener's key types is no text", "[engine]") {
  InputMap map;
  map.listen();

  CHECK(map.sample({press("k"), {InputKind::text, "k"}}).empty());
  map.take_heard();
  CHECK(map.sample({{InputKind::text, "k"}}).size() == 1);
}
