#include "platform/input.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "platform/held_input.h"

using namespace tumble;

TEST_CASE("input: raw names are words in alphabetical order, each once", "[platform]") {
  const auto& names = raw_input_names();

  CHECK(std::is_sorted(names.begin(), names.end()));
  CHECK(std::adjacent_find(names.begin(), names.end()) == names.end());
  for (const char* name : {"a", "z", "0", "9", "space", "left", "escape", "left_shift", "f1", "f12", "keypad_0",
                           "minus", "pointer", "pointer_right", "pad_a", "pad2_a", "pad_left_x+", "pad4_right_y-"})
    CHECK(is_raw_input_name(name));
  for (const char* name : {"", "A", "shift", "pad5_a", "pad_left_x", "f13"}) CHECK_FALSE(is_raw_input_name(name));
}

TEST_CASE("input: a press repeated, or a release unheard of, is no event", "[platform]") {
  HeldInput held;
  std::vector<InputEvent> out;

  held.release("a", out);
  held.press("a", out);
  held.press("a", out);
  held.release("a", out);
  held.release("a", out);

  REQUIRE(out.size() == 2);
  CHECK(out[0].kind == InputKind::press);
  CHECK(out[1].kind == InputKind::release);
}

TEST_CASE("input: a stick presses past its middle, and tells each value after", "[platform]") {
  HeldInput held;
  std::vector<InputEvent> out;

  for (const double value : {0.3, 0.6, 0.45, 0.2, 0.2}) held.set_value("pad_left_x+", value, out);

  std::string kinds;
  for (const InputEvent& event : out)
    kinds += event.kind == InputKind::press ? 'p' : event.kind == InputKind::release ? 'r' : 'v';
  CHECK(kinds == "vpvvrv");
}

TEST_CASE("input: everything held can be released at once", "[platform]") {
  HeldInput held;
  std::vector<InputEvent> before, out;
  held.press("w", before);
  held.press("space", before);
  held.set_value("pad_left_trigger", 1, before);

  held.release_all(out);

  REQUIRE(out.size() == 4);
  CHECK(out[0].name == "pad_left_trigger");
  CHECK(out[0].kind == InputKind::release);
  CHECK(out[1].kind == InputKind::value);
  CHECK(out[1].value == 0);
  CHECK(out[2].name == "space");
  CHECK(out[3].name == "w");
}

TEST_CASE("input: every raw name has a label, and no two share one", "[platform]") {
  std::vector<std::string> labels;
  for (const std::string& name : raw_input_names()) {
    labels.push_back(input_label(name));
    INFO(name << ": " << labels.back());
    CHECK_FALSE(labels.back().empty());
    CHECK(labels.back().find('_') == std::string::npos);
  }
  std::sort(labels.begin(), labels.end());
  CHECK(std::adjacent_find(labels.begin(), labels.end()) == labels.end());
}

TEST_CASE("input: labels are what a menu would say", "[platform]") {
  const std::pair<const char*, const char*> expected[] = {
      {"space", "Space"}, {"k", "K"}, {"f1", "F1"}, {"left", "Left arrow"}, {"left_shift", "Left shift"}, {"comma", ","},
      {"keypad_5", "Keypad 5"}, {"pointer", "Left mouse button"}, {"pad_a", "Pad A"}, {"pad_up", "Pad up"}, {"pad_start", "Pad start"},
      {"pad_left_x+", "Left stick right"}, {"pad_right_y-", "Right stick down"}, {"pad_left_trigger", "Left trigger"},
      {"pad_left_stick", "Left stick pressed"}, {"pad2_a", "Pad 2 A"}, {"pad3_left_y+", "Pad 3 left stick up"}};
  for (const auto& [name, label] : expected) CHECK(input_label(name) == label);
}
