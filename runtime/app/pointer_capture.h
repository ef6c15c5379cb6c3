// Whether the window holds the pointer: the game asks for it, and the person can always get it back.
#pragma once

#include "platform/window.h"

namespace tumble {

class PointerCapture {
 public:
  // What the game wants, and whether it plays now: not paused, no error on the screen. Returns whether to hold it.
  bool update(const WindowEvents& events, bool wanted, bool playing);

 private:
  bool in_front_ = true;
  bool freed_ = false;       // by escape, until the next click, or until the game asks or plays anew
  bool wanted_ = false, playing_ = false;
};

}  // namespace tumble
