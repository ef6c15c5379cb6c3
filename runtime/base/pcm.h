// Sound as samples: what a file is decoded to, and what the mixer plays.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tumble {

struct Pcm {
  int rate = 48000;                   // frames in a second
  int channels = 1;                   // 1 or 2
  std::vector<std::int16_t> samples;  // frame by frame; of two channels left comes before right

  std::size_t frames() const { return samples.size() / static_cast<std::size_t>(channels); }
  double seconds() const { return static_cast<double>(frames()) / rate; }
};

}  // namespace tumble
