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

std::string known_name(const char* name) { return name ? name : "a pad without a name"; }

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

void Pads::handle(const SDL_Event& event, HeldInput& held, WindowEvents& out) {
  switch (event.type) {
    case SDL_CONTROLLERDEVICEADDED: plug_in(event.cdevice.which, out.notes); break;
    case SDL_CONTROLLERDEVICEREMOVED: unplug(event.cdevice.which, held, out); break;
    case SDL_CONTROLLERAXISMOTION: set_axis(event.caxis.which, event.caxis.axis, event.caxis.value, held, out.input); break;
    case SDL_CONTROLLERBUTTONDOWN:
    case SDL_CONTROLLERBUTTONUP:
      set(event.cbutton.which, pad_button_name(event.cbutton.button), event.cbutton.state, held, out.input);
      break;
    case SDL_JOYDEVICEADDED:
      if (!SDL_IsGameController(event.jdevice.which))
        out.notes.push_back("'" + known_name(SDL_JoystickNameForIndex(event.jdevice.which)) +
                            "' is not used: nobody has told SDL which of its buttons is which (SDL_GAMECONTROLLERCONFIG can)");
      break;
    default: break;
  }
}

void Pads::forget() {
  for (Pad& pad : pads_) pad.values.clear();
}

void Pads::plug_in(int device_index, std::vector<std::string>& notes) {
  const SDL_JoystickID id = SDL_JoystickGetDeviceInstanceID(device_index);
  for (const Pad& pad : pads_)
    if (pad.device && pad.id == id) return;
  const std::string name = known_name(SDL_GameControllerNameForIndex(device_index));
  const auto free = std::find_if(pads_.begin(), pads_.end(), [](const Pad& pad) { return !pad.device; });
  if (free == pads_.end()) {
    notes.push_back("'" + name + "' is not used: there are " + std::to_string(kMaxPads) + " pads already");
    return;
  }
  *free = {SDL_GameControllerOpen(device_index), id, name, {}};
  if (free->device) notes.push_back("pad " + std::to_string(free - pads_.begin() + 1) + " is here: " + name);
}

void Pads::unplug(SDL_JoystickID id, HeldInput& held, WindowEvents& out) {
  for (Pad& pad : pads_) {
    if (!pad.device || pad.id != id) continue;
    out.notes.push_back("pad " + std::to_string(&pad - pads_.data() + 1) + " is gone: " + pad.name);
    const auto values = pad.values;
    for (const auto& [control, value] : values) set(id, control.c_str(), 0, held, out.input);
    SDL_GameControllerClose(pad.device);
    pad = {};
  }
}

void Pads::rumble(int number, double strength, double seconds) {
  const auto motor = static_cast<Uint16>(std::lround(std::clamp(strength, 0.0, 1.0) * 65535));
  const auto ms = static_cast<Uint32>(std::lround(seconds * 1000));
  for (int i = 0; i < kMaxPads; ++i) {
    SDL_GameController* device = pads_[static_cast<std::size_t>(i)].device;
    if (device && (number == 0 || number == i + 1)) SDL_GameControllerRumble(device, motor, motor, ms);
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
