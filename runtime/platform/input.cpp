#include "platform/input.h"

#include <algorithm>

namespace tumble {
namespace {

constexpr const char* kKeys[] = {
    "space", "enter", "escape", "tab", "backspace", "insert", "delete", "home", "end", "page_up", "page_down",
    "left", "right", "up", "down",
    "left_shift", "right_shift", "left_ctrl", "right_ctrl", "left_alt", "right_alt", "left_super", "right_super",
    "caps_lock", "num_lock", "scroll_lock", "print_screen", "pause", "menu",
    "minus", "equals", "left_bracket", "right_bracket", "backslash", "semicolon", "apostrophe", "grave", "comma",
    "period", "slash", "less",
    "keypad_plus", "keypad_minus", "keypad_multiply", "keypad_divide", "keypad_enter", "keypad_period",
    "pointer", "pointer_right", "pointer_middle", "pointer_back", "pointer_forward"};

constexpr const char* kPadControls[] = {
    "a", "b", "x", "y", "start", "back", "guide", "up", "down", "left", "right",
    "left_shoulder", "right_shoulder", "left_trigger", "right_trigger", "left_stick", "right_stick",
    "left_x+", "left_x-", "left_y+", "left_y-", "right_x+", "right_x-", "right_y+", "right_y-"};

std::string numbered(std::string text, int number, const char* after) {
  text += std::to_string(number);
  return text += after;
}

std::vector<std::string> all_names() {
  std::vector<std::string> names(std::begin(kKeys), std::end(kKeys));
  for (char letter = 'a'; letter <= 'z'; ++letter) names.emplace_back(1, letter);
  for (char digit = '0'; digit <= '9'; ++digit) {
    names.emplace_back(1, digit);
    names.push_back(std::string("keypad_") + digit);
  }
  for (int i = 1; i <= 12; ++i) names.push_back(numbered("f", i, ""));
  for (const char* control : kPadControls) {
    names.push_back(std::string("pad_") + control);
    for (int pad = 1; pad <= kMaxPads; ++pad) names.push_back(numbered("pad", pad, "_") + control);
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

const std::vector<std::string>& raw_input_names() {
  static const std::vector<std::string> names = all_names();
  return names;
}

bool is_raw_input_name(const std::string& name) {
  return std::binary_search(raw_input_names().begin(), raw_input_names().end(), name);
}

}  // namespace tumble
