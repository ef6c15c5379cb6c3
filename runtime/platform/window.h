// A window with a GL context, or a picture off screen where there is no display. The only door to SDL's video.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "platform/input.h"

namespace tumble {

struct WindowDef {
  std::string title = "Tumble";
  int width = 1280, height = 720;  // pixels on screen, before the display's own scale
  bool fullscreen = false;
  bool offscreen = false;          // draw without a display
  bool vsync = true;
  bool es = false;                 // ask for OpenGL ES 3.0 rather than 3.3 core
};

// What people did to the window since the last poll, beside input for the game.
struct WindowEvents {
  std::vector<InputEvent> input;   // in order; on loss of focus a release of everything held comes by itself
  // Function keys pressed. "f3", "f5" and "f11" are ours and kept from the game; the others are in `input` too.
  std::vector<std::string> keys;
  std::vector<std::string> notes;  // for the log: a pad that came or went
  bool quit = false;
  bool focus_lost = false, focus_gained = false;
};

class Window {
 public:
  // Throws Error where no GL 3.3 or ES 3.0 is to be had; the text says what was tried. An SDL_VIDEODRIVER in the
  // environment is respected; off screen, it then means a window that nobody sees. One process draws either on screen
  // or off screen at a time, since SDL has one video driver.
  static std::unique_ptr<Window> open(const WindowDef& def);
  // Is there a display to open a window on (X11 or Wayland on Linux)?
  static bool display_available();
  virtual ~Window() = default;

  virtual WindowEvents poll() = 0;
  virtual int width() const = 0;   // of the drawing, in pixels
  virtual int height() const = 0;
  virtual bool is_es() const = 0;
  virtual void present() = 0;
  virtual void set_fullscreen(bool on) = 0;
  virtual bool fullscreen() const = 0;
  virtual void set_size(int width, int height) = 0;  // in the units of WindowDef
  virtual void set_title(const std::string& title) = 0;
  virtual void capture_pointer(bool on) = 0;  // hidden and endless
  // Typed text comes as events, with the person's input method and, where there is one, a keyboard on the screen. Off at
  // first.
  virtual void want_text(bool on) = 0;
  // Shakes the pad of that number, from 1; 0 is all. Strength 0..1. Pads that cannot do nothing.
  virtual void rumble(int pad, double strength, double seconds) = 0;
  // The thread's GL calls go to this window from here on; renderers call it, for there may be several windows.
  virtual void make_current() = 0;
  virtual void* gl_function(const char* name) const = 0;
};

}  // namespace tumble
