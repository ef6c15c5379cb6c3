#include "platform/sdl/video.h"

#include <SDL.h>

#include <cstdlib>

#include "base/error.h"
#include "platform/window.h"

namespace tumble {
namespace {

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

bool display_named() {
#if defined(__linux__)
  return !environment("DISPLAY").empty() || !environment("WAYLAND_DISPLAY").empty();
#else
  return true;
#endif
}

void refuse_invisible(bool offscreen, bool was_running) {
  if (offscreen || driver_is_visible(video_driver()) || !wanted_driver().empty()) return;
  const std::string driver = video_driver();
  SDL_QuitSubSystem(SDL_INIT_VIDEO);
  if (was_running)
    fail("window: cannot open on screen while this program draws off screen (driver '", driver,
         "'); end that first, or draw off screen");
  fail("window: no display to open a window on (SDL offers only '", driver,
       "'); start from a desktop session, or draw off screen");
}

}  // namespace

std::string video_driver() {
  const char* name = SDL_GetCurrentVideoDriver();
  return name ? name : "";
}

bool driver_is_visible(const std::string& driver) { return driver != "offscreen" && driver != "dummy"; }

std::string wanted_driver() { return environment("SDL_VIDEODRIVER"); }

Video::Video(bool offscreen) {
  // Ctrl-C ends the program as its author meant, and the screen saver is not ours to stop.
  SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
  SDL_SetHint(SDL_HINT_VIDEO_ALLOW_SCREENSAVER, "1");
  // A hint rather than the environment, which children and other libraries would inherit; the user's own wins over it.
  if (offscreen) SDL_SetHint(SDL_HINT_VIDEODRIVER, "offscreen");
  const bool was_running = !video_driver().empty();
  const bool ready = SDL_InitSubSystem(SDL_INIT_VIDEO) == 0;
  const std::string reason = SDL_GetError();
  SDL_ResetHint(SDL_HINT_VIDEODRIVER);
  if (!ready)
    fail("window: SDL cannot ", offscreen ? "draw off screen" : "open a display", " (", reason, "); ",
         offscreen ? "install Mesa's libEGL, or unset SDL_VIDEODRIVER" : "draw off screen instead");
  refuse_invisible(offscreen, was_running);
}

Video::~Video() { SDL_QuitSubSystem(SDL_INIT_VIDEO); }

bool Window::display_available() {
  if (!video_driver().empty()) return driver_is_visible(video_driver());
  if (!driver_is_visible(wanted_driver()) || !display_named()) return false;
  try {
    const Video probe(false);
    return driver_is_visible(video_driver());
  } catch (const Error&) {
    return false;
  }
}

}  // namespace tumble
