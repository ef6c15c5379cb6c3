#include "engine/input_map.h"

#include "base/error.h"
#include "base/text.h"

#include <algorithm>
#include <utility>

namespace tumble {

namespace {

// "pad2_a" -> "pad_a"; "" for any other name.
std::string any_pad_name(const std::string& raw) {
  const bool is_pad = raw.size() > 5 && raw.starts_with("pad") && raw[3] >= '1' && raw[3] < '1' + kMaxPads && raw[4] == '_';
  return is_pad ? "pad" + raw.substr(4) : "";
}

// "pad_a" -> "pad1_a" ... "pad4_a"; none for any other name.
std::vector<std::string> pad_names(const std::string& raw) {
  std::vector<std::string> names;
  if (!raw.starts_with("pad_")) return names;
  for (int pad = 1; pad <= kMaxPads; ++pad) names.push_back("pad" + std::to_string(pad) + raw.substr(3));
  return names;
}

}  // namespace

void InputMap::bind(const std::string& action, const std::vector<std::string>& names) {
  for (const std::string& name : names)
    if (!is_raw_input_name(name))
      fail("action '", action, "': no key or button '", name, "'", did_you_mean(name, raw_input_names()));
  actions_[action] = names;
}

void InputMap::set_actions(const std::map<std::string, std::vector<std::string>>& actions) {
  InputMap fresh;  // so that nothing is changed where a name is wrong
  for (const auto& [action, names] : actions) fresh.bind(action, names);
  actions_ = std::move(fresh.actions_);
}

bool InputMap::knows(const std::string& name) const { return actions_.count(name) > 0 || is_raw_input_name(name); }

std::vector<std::string> InputMap::known_names() const {
  std::vector<std::string> names;
  for (const auto& [action, raw] : actions_) names.push_back(action);
  for (const std::string& raw : raw_input_names())
    if (actions_.count(raw) == 0) names.push_back(raw);
  return names;
}

std::vector<InputNotice> InputMap::sample(const std::vector<InputEvent>& events) {
  begin_tick();
  std::vector<InputNotice> notices;
  for (const InputEvent& event : events) {
    if (swallows(event)) continue;
    switch (event.kind) {
      case InputKind::press:
      case InputKind::release: press_or_release(event, notices); break;
      case InputKind::value: raw_[event.name].value = std::clamp(event.value, 0.0, 1.0); break;
      case InputKind::text: notices.push_back({InputNotice::Kind::text, event.name, 0, 0}); break;
      case InputKind::pointer_move:
      case InputKind::wheel: move_pointer(event, notices); break;
    }
  }
  return notices;
}

std::optional<std::string> InputMap::take_heard() { return std::exchange(heard_, std::nullopt); }

// Is the event for the listener, or the end of one that was?
bool InputMap::swallows(const InputEvent& event) {
  const std::string any_pad = any_pad_name(event.name);
  switch (event.kind) {
    case InputKind::press:
      if (muted_.contains(event.name)) return true;
      if (!listening_ || raw_[event.name].down) return false;
      listening_ = false;
      heard_ = any_pad.empty() ? event.name : any_pad;
      muted_.insert({event.name, *heard_});
      return true;
    case InputKind::release:
      if (!any_pad.empty()) muted_.erase(any_pad);
      return muted_.erase(event.name) > 0;
    // A stick tells its way to the press too; what it lets go of is told.
    case InputKind::value: return muted_.contains(event.name) || (listening_ && event.value > raw_[event.name].value);
    case InputKind::text: return listening_ || heard_;
    case InputKind::pointer_move:
    case InputKind::wheel: return false;
  }
  return false;
}

void InputMap::begin_tick() {
  pointer_dx = pointer_dy = wheel = 0;
  for (auto& [name, key] : raw_) key.pressed = key.released = false;
  edges_.clear();
}

void InputMap::move_pointer(const InputEvent& event, std::vector<InputNotice>& notices) {
  const bool is_wheel = event.kind == InputKind::wheel;
  const auto kind = is_wheel ? InputNotice::Kind::wheel : InputNotice::Kind::pointer_move;
  if (notices.empty() || notices.back().kind != kind) notices.push_back({kind, "", 0, 0});
  InputNotice& notice = notices.back();
  if (is_wheel) {
    wheel += event.value;
    notice.x += event.value;
    return;
  }
  pointer_x = event.x;
  pointer_y = event.y;
  pointer_dx += event.dx;
  pointer_dy += event.dy;
  notice.x += event.dx;
  notice.y += event.dy;
}

void InputMap::press_or_release(const InputEvent& event, std::vector<InputNotice>& notices) {
  const bool press = event.kind == InputKind::press;
  const auto kind = press ? InputNotice::Kind::press : InputNotice::Kind::release;
  if (raw_[event.name].down == press) return;  // a key's repeat, or a release whose press another window got

  // Who is down before the change: what differs after it was pressed or released by it.
  std::vector<std::pair<std::string, bool>> before = {{event.name, raw_down(event.name)}};
  if (const std::string any_pad = any_pad_name(event.name); !any_pad.empty()) before.emplace_back(any_pad, raw_down(any_pad));
  std::vector<bool> actions_before;
  for (const auto& [action, names] : actions_) actions_before.push_back(action_down(names));

  raw_[event.name].down = press;
  raw_[event.name].value = press ? 1 : 0;

  const auto mark = [press](Key& key) { (press ? key.pressed : key.released) = true; };
  for (const auto& [name, was_down] : before) {
    if (raw_down(name) == was_down) continue;
    mark(raw_[name]);
    if (actions_.count(name) == 0) notices.push_back({kind, name, 0, 0});
  }
  std::size_t i = 0;
  for (const auto& [action, names] : actions_) {
    if (action_down(names) == actions_before[i++]) continue;
    mark(edges_[action]);
    notices.push_back({kind, action, 0, 0});
  }
}

const InputMap::Key* InputMap::find(const std::string& raw) const {
  const auto found = raw_.find(raw);
  return found == raw_.end() ? nullptr : &found->second;
}

bool InputMap::raw_down(const std::string& raw) const {
  const Key* key = find(raw);
  if (key && key->down) return true;
  for (const std::string& pad : pad_names(raw))
    if (raw_down(pad)) return true;
  return false;
}

double InputMap::raw_value(const std::string& raw) const {
  const Key* key = find(raw);
  double value = key ? key->value : 0;
  for (const std::string& pad : pad_names(raw)) value = std::max(value, raw_value(pad));
  return value;
}

bool InputMap::action_down(const std::vector<std::string>& names) const {
  return std::any_of(names.begin(), names.end(), [this](const std::string& raw) { return raw_down(raw); });
}

bool InputMap::is_down(const std::string& name) const {
  const auto action = actions_.find(name);
  return action == actions_.end() ? raw_down(name) : action_down(action->second);
}

bool InputMap::was_pressed(const std::string& name) const {
  const auto& keys = actions_.count(name) > 0 ? edges_ : raw_;
  const auto found = keys.find(name);
  return found != keys.end() && found->second.pressed;
}

bool InputMap::was_released(const std::string& name) const {
  const auto& keys = actions_.count(name) > 0 ? edges_ : raw_;
  const auto found = keys.find(name);
  return found != keys.end() && found->second.released;
}

double InputMap::value(const std::string& name) const {
  const auto action = actions_.find(name);
  if (action == actions_.end()) return raw_value(name);
  double value = 0;
  for (const std::string& raw : action->second) value = std::max(value, raw_value(raw));
  return value;
}

}  // namespace tumble
