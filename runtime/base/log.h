// Where lines for the author go: the terminal, the overlay, a host's callback.
#pragma once

#include <functional>
#include <string>

#include "tumble/tumble.h"

namespace tumble {

// One line for the author. `print` is the script's own voice, `note` ours: a reload's summary and the like.
struct LogLine {
  LogLevel level = LogLevel::note;
  std::string text;
};

using LogSink = std::function<void(const LogLine&)>;

}  // namespace tumble
