#include "platform/sdl/pads.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "platform/sdl/keys.h"

namespace tumble {
namespace {

// Sticks at rest wander by about this much; the rest of the way is stretched over 0..1.
constexpr double kDeadZone = 0.15;

double without_dead_zone(int axis_value) {
  const double value = std::clamp(axis_value / 32767.0, -1.0, 1.0);
  const double size = std::max(0.0, std::abs(value) - kDeadZone) / (1 - kDeadZone);
  return std::copysign(size, value);
}

bool is_analog(std::string_view control) {
  return control.ends_with("trigger") || control.ends_with('+') || control.ends_with('-');
}

void tell(const std::string& name, bool analog, double value, HeldInput& held, std::vector<InputEvent>& out) {
  if (analog) held.set_value(name, value, out);
  else if (value > 0) held.press(name, out);
  else held.release(name, out);
}

}  // namespace

Pads::~Pads() {
  for (Pad& pad : pads_)
    if (pad.device) SDL_GameControllerClose(pad.device);
  if (started_) SDL_QuitSubSystem(SDL_INIT_GAMECONTROLLER);
}

void Pads::start() { started_ = started_ || SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER) == 0; }

void Pads::handle(const SDL_Event& event, HeldInput& held, std::vector<InputEvent>& out) {
  switch (event.type) {
    case SDL_CONTROLLERDEVICEADDED: plug_in(event.cdevice.which); break;
    case SDL_CONTROLLERDEVICEREMOVED: unplug(event.cdevice.which, held, out); break;
    case SDL_CONTROLLERAXISMOTION: set_axis(event.caxis.which, event.caxis.axis, event.caxis.value, held, out); break;
    case SDL_CONTROLLERBUTTONDOWN:
    case SDL_CONTROLLERBUTTONUP:
      set(event.cbutton.which, pad_button_name(event.cbutton.button), event.cbutton.state, held, out);
      break;
    default: break;
  }
}

void Pads::forget() {
  for (Pad& pad : pads_) pad.values.clear();
}

void Pads::plug_in(int device_index) {
  const SDL_JoystickID id = SDL_JoystickGetDeviceInstanceID(device_index);
  for (const Pad& pad : pads_)
    if (pad.device && pad.id == id) return;
  for (Pad& pad : pads_) {
    if (pad.device) continue;
    pad = {SDL_GameControllerOpen(device_index), id, {}};
    return;
  }
}

void Pads::unplug(SDL_JoystickID id, HeldInput& held, std::vector<InputEvent>& out) {
  for (Pad& pad : pads_) {
    if (!pad.device || pad.id != id) continue;
    const auto values = pad.values;
    for (const auto& [control, value] : values) set(id, control.c_str(), 0, held, out);
    SDL_GameControllerClose(pad.device);
    pad = {};
  }
}

void Pads::set_axis(SDL_JoystickID id, int axis, int value, HeldInput& held, std::vector<InputEvent>& out) {
  const PadAxisNames names = pad_axis_names(axis);
  const double amount = without_dead_zone(value);
  const char* ended = amount >= 0 ? names.negative : names.positive;
  const char* active = amount >= 0 ? names.positive : names.negative;
  set(id, ended, 0, held, out);  // first, so that nobody sees both directions held
  set(id, active, std::abs(amount), held, out);
}

void Pads::set(SDL_JoystickID id, const char* control, double value, HeldInput& held, std::vector<InputEvent>& out) {
  if (!control) return;
  double any = 0;
  for (std::size_t i = 0; i < pads_.size(); ++i) {
    Pad& pad = pads_[i];
    if (!pad.device) continue;
    if (pad.id == id) {
      pad.values[control] = value;
      tell("pad" + std::to_string(i + 1) + "_" + control, is_analog(control), value, held, out);
    }
    any = std::max(any, pad.values[control]);
  }
  tell(std::string("pad_") + control, is_analog(control), any, held, out);
}

}  // namespace tumble
