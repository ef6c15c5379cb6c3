#include "assets/sound.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "base/error.h"

namespace tumble {

namespace {

// A place in a file of little-endian numbers. Reading past the end is refused by who asks.
std::uint32_t number_at(std::string_view bytes, std::size_t at, int size) {
  std::uint32_t value = 0;
  for (int i = 0; i < size; ++i) value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + static_cast<std::size_t>(i)])) << (8 * i);
  return value;
}

struct WavFormat {
  int kind = 0, channels = 0, bits = 0;  // kind: 1 whole numbers, 3 floats
  std::uint32_t rate = 0;
  int sample_bytes() const { return bits / 8; }
};

WavFormat read_format(std::string_view chunk, const std::string& name) {
  if (chunk.size() < 16) fail("'", name, "' is damaged: its format chunk has ", chunk.size(), " bytes rather than 16; export it again as WAV");
  WavFormat format;
  format.kind = static_cast<int>(number_at(chunk, 0, 2));
  format.channels = static_cast<int>(number_at(chunk, 2, 2));
  format.rate = number_at(chunk, 4, 4);
  format.bits = static_cast<int>(number_at(chunk, 14, 2));
  constexpr int kExtensible = 0xfffe;  // the kind then stands further on
  if (format.kind == kExtensible && chunk.size() >= 26) format.kind = static_cast<int>(number_at(chunk, 24, 2));
  const bool whole = format.kind == 1 && (format.bits == 8 || format.bits == 16 || format.bits == 24 || format.bits == 32);
  const bool floats = format.kind == 3 && format.bits == 32;
  if (!whole && !floats)
    fail("'", name, "' holds samples of kind ", format.kind, " with ", format.bits, " bits, which cannot be read; export it as WAV with 16 bits, or as OGG");
  const auto block = static_cast<int>(number_at(chunk, 12, 2));
  if (block != format.channels * format.sample_bytes())
    fail("'", name, "' is damaged: ", format.channels, " samples of ", format.bits, " bits do not make ", block, " bytes; export it again as WAV");
  return format;
}

std::int16_t whole_sample(std::string_view data, std::size_t at, int size) {
  if (size == 1) return static_cast<std::int16_t>((static_cast<int>(number_at(data, at, 1)) - 128) * 256);
  // Moved up to 32 bits, so that the sign comes along; then rounded to 16.
  const auto value = static_cast<std::int32_t>(number_at(data, at, size) << (8 * (4 - size)));
  return static_cast<std::int16_t>(std::min((static_cast<std::int64_t>(value) + 0x8000) >> 16, std::int64_t{32767}));
}

std::int16_t float_sample(std::string_view data, std::size_t at, const std::string& name) {
  const float value = std::bit_cast<float>(number_at(data, at, 4));
  if (!std::isfinite(value)) fail("'", name, "' is damaged: it holds a sample that is no finite number; export it again");
  return static_cast<std::int16_t>(std::lround(std::clamp(value, -1.0f, 1.0f) * 32767));
}

// The content of the chunks `fmt ` and `data`. Others are passed over, as the format asks.
struct WavChunks {
  std::string_view format, data;
};

WavChunks find_chunks(std::string_view bytes, const std::string& name) {
  WavChunks chunks;
  constexpr std::uint32_t kUnknown = 0xffffffff;  // written by programs that could not go back to the beginning
  std::size_t at = 12;
  while (at + 8 <= bytes.size() && !chunks.data.data()) {
    const std::string_view id = bytes.substr(at, 4);
    std::uint32_t size = number_at(bytes, at + 4, 4);
    const std::size_t there = bytes.size() - at - 8;
    if (id == "data" && size == kUnknown) size = static_cast<std::uint32_t>(there);
    if (size > there)
      fail("'", name, "' is cut off: ", size, " bytes of '", id, "' were promised and ", there, " are there; copy or export it again");
    if (id == "fmt ") chunks.format = bytes.substr(at + 8, size);
    if (id == "data") chunks.data = bytes.substr(at + 8, size);
    at += 8 + size + size % 2;
  }
  if (!chunks.format.data()) fail("'", name, "' is damaged: it does not say how its samples are written; export it again as WAV");
  if (!chunks.data.data()) fail("'", name, "' is cut off before its samples; copy or export it again");
  return chunks;
}

}  // namespace

void check_sound(const std::string& name, int channels, double rate, double frames) {
  if (channels < 1 || channels > 2) fail("'", name, "' has ", channels, " channels; export it with one (mono) or two (stereo)");
  if (rate < kLowestSoundRate || rate > kHighestSoundRate)
    fail("'", name, "' has ", rate, " frames a second; export it with ", kLowestSoundRate, " to ", kHighestSoundRate, ", 44100 as a rule");
  if (frames < 1) fail("'", name, "' holds no sound; its length is 0");
  if (frames > kLongestSound * rate)
    fail("'", name, "' lasts ", std::floor(frames / rate), " s; at most ", kLongestSound, " s are played: cut it, or let a shorter piece loop");
}

Pcm read_wav(std::string_view bytes, const std::string& name) {
  if (bytes.size() < 12) fail("'", name, "' is cut off after ", bytes.size(), " bytes; copy or export it again");
  if (bytes.substr(8, 4) != "WAVE") fail("'", name, "' is a RIFF file but holds no sound; export it as WAV");
  const WavChunks chunks = find_chunks(bytes, name);
  const WavFormat format = read_format(chunks.format, name);
  const auto size = static_cast<std::size_t>(format.sample_bytes());
  check_sound(name, format.channels, format.rate, static_cast<double>(chunks.data.size() / (size * static_cast<std::size_t>(std::max(format.channels, 1)))));

  Pcm pcm;
  pcm.rate = static_cast<int>(format.rate);
  pcm.channels = format.channels;
  const std::size_t frame = size * static_cast<std::size_t>(format.channels), count = chunks.data.size() / frame * static_cast<std::size_t>(format.channels);
  pcm.samples.resize(count);
  for (std::size_t i = 0; i < count; ++i)
    pcm.samples[i] = format.kind == 1 ? whole_sample(chunks.data, i * size, format.sample_bytes()) : float_sample(chunks.data, i * size, name);
  return pcm;
}

Pcm read_sound(std::string_view bytes, const std::string& name) {
  if (bytes.empty()) fail("'", name, "' is empty; export it again as WAV or OGG");
  if (bytes.starts_with("RIFF")) return read_wav(bytes, name);
  if (bytes.starts_with("OggS")) return read_ogg(bytes, name);
  fail("'", name, "' is neither a WAV nor an OGG file, whatever its name says; export it as one of them");
}

}  // namespace tumble
