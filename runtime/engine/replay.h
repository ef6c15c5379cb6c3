// Recorded input: what a run was fed, so that it can be run again to the same world hash.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "engine/storage.h"
#include "platform/input.h"

namespace tumble {

// The width of the screen against its height reaches games through the pointer and the ui, so it is recorded too: as the
// `value` of this name, which no key has.
inline const std::string kScreenShape = "screen_shape";

struct Recording {
  std::string game;                                          // title, to notice a recording of another game
  std::uint64_t seed = 1;
  double tick_rate = 60;                                     // Hz
  std::vector<std::pair<std::uint64_t, InputEvent>> events;  // tick that they were sampled in, counted from 0, ascending
  std::uint64_t ticks = 0;                                   // length of the run; no event is later
  std::uint64_t hash = 0;                                    // of the world after the last tick
  Stored stored;                                             // what was stored when it began
  bool operator==(const Recording&) const = default;
};

// JSON, one event a line, so that two recordings can be compared with diff.
std::string write_recording(const Recording& recording);
// Throws Error naming the file and the place in it for what is broken, out of order or of a later version.
Recording read_recording(const std::string& text, const std::string& file);

}  // namespace tumble
