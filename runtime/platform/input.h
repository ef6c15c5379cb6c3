// Input as plain data: what people, bots and hosts feed a game. No SDL here.
//
// Raw names are words: keys by their position on an American board ("w" is the key above "s" on every layout),
// "pointer" (left button or touch), "pointer_right", "pointer_middle", "pad_a", "pad_left_x+" ... A pad's control comes
// under two names, "pad_a" for any pad and "pad2_a" for a certain one; of sticks, y+ is up and x+ right.
#pragma once

#include <string>
#include <vector>

#include "base/math.h"

namespace tumble {

constexpr int kMaxPads = 4;

enum class InputKind { press, release, value, pointer_move, wheel, text };

// One change of input, in the order in which it happened. Recorded, and so all that a game ever sees. Sticks and
// triggers give a `value` at each change, after a `press` or `release` where they pass the middle.
struct InputEvent {
  InputKind kind = InputKind::press;
  std::string name;       // press, release, value: the raw name; text: what was typed, UTF-8
  double value = 0;       // value: 0..1; wheel: steps away from the person
  double x = 0, y = 0;    // pointer_move: the place in ui units (720 high, from the top left)
  double dx = 0, dy = 0;  // pointer_move: the motion, also where the pointer is captured and has no place
  bool operator==(const InputEvent&) const = default;
};

// Every raw name that a keyboard, mouse or pad can give, in alphabetical order.
const std::vector<std::string>& raw_input_names();
bool is_raw_input_name(const std::string& name);
// A raw name in words for the screen: "Space", "Left stick right", "Pad 2 A".
std::string input_label(const std::string& name);

}  // namespace tumble
