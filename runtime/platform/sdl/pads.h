// Game pads: which are plugged in, and their buttons and sticks as raw input.
#pragma once

#include <SDL.h>

#include <array>
#include <map>
#include <string>
#include <vector>

#include "platform/held_input.h"
#include "platform/window.h"

namespace tumble {

class Pads {
 public:
  Pads() = default;
  ~Pads();
  Pads(const Pads&) = delete;
  Pads& operator=(const Pads&) = delete;

  // Looks for pads from now on; where SDL has no pads there are none.
  void start();
  // Reads pad events and ignores all others.
  void handle(const SDL_Event& event, HeldInput& held, WindowEvents& out);
  // As Window::rumble.
  void rumble(int pad, double strength, double seconds);
  // The window lost focus: the pads' values count as 0 until they change again.
  void forget();

 private:
  struct Pad {
    SDL_GameController* device = nullptr;
    SDL_JoystickID id = -1;
    std::string name;
    std::map<std::string, double> values;  // by control, without "pad_"
  };

  void plug_in(int device_index, std::vector<std::string>& notes);
  void unplug(SDL_JoystickID id, HeldInput& held, WindowEvents& out);
  void set_axis(SDL_JoystickID id, int axis, int value, HeldInput& held, std::vector<InputEvent>& out);
  void set(SDL_JoystickID id, const char* control, double value, HeldInput& held, std::vector<InputEvent>& out);

  bool started_ = false;
  std::array<Pad, kMaxPads> pads_;
};

}  // namespace tumble
