// What the widgets of the last screen make of a tick's input, before the game sees the rest.
#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/ui/layout.h"
#include "engine/ui/ui.h"

namespace tumble {

namespace {

constexpr double kRepeatAfter = 0.4, kRepeatEvery = 0.1;   // s, of an arrow that is held

// "pad2_a" is "pad_a" to a menu.
std::string any_pad(const std::string& raw) {
  return raw.starts_with("pad") && raw.size() > 4 && raw[4] == '_' ? "pad" + raw.substr(4) : raw;
}

std::optional<UiDirection> direction_of(const std::string& name) {
  static const std::pair<const char*, UiDirection> names[] = {
      {"left", UiDirection::left},        {"right", UiDirection::right},        {"up", UiDirection::up},         {"down", UiDirection::down},
      {"pad_left", UiDirection::left},    {"pad_right", UiDirection::right},    {"pad_up", UiDirection::up},     {"pad_down", UiDirection::down},
      {"pad_left_x-", UiDirection::left}, {"pad_left_x+", UiDirection::right},  {"pad_left_y+", UiDirection::up}, {"pad_left_y-", UiDirection::down}};
  for (const auto& [word, direction] : names)
    if (name == word) return direction;
  return std::nullopt;
}

bool is_accept(const std::string& name) { return name == "enter" || name == "keypad_enter" || name == "space" || name == "pad_a"; }

// Keys that make letters, and so belong to a field that is written into.
bool is_typing(const std::string& name) {
  const bool other_device = name.starts_with("pad") || name.starts_with("pointer");
  const bool function = name.size() >= 2 && name[0] == 'f' && name[1] >= '0' && name[1] <= '9';
  return !other_device && !function && name != "escape" && name != "tab" && name != "up" && name != "down";
}

}  // namespace

void Ui::take_input(std::vector<InputEvent>& events, double tick_seconds) {
  ++ticks_;
  happened_.clear();
  std::erase_if(events, [this](const InputEvent& event) { return take(event); });
  repeat(tick_seconds);
  over_ = over_ui();
}

bool Ui::take(const InputEvent& event) {
  switch (event.kind) {
    case InputKind::press: return take_press(event.name);
    case InputKind::release: return take_release(event.name);
    case InputKind::wheel: return turn_wheel(event.value);
    case InputKind::pointer_move: move_pointer(event.x, event.y); return false;
    case InputKind::value: return false;
    case InputKind::text: {
      const Place* field = place(focus_);
      if (!field || field->kind != UiKind::field) return false;
      happened_[focus_].typed += event.name;
      return true;
    }
  }
  return false;
}

bool Ui::is_writing() const {
  const Place* focused = place(focus_);
  return focused && focused->kind == UiKind::field;
}

bool Ui::take_press(const std::string& raw) {
  const std::string name = any_pad(raw);
  bool ours = true;
  if (!waiting_.empty()) {
    if (name != "escape") happened_[waiting_].key = name;
    waiting_.clear();
  } else if (name == "pointer") {
    ours = press_pointer();
  } else if (take_typing(name)) {
  } else if (const auto direction = direction_of(name)) {
    ours = go(*direction, false);
    if (ours) {
      repeating_ = raw;
      repeating_direction_ = *direction;
      repeat_seconds_ = kRepeatAfter;
    }
  } else if (is_accept(name) && place(focus_)) {
    happened_[focus_].pressed = true;
    pointer_used_ = false;
    if (place(focus_)->kind == UiKind::key) waiting_ = focus_;
  } else {
    ours = false;
  }
  if (ours) taken_.insert(raw);
  return ours;
}

bool Ui::take_release(const std::string& raw) {
  if (raw == "pointer") release_pointer();
  if (raw == repeating_) repeating_.clear();
  return taken_.erase(raw) > 0;
}

bool Ui::take_typing(const std::string& name) {
  const Place* field = place(focus_);
  if (!field || field->kind != UiKind::field || !is_typing(name)) return false;
  if (name == "backspace") happened_[focus_].typed += '\b';
  if (name == "enter" || name == "keypad_enter") happened_[focus_].pressed = true;
  return true;
}

// ---- the pointer

void Ui::move_pointer(double x, double y) {
  const bool moved = x != pointer_x_ || y != pointer_y_;
  pointer_x_ = x;
  pointer_y_ = y;
  pointer_used_ = pointer_used_ || moved;
  if (const Place* held = place(held_); held && held->kind == UiKind::slider) return drag(*held);
  const Place* under = place_under_pointer();
  hover_ = under ? under->key : "";
  if (moved && under && under->enabled && under->focusable && !is_writing() && held_.empty()) focus_ = under->key;
}

bool Ui::press_pointer() {
  pointer_used_ = true;
  const Place* under = place_under_pointer();
  const Place* focused = place(focus_);
  if (focused && focused->kind == UiKind::field && (!under || under->key != focus_)) focus_.clear();
  if (!under || !under->enabled) return over_ui();
  held_ = under->key;
  if (under->focusable) focus_ = under->key;
  if (under->kind == UiKind::slider) drag(*under);
  return true;
}

void Ui::release_pointer() {
  const Place* held = place(held_);
  held_.clear();
  if (!held || !held->rect.contains(pointer_x_, pointer_y_)) return;
  Happening& happening = happened_[held->key];
  if (held->kind == UiKind::list) return press_list(*held);
  if (held->kind == UiKind::key) waiting_ = held->key;
  // A click into a field begins writing; only enter ends it.
  happening.pressed = held->kind != UiKind::field;
}

void Ui::press_list(const Place& list) {
  const auto row = static_cast<int>(std::floor((pointer_y_ - list.rect.y - ui_list_padding) / list.item_height));
  if (row < 0 || row >= list.shown || list.first + row >= list.items) return;
  happened_[list.key].picked = list.first + row + 1;
  happened_[list.key].pressed = true;
}

void Ui::drag(const Place& slider) {
  happened_[slider.key].dragged = std::clamp((pointer_x_ - slider.track.x) / slider.track.width, 0.0, 1.0);
}

bool Ui::turn_wheel(double steps) {
  const Place* under = place_under_pointer();
  if (!under || under->kind != UiKind::list || under->items <= under->shown) return over_ui();
  // Fine wheels turn by parts of a step.
  wheel_ -= steps;
  const double whole = std::trunc(wheel_);
  wheel_ -= whole;
  int& first = first_shown_[under->key];
  first = static_cast<int>(std::clamp(first + whole, 0.0, static_cast<double>(under->items - under->shown)));
  return true;
}

// ---- keys and pads

// One step with an arrow; false where there is nothing to go to.
bool Ui::go(UiDirection direction, bool again) {
  std::vector<const Place*> all;
  std::vector<UiRect> rects;
  const Place* from = nullptr;
  for (const Place& p : places_) {
    if (!p.focusable || !p.enabled) continue;
    if (p.key == focus_) from = &p;
    all.push_back(&p);
    rects.push_back(p.rect);
  }
  if (all.empty()) return false;
  pointer_used_ = false;
  if (!from) {
    focus_ = all.front()->key;
    return true;
  }
  const bool across = direction == UiDirection::left || direction == UiDirection::right;
  const int sign = direction == UiDirection::left || direction == UiDirection::up ? -1 : 1;
  if (from->kind == UiKind::slider && across) {
    happened_[focus_].steps += sign;
    return true;
  }
  if (from->kind == UiKind::list && !across) {
    const int there = from->selected + happened_[focus_].steps + sign;
    if (there >= 1 && there <= from->items) {
      happened_[focus_].steps += sign;
      return true;
    }
  }
  const int next = next_in_direction(from->rect, rects, direction, !again && !across);
  if (next >= 0) focus_ = all[static_cast<std::size_t>(next)]->key;
  return true;
}

void Ui::repeat(double tick_seconds) {
  if (repeating_.empty()) return;
  repeat_seconds_ -= tick_seconds;
  if (repeat_seconds_ > 1e-9) return;
  repeat_seconds_ += kRepeatEvery;
  go(repeating_direction_, true);
}

// ---- the last screen

const Ui::Place* Ui::place(const std::string& key) const {
  if (key.empty()) return nullptr;
  for (const Place& p : places_)
    if (p.key == key) return &p;
  return nullptr;
}

// The uppermost, which was drawn last.
const Ui::Place* Ui::place_under_pointer() const {
  for (auto p = places_.rbegin(); p != places_.rend(); ++p)
    if (p->rect.contains(pointer_x_, pointer_y_)) return &*p;
  return nullptr;
}

bool Ui::over_ui() const {
  if (place_under_pointer()) return true;
  return std::any_of(solids_.begin(), solids_.end(), [this](const UiRect& r) { return r.contains(pointer_x_, pointer_y_); });
}

}  // namespace tumble
