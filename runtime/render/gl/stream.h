// Vertices that are new in every picture: one buffer, one layout.
#pragma once

#include <cstddef>
#include <initializer_list>

#include "render/gl/functions.h"

namespace tumble {

class Stream {
 public:
  // The attributes at locations 0, 1, ... by their number of floats, packed; `divisor` 1 advances per instance.
  Stream(const Gl& gl, std::initializer_list<int> floats, int divisor);
  ~Stream();
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;

  // Sends `bytes` and makes them what the next draw reads.
  void use(const void* data, std::size_t bytes);

 private:
  const Gl& gl_;
  GLuint array_ = 0, buffer_ = 0;
};

}  // namespace tumble
