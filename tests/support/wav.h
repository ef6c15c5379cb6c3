// Sounds made of a formula, and WAV files made of samples.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "base/math.h"
#include "base/pcm.h"

inline std::string little_endian(std::uint32_t value, int size) {
  std::string bytes;
  for (int i = 0; i < size; ++i) bytes += static_cast<char>(value >> (8 * i));
  return bytes;
}

// `kind` 1 is whole numbers, 3 floats; `data` are the samples as bytes.
inline std::string wav_file(int kind, int channels, int rate, int bits, const std::string& data) {
  const auto u = [](int value) { return static_cast<std::uint32_t>(value); };
  const int block = channels * bits / 8;
  const std::string format = little_endian(u(kind), 2) + little_endian(u(channels), 2) + little_endian(u(rate), 4) +
                             little_endian(u(rate * block), 4) + little_endian(u(block), 2) + little_endian(u(bits), 2);
  const std::string chunks = "WAVEfmt " + little_endian(16, 4) + format + "data" + little_endian(static_cast<std::uint32_t>(data.size()), 4) + data;
  return "RIFF" + little_endian(static_cast<std::uint32_t>(chunks.size()), 4) + chunks;
}

inline std::string wav_file(const tumble::Pcm& pcm) {
  std::string data;
  for (const std::int16_t sample : pcm.samples) data += little_endian(static_cast<std::uint16_t>(sample), 2);
  return wav_file(1, pcm.channels, pcm.rate, 16, data);
}

inline tumble::Pcm tone(double hertz, double seconds, double loudness = 0.5, int rate = 48000) {
  tumble::Pcm pcm;
  pcm.rate = rate;
  for (int i = 0; i < static_cast<int>(std::lround(seconds * rate)); ++i)
    pcm.samples.push_back(static_cast<std::int16_t>(std::lround(32767 * loudness * std::sin(2 * tumble::kPi * hertz * i / rate))));
  return pcm;
}
