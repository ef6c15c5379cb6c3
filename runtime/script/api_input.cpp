// Keys, buttons, pads and the pointer.
#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "engine/ui/ui.h"
#include "script/areas.h"
#include "script/script.h"

namespace tumble {

namespace {

// Words that people try, beside typing errors; then names that hold the word: 'shift' is left_shift or right_shift.
std::string key_hint(const std::string& wrong, const std::vector<std::string>& names) {
  static const std::pair<const char*, const char*> habits[] = {{"esc", "escape"},        {"return", "enter"},      {"mouse", "pointer"},
                                                               {"mouse_left", "pointer"}, {"lmb", "pointer"},       {"click", "pointer"},
                                                               {"mouse_right", "pointer_right"}, {"rmb", "pointer_right"}, {"lshift", "left_shift"}};
  for (const auto& [word, name] : habits)
    if (wrong == word) return std::string("; did you mean '") + name + "'?";
  if (const std::string near = did_you_mean(wrong, names); !near.empty()) return near;
  if (wrong.size() >= 3)
    for (const std::string& name : names)
      if (name.find(wrong) != std::string::npos) return "; did you mean '" + name + "'?";
  return "; docs/api/input.md lists the names";
}

InputMap& input(Script& s) { return s.live_engine().input; }

const std::string& known(Script& s, const std::string& name, const char* call) {
  if (!input(s).knows(name)) fail(call, ": unknown name '", name, "'", key_hint(name, input(s).known_names()));
  return name;
}
bool is_down(Script& s, std::string name) { return input(s).is_down(known(s, name, "input.is_down")); }
bool was_pressed(Script& s, std::string name) { return input(s).was_pressed(known(s, name, "input.was_pressed")); }
bool was_released(Script& s, std::string name) { return input(s).was_released(known(s, name, "input.was_released")); }
double value(Script& s, std::string name) { return input(s).value(known(s, name, "input.value")); }
double axis(Script& s, std::string low, std::string high) {
  return input(s).value(known(s, high, "input.axis")) - input(s).value(known(s, low, "input.axis"));
}
double wheel(Script& s) { return input(s).wheel; }

// ---- which keys an action has

using Actions = std::map<std::string, std::vector<std::string>>;

const std::vector<std::string>& keys_of(const Actions& actions, const std::string& action, const char* call) {
  const auto found = actions.find(action);
  if (found != actions.end()) return found->second;
  std::vector<std::string> all;
  for (const auto& entry : actions) all.push_back(entry.first);
  fail(call, ": no action '", action, "' in game.json", did_you_mean(action, all));
}

struct BindOptions { bool save = false; };
void describe(BindOptions& options, Schema& s) {
  s.name("bind options", "How input.bind binds.");
  s.add("save", options.save, "Also in later runs of the game?");
}

void bind(Script& s, std::string action, Value names, std::optional<Value> given) {
  std::vector<std::string> list;
  assign(type_of<std::vector<std::string>>(), &list, names, "input.bind");
  for (const std::string& name : list)
    if (!is_raw_input_name(name)) fail("input.bind: no key or button '", name, "'", key_hint(name, raw_input_names()));
  BindOptions options;
  if (given) assign(options, *given, "input.bind");
  input(s).bind(action, list);
  if (options.save) s.storage.save_binding(action, list);
}

std::vector<std::string> bindings(Script& s, std::string action) { return keys_of(input(s).actions(), action, "input.bindings"); }

// For one action, or for all.
void reset_bindings(Script& s, std::optional<std::string> action) {
  const Actions& first = s.live_engine().settings.actions;
  if (action) keys_of(first, *action, "input.reset_bindings");
  for (const auto& [name, keys] : first) {
    if (action && *action != name) continue;
    input(s).bind(name, keys);
    s.storage.forget_binding(name);
  }
}

std::string described(Script& s, std::string name) {
  if (is_raw_input_name(name)) return input_label(name);
  if (input(s).knows(name)) fail("input.describe: '", name, "' is an action; ask for one of its keys: input.describe(input.bindings(\"", name, "\")[1])");
  fail("input.describe: no key or button '", name, "'", key_hint(name, raw_input_names()));
}

// ---- pads

void rumble(Script& s, double strength, double seconds, std::optional<int> pad) {
  if (strength < 0 || strength > 1) fail("input.rumble: strength: 0 to 1 expected, got ", number_text(strength));
  if (seconds < 0 || seconds > kLongestRumble) fail("input.rumble: seconds: 0 to ", kLongestRumble, " expected, got ", number_text(seconds));
  if (pad && (*pad < 1 || *pad > kMaxPads)) fail("input.rumble: pad: 1 to ", kMaxPads, " expected, got ", *pad, "; without a number all pads rumble");
  s.requests.rumbles.push_back({pad.value_or(0), strength, seconds});
}

// ---- the pointer

double x(Script& s) { return input(s).pointer_x; }
double y(Script& s) { return input(s).pointer_y; }
double dx(Script& s) { return input(s).pointer_dx; }
double dy(Script& s) { return input(s).pointer_dy; }
bool is_over_ui(Script& s) { return s.ui().is_over(); }
bool captured(Script& s) { return s.settings().pointer_captured; }
void set_captured(Script& s, bool on) { s.settings().pointer_captured = on; }

Results pointer(Script& s) {
  push_inner_module(s.stack(), "input.pointer");
  return {1};
}

}  // namespace

void rows_input(Area& a) {
  a.doc += " Actions are named in game.json. Keys are named by their place on an American board. All names of keys, buttons and pads: " +
           join(raw_input_names()) + ".";
  a.fn<is_down>("is_down", "Is the key, button or action held?", "name").queries();
  a.fn<was_pressed>("was_pressed", "Was it pressed in this tick?", "name").queries();
  a.fn<was_released>("was_released", "Was it let go in this tick?", "name").queries();
  a.fn<value>("value", "How far it is pressed, 0 to 1.", "name").queries();
  a.fn<axis>("axis", "-1 to 1: how far the second is pressed minus the first.", "low", "high").queries();
  a.fn<bind>("bind", "Gives an action other keys, until the game ends; with { save = true } also in its later runs.", "action", "names", "options")
      .acts().takes(1, "list of string").takes(2, "table");
  a.fn<bindings>("bindings", "The raw names that an action has.", "action");
  a.fn<reset_bindings>("reset_bindings", "Gives an action the keys of game.json back and forgets what was saved; without an action all of them.", "action").acts();
  a.scripted("listen", "Hands the next key, button or stick that is pressed to fn(name), and to nobody else; fn(nil) where it is escape. Also while paused.",
             {{"fn", "function"}}).acts();
  a.fn<described>("describe", "A key, button or stick in words for the screen: \"Space\", \"Left stick right\".", "name");
  a.fn<rumble>("rumble", "Shakes a pad, or without its number all of them, where a pad can: strength 0 to 1, seconds 0 to 10. 0 ends it.", "strength", "seconds", "pad").acts();
  a.prop<pointer>("pointer", "Where the pointer is, and how it moved.").gives("input.pointer");
  a.prop<wheel>("wheel", "Steps of the wheel in this tick, away from you.");
}

void rows_pointer(Area& a) {
  a.prop<x>("x", "From the left, in ui units: 0 to ui.width.");
  a.prop<y>("y", "From the top, in ui units: 0 to 720.");
  a.prop<dx>("dx", "How far it moved to the right in this tick, ui units.");
  a.prop<dy>("dy", "How far it moved down in this tick, ui units.");
  a.prop<is_over_ui>("is_over_ui", "Is it over a button or another part of the ui?");
  a.prop<captured, set_captured>("captured", "Hidden and endless, for looking around: x and y stand, dx and dy go on. While the game is paused, shows an error or is "
                                 "not in front the pointer is free; escape frees it until the next click.");
}

}  // namespace tumble
