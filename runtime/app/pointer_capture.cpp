#include "app/pointer_capture.h"

namespace tumble {

bool PointerCapture::update(const WindowEvents& events, bool wanted, bool playing) {
  if (events.focus_lost) in_front_ = false;
  if (events.focus_gained) in_front_ = true;
  if ((wanted && !wanted_) || (playing && !playing_)) freed_ = false;
  for (const InputEvent& event : events.input) {
    if (event.kind != InputKind::press) continue;
    if (event.name == "escape") freed_ = true;
    if (event.name.starts_with("pointer")) freed_ = false;
  }
  wanted_ = wanted;
  playing_ = playing;
  return wanted && playing && in_front_ && !freed_;
}

}  // namespace tumble
