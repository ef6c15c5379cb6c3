// Input as a game sees it: sampled once a tick, raw names and the actions bound to them.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "platform/input.h"

namespace tumble {

// What a tick delivers to on_press and the others, in order; first the raw name (of a pad also the name for any pad)
// unless an action of that name hides it, then each action it belongs to, in alphabetical order. An action with several
// keys is pressed with the first of them and released with the last. Motion without anything between is one notice.
struct InputNotice {
  enum class Kind { press, release, pointer_move, wheel, text } kind = Kind::press;
  std::string name;     // press, release: raw name or action; text: the text
  double x = 0, y = 0;  // pointer_move: dx, dy; wheel: x is steps
};

class InputMap {
 public:
  // Replaces an action's raw names. Throws Error for a raw name that no device has, with the nearest.
  void bind(const std::string& action, const std::vector<std::string>& names);
  void set_actions(const std::map<std::string, std::vector<std::string>>& actions);
  const std::map<std::string, std::vector<std::string>>& actions() const { return actions_; }
  bool knows(const std::string& name) const;             // an action or a raw name
  std::vector<std::string> known_names() const;

  // Takes the events since the last tick; returns what to deliver. A press and release of one key within a tick are
  // both seen: was_pressed and was_released are true, is_down is false.
  std::vector<InputNotice> sample(const std::vector<InputEvent>& events);
  // From the next tick on: the next press is kept for take_heard(), and neither it nor its release is told otherwise.
  void listen() { listening_ = true; }
  std::optional<std::string> take_heard();               // the raw name; of a pad the one for any pad
  bool is_down(const std::string& name) const;           // names are checked by who calls
  bool was_pressed(const std::string& name) const;
  bool was_released(const std::string& name) const;
  double value(const std::string& name) const;           // 0..1

  double pointer_x = 640, pointer_y = 360, pointer_dx = 0, pointer_dy = 0, wheel = 0;  // this tick, ui units

 private:
  struct Key {
    bool down = false;
    double value = 0;
    bool pressed = false, released = false;  // in this tick
  };
  const Key* find(const std::string& raw) const;
  bool raw_down(const std::string& raw) const;      // "pad_a": of any pad
  double raw_value(const std::string& raw) const;
  bool action_down(const std::vector<std::string>& names) const;
  bool swallows(const InputEvent& event);
  void begin_tick();
  void move_pointer(const InputEvent& event, std::vector<InputNotice>& notices);
  void press_or_release(const InputEvent& event, std::vector<InputNotice>& notices);

  std::unordered_map<std::string, Key> raw_;        // in no order: only looked up, or all set back
  std::map<std::string, std::vector<std::string>> actions_;
  bool listening_ = false;
  std::optional<std::string> heard_;
  std::set<std::string> muted_;                     // pressed for a listener and not yet released
  std::unordered_map<std::string, Key> edges_;      // of actions: pressed and released only, the rest follows from raw_
};

}  // namespace tumble
