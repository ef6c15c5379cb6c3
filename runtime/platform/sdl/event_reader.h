// SDL's events as ours: what the game may see, what is for us.
#pragma once

#include <SDL.h>

#include "platform/held_input.h"
#include "platform/sdl/pads.h"
#include "platform/window.h"

namespace tumble {

class EventReader {
 public:
  // Until then pads are not looked for.
  void start_pads() { pads_.start(); }
  void rumble(int pad, double strength, double seconds) { pads_.rumble(pad, strength, seconds); }
  // Adds to `out` what `event` means. `window_height` is in SDL's window units.
  void read(const SDL_Event& event, int window_height, WindowEvents& out);

 private:
  void key(const SDL_KeyboardEvent& event, WindowEvents& out);
  void button(const SDL_MouseButtonEvent& event, double to_ui, WindowEvents& out);
  void motion(const SDL_MouseMotionEvent& event, double to_ui, WindowEvents& out);
  void window(const SDL_WindowEvent& event, WindowEvents& out);
  void pointer_to(double x, double y, double dx, double dy, WindowEvents& out);

  HeldInput held_;
  Pads pads_;
  double x_ = 0, y_ = 0;
};

}  // namespace tumble
