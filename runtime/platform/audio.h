// The loudspeakers. The only door to SDL's sound.
#pragma once

#include <memory>

#include "platform/mixer.h"

namespace tumble {

class Audio {
 public:
  // Plays what the mixer mixes, which must outlive this. Where there is no device, or none that can be opened, it is
  // silent without a word, and so it is when the device goes; it comes back with one. SDL_AUDIODRIVER in the
  // environment is respected.
  static std::unique_ptr<Audio> open(Mixer& mixer);
  virtual ~Audio() = default;

  // Once a frame: looks whether the device is still there.
  virtual void poll() = 0;
  virtual bool has_device() const = 0;
};

}  // namespace tumble
