#include "platform/input.h"

#include <algorithm>
#include <cctype>
#include <map>

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

// What reads badly when its underscores become spaces.
const std::map<std::string, std::string> kLabels = {
    {"left", "Left arrow"}, {"right", "Right arrow"}, {"up", "Up arrow"}, {"down", "Down arrow"},
    {"minus", "-"}, {"equals", "="}, {"left_bracket", "["}, {"right_bracket", "]"}, {"backslash", "\\"}, {"semicolon", ";"},
    {"apostrophe", "'"}, {"grave", "`"}, {"comma", ","}, {"period", "."}, {"slash", "/"}, {"less", "<"},
    {"keypad_plus", "Keypad +"}, {"keypad_minus", "Keypad -"}, {"keypad_multiply", "Keypad *"}, {"keypad_divide", "Keypad /"},
    {"keypad_period", "Keypad ."},
    {"pointer", "Left mouse button"}, {"pointer_right", "Right mouse button"}, {"pointer_middle", "Middle mouse button"},
    {"pointer_back", "Mouse button back"}, {"pointer_forward", "Mouse button forward"}};
const std::map<std::string, std::string> kPadLabels = {
    {"left_stick", "left stick pressed"}, {"right_stick", "right stick pressed"},
    {"left_x+", "left stick right"}, {"left_x-", "left stick left"}, {"left_y+", "left stick up"}, {"left_y-", "left stick down"},
    {"right_x+", "right stick right"}, {"right_x-", "right stick left"}, {"right_y+", "right stick up"}, {"right_y-", "right stick down"}};

std::string spaced(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

std::string capitalized(std::string words) {
  if (!words.empty()) words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
  return words;
}

// "a" of any pad is "Pad A", of the second "Pad 2 A"; a stick needs no "Pad" before it.
std::string pad_label(const std::string& number, const std::string& control) {
  const auto found = kPadLabels.find(control);
  const std::string words = found != kPadLabels.end() ? found->second : spaced(control);
  const bool is_plain = words.find(' ') == std::string::npos;
  if (number.empty() && !is_plain) return capitalized(words);
  return "Pad " + (number.empty() ? "" : number + " ") + (control.size() == 1 ? capitalized(words) : words);
}

}  // namespace

std::string input_label(const std::string& name) {
  const std::size_t line = name.find('_');
  if (name.starts_with("pad") && line != std::string::npos) return pad_label(name.substr(3, line - 3), name.substr(line + 1));
  const auto found = kLabels.find(name);
  return found != kLabels.end() ? found->second : capitalized(spaced(name));
}

const std::vector<std::string>& raw_input_names() {
  static const std::vector<std::string> names = all_names();
  return names;
}

bool is_raw_input_name(const std::string& name) {
  return std::binary_search(raw_input_names().begin(), raw_input_names().end(), name);
}

}  // namespace tumble
