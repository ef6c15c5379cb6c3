// OGG files with Vorbis inside, through libvorbisfile.
#include <vorbis/vorbisfile.h>

#include <algorithm>
#include <cstring>

#include "assets/sound.h"
#include "base/error.h"

namespace tumble {

namespace {

// The bytes of a file, as the library wants to read them.
struct Source {
  std::string_view bytes;
  std::size_t at = 0;
};

std::size_t read_source(void* into, std::size_t size, std::size_t count, void* from) {
  auto& source = *static_cast<Source*>(from);
  const std::size_t whole = size ? std::min(count, (source.bytes.size() - source.at) / size) : 0;
  std::memcpy(into, source.bytes.data() + source.at, whole * size);
  source.at += whole * size;
  return whole;
}

int seek_source(void* from, ogg_int64_t offset, int whence) {
  auto& source = *static_cast<Source*>(from);
  const auto size = static_cast<ogg_int64_t>(source.bytes.size());
  const ogg_int64_t to = offset + (whence == SEEK_CUR ? static_cast<ogg_int64_t>(source.at) : whence == SEEK_END ? size : 0);
  if (to < 0 || to > size) return -1;
  source.at = static_cast<std::size_t>(to);
  return 0;
}

long tell_source(void* from) { return static_cast<long>(static_cast<Source*>(from)->at); }

// The library passes over what it cannot read, and ends where the file does. A file is whole if its pages follow each
// other to the last byte and the last one says that it is the last.
void check_pages(std::string_view bytes, const std::string& name) {
  constexpr std::size_t kHeader = 27;
  constexpr int kLastPage = 4;
  bool last = false;
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t there = bytes.size() - at;
    if (there < kHeader) fail("'", name, "' is cut off; copy or export it again");
    if (bytes.substr(at, 4) != "OggS") fail("'", name, "' is damaged at byte ", at, "; copy or export it again");
    const auto segments = static_cast<unsigned char>(bytes[at + 26]);
    std::size_t size = kHeader + segments;
    if (there < size) fail("'", name, "' is cut off; copy or export it again");
    for (std::size_t i = 0; i < segments; ++i) size += static_cast<unsigned char>(bytes[at + kHeader + i]);
    if (there < size) fail("'", name, "' is cut off; copy or export it again");
    last = (static_cast<unsigned char>(bytes[at + 5]) & kLastPage) != 0;
    at += size;
  }
  if (!last) fail("'", name, "' is cut off: its last page is missing; copy or export it again");
}

// An opened file, closed with its scope.
struct Decoder {
  OggVorbis_File file{};
  Source source;

  Decoder(std::string_view bytes, const std::string& name) : source{bytes} {
    const ov_callbacks calls{read_source, seek_source, nullptr, tell_source};
    if (ov_open_callbacks(&source, &file, nullptr, 0, calls) != 0)
      fail("'", name, "' is an OGG file but holds no Vorbis sound that can be read; export it as OGG Vorbis, or as WAV");
  }
  ~Decoder() { ov_clear(&file); }
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;
};

}  // namespace

Pcm read_ogg(std::string_view bytes, const std::string& name) {
  check_pages(bytes, name);
  Decoder decoder(bytes, name);
  if (ov_streams(&decoder.file) != 1) fail("'", name, "' holds several sounds one after the other; export one of them");
  const vorbis_info* info = ov_info(&decoder.file, -1);
  const auto frames = static_cast<double>(ov_pcm_total(&decoder.file, -1));
  check_sound(name, info->channels, static_cast<double>(info->rate), frames);

  Pcm pcm;
  pcm.rate = static_cast<int>(info->rate);
  pcm.channels = info->channels;
  pcm.samples.reserve(static_cast<std::size_t>(frames) * static_cast<std::size_t>(info->channels));
  std::int16_t block[4096];
  for (int section = 0;;) {
    constexpr int little_endian = 0, bytes_each = 2, with_sign = 1;
    const long read = ov_read(&decoder.file, reinterpret_cast<char*>(block), sizeof block, little_endian, bytes_each, with_sign, &section);
    if (read == 0) break;
    const std::size_t count = static_cast<std::size_t>(std::max(read, 0L)) / sizeof block[0];
    // What it promised is also all that it may give.
    if (read < 0 || pcm.samples.size() + count > pcm.samples.capacity()) fail("'", name, "' is damaged; copy or export it again");
    pcm.samples.insert(pcm.samples.end(), block, block + count);
  }
  if (pcm.samples.empty()) fail("'", name, "' holds no sound; its length is 0");
  return pcm;
}

}  // namespace tumble
