#include "platform/held_input.h"

namespace tumble {
namespace {

// Two thresholds, so that a stick resting on one of them does not chatter.
constexpr double kPressAt = 0.5, kReleaseAt = 0.4;

InputEvent event(InputKind kind, const std::string& name, double value = 0) {
  InputEvent result;
  result.kind = kind;
  result.name = name;
  result.value = value;
  return result;
}

}  // namespace

void HeldInput::press(const std::string& name, std::vector<InputEvent>& out) {
  if (held_.insert(name).second) out.push_back(event(InputKind::press, name));
}

void HeldInput::release(const std::string& name, std::vector<InputEvent>& out) {
  if (held_.erase(name) > 0) out.push_back(event(InputKind::release, name));
}

void HeldInput::set_value(const std::string& name, double value, std::vector<InputEvent>& out) {
  double& last = values_[name];
  if (value == last) return;
  last = value;
  if (value >= kPressAt) press(name, out);
  if (value <= kReleaseAt) release(name, out);
  out.push_back(event(InputKind::value, name, value));
}

void HeldInput::release_all(std::vector<InputEvent>& out) {
  for (auto& [name, value] : values_)
    if (value != 0) set_value(name, 0, out);
  for (const std::string& name : held_) out.push_back(event(InputKind::release, name));
  held_.clear();
}

}  // namespace tumble
