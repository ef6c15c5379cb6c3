// Errors of game authors and hosts are tumble::Error; this builds their sentences.
#pragma once

#include <sstream>
#include <string>

#include "tumble/tumble.h"

namespace tumble {

// Joins its arguments as a stream would: fail("scene.get: no node '", path, "'").
template <class... Parts>
[[noreturn]] void fail(const Parts&... parts) {
  std::ostringstream out;
  (out << ... << parts);
  throw Error(out.str());
}

}  // namespace tumble
