// SDL's video subsystem, once per holder: which driver it takes, and how it behaves inside somebody else's program.
#pragma once

#include <string>

namespace tumble {

class Video {
 public:
  // Throws Error where SDL has no driver for it.
  explicit Video(bool offscreen);
  ~Video();
  Video(const Video&) = delete;
  Video& operator=(const Video&) = delete;
};

// The driver in use, such as "x11"; "" when none is.
std::string video_driver();
// "offscreen" and "dummy" show nothing to anybody.
bool driver_is_visible(const std::string& driver);
// The driver that the user asked for in the environment, or "".
std::string wanted_driver();

}  // namespace tumble
