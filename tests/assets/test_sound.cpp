// Decoded sounds against what was written; and every way in which a file can be broken.
#include <catch2/catch.hpp>

#include <bit>

#include "assets/library.h"
#include "assets/sound.h"
#include "support/source_tree.h"
#include "support/wav.h"

using namespace tumble;

namespace {

using Samples = std::vector<std::int16_t>;

std::string message_of(const std::string& bytes) {
  try {
    read_sound(bytes, "a.wav");
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

std::string float_bytes(float value) { return little_endian(std::bit_cast<std::uint32_t>(value), 4); }

std::string tone_ogg() { return read_source(source_tree("tests/assets/files/tone.ogg")); }

// The check sum of an Ogg page: a cyclic redundancy check with the polynomial 0x04c11db7, its own field counted as 0.
std::uint32_t page_sum(std::string page) {
  page.replace(22, 4, 4, '\0');
  std::uint32_t sum = 0;
  for (const char byte : page) {
    sum ^= static_cast<std::uint32_t>(static_cast<unsigned char>(byte)) << 24;
    for (int bit = 0; bit < 8; ++bit) sum = sum << 1 ^ (sum & 0x80000000 ? 0x04c11db7 : 0);
  }
  return sum;
}

// With sums that are right again, so that a change comes through to the decoder. Pages begin where they did.
std::string with_right_sums(std::string bytes, const std::string& before) {
  for (std::size_t at = before.find("OggS"); at != std::string::npos;) {
    const std::size_t next = before.find("OggS", at + 4);
    const std::size_t size = std::min(next, bytes.size()) - at;
    bytes.replace(at + 22, 4, little_endian(page_sum(bytes.substr(at, size)), 4));
    at = next;
  }
  return bytes;
}

// Whatever the bytes are, there is a sound within the limits or an Error; nothing else, and no more memory than that.
void must_be_sound_or_error(const std::string& bytes) {
  try {
    const Pcm pcm = read_sound(bytes, "broken");
    CHECK((pcm.channels == 1 || pcm.channels == 2));
    CHECK(pcm.frames() >= 1);
    CHECK(pcm.seconds() <= kLongestSound);
  } catch (const Error& error) {
    CHECK(std::string(error.what()).starts_with("'broken' "));
  }
}

}  // namespace

TEST_CASE("sound: WAV samples of every kind come to the same 16 bits", "[assets][sound]") {
  // Each value by the rule of its format: 8 bits are from 0 with silence at 128, the others have signs.
  CHECK(read_sound(wav_file(1, 1, 8000, 8, std::string("\x80\xff\x00", 3)), "8").samples == Samples{0, 127 * 256, -32768});
  CHECK(read_sound(wav_file(1, 1, 8000, 16, little_endian(0x1234, 2) + little_endian(0xfffe, 2)), "16").samples == Samples{0x1234, -2});
  CHECK(read_sound(wav_file(1, 1, 8000, 24, little_endian(0x123456, 3) + little_endian(0xffff00, 3)), "24").samples == Samples{0x1234, -1});
  CHECK(read_sound(wav_file(1, 1, 8000, 32, little_endian(0x12348000, 4) + little_endian(0x80000000, 4)), "32").samples == Samples{0x1235, -32768});
  CHECK(read_sound(wav_file(3, 1, 8000, 32, float_bytes(0.5f) + float_bytes(-1) + float_bytes(7)), "float").samples == Samples{16384, -32767, 32767});
}

TEST_CASE("sound: rate, channels and length are the file's", "[assets][sound]") {
  const Pcm pcm = read_sound(wav_file(1, 2, 44100, 16, std::string(4 * 22050, '\1')), "stereo");
  CHECK(pcm.rate == 44100);
  CHECK(pcm.channels == 2);
  CHECK(pcm.frames() == 22050);
  CHECK(pcm.seconds() == 0.5);
}

TEST_CASE("sound: other chunks, an odd chunk and an unknown length are read past", "[assets][sound]") {
  const std::string plain = wav_file(1, 1, 8000, 16, "abcd");
  std::string list = plain;
  list.insert(12, "LIST" + little_endian(3, 4) + std::string("xyz\0", 4));
  CHECK(read_sound(list, "list").samples == read_sound(plain, "plain").samples);
  std::string streamed = plain;
  streamed.replace(streamed.size() - 8, 4, "\xff\xff\xff\xff");
  CHECK(read_sound(streamed, "streamed").samples == read_sound(plain, "plain").samples);
}

TEST_CASE("sound: an OGG file sounds like the tone it was made from", "[assets][sound]") {
  const Pcm pcm = read_sound(tone_ogg(), "tone.ogg"), truth = tone(440, 1, 0.5, 44100);
  REQUIRE(pcm.rate == 44100);
  REQUIRE(pcm.channels == 1);
  REQUIRE(pcm.frames() == 44100);
  // Compression at this quality leaves an error of a few percent; away from the ends, where it rings.
  double error = 0, power = 0;
  for (std::size_t i = 4410; i < 39690; ++i) {
    error += std::pow(pcm.samples[i] - truth.samples[i], 2);
    power += std::pow(truth.samples[i], 2);
  }
  CHECK(std::sqrt(error / power) < 0.05);
}

TEST_CASE("sound: what cannot be played says why and what to do", "[assets][sound]") {
  const std::string good = wav_file(1, 1, 8000, 16, "abcd");
  CHECK(message_of("") == "'a.wav' is empty; export it again as WAV or OGG");
  CHECK(message_of("ID3 and so on") == "'a.wav' is neither a WAV nor an OGG file, whatever its name says; export it as one of them");
  CHECK(message_of(good.substr(0, good.size() - 1)) == "'a.wav' is cut off: 4 bytes of 'data' were promised and 3 are there; copy or export it again");
  CHECK(message_of(good.substr(0, 36)) == "'a.wav' is cut off before its samples; copy or export it again");
  CHECK(message_of(wav_file(1, 1, 8000, 16, "")) == "'a.wav' holds no sound; its length is 0");
  CHECK(message_of(wav_file(1, 6, 8000, 16, "abcdabcdabcd")) == "'a.wav' has 6 channels; export it with one (mono) or two (stereo)");
  CHECK(message_of(wav_file(1, 0, 8000, 16, "ab")) == "'a.wav' has 0 channels; export it with one (mono) or two (stereo)");
  CHECK(message_of(wav_file(1, 1, 900, 16, "ab")) == "'a.wav' has 900 frames a second; export it with 2000 to 192000, 44100 as a rule");
  CHECK(message_of(wav_file(2, 1, 8000, 4, "ab")) ==
        "'a.wav' holds samples of kind 2 with 4 bits, which cannot be read; export it as WAV with 16 bits, or as OGG");
  CHECK(message_of(wav_file(3, 1, 8000, 32, float_bytes(NAN))) == "'a.wav' is damaged: it holds a sample that is no finite number; export it again");
  CHECK(message_of(wav_file(1, 1, 2000, 8, std::string(2000 * 601, 'a'))) ==
        "'a.wav' lasts 601 s; at most 600 s are played: cut it, or let a shorter piece loop");
  CHECK(message_of(tone_ogg().substr(0, 4000)) == "'a.wav' is cut off; copy or export it again");
  CHECK(message_of("OggS" + std::string(60, '\0')) == "'a.wav' is damaged at byte 27; copy or export it again");
}

TEST_CASE("sound: a WAV file cut anywhere is refused", "[assets][sound]") {
  const std::string whole = wav_file(tone(440, 0.01, 0.5, 8000));
  for (std::size_t size = 0; size < whole.size(); ++size) {
    INFO(size << " bytes");
    CHECK(message_of(whole.substr(0, size)) != "");
  }
}

TEST_CASE("sound: an OGG file cut anywhere is refused", "[assets][sound]") {
  const std::string whole = tone_ogg();
  for (std::size_t size = 0; size < whole.size(); ++size) {
    INFO(size << " bytes");
    CHECK(message_of(whole.substr(0, size)) != "");
  }
}

TEST_CASE("sound: any changed byte gives a sound or a sentence", "[assets][sound]") {
  for (const std::string& whole : {wav_file(tone(440, 0.005, 0.5, 8000)), tone_ogg()})
    for (std::size_t at = 0; at < whole.size(); ++at)
      for (const int change : {0x01, 0x80, 0xff}) {
        std::string bytes = whole;
        bytes[at] = static_cast<char>(bytes[at] ^ change);
        must_be_sound_or_error(bytes);
      }
}

TEST_CASE("sound: a changed OGG file with right sums gives a sound or a sentence", "[assets][sound]") {
  const std::string whole = tone_ogg();
  REQUIRE(with_right_sums(whole, whole) == whole);  // we sum as its writer did
  for (std::size_t at = 0; at < whole.size(); at += at < 200 ? 1 : 7)
    for (const int change : {0x01, 0xff}) {
      std::string bytes = whole;
      bytes[at] = static_cast<char>(bytes[at] ^ change);
      must_be_sound_or_error(with_right_sums(bytes, whole));
    }
}

TEST_CASE("sound: a library keeps a file until it was saved, and names the nearest to a missing one once", "[assets][sound]") {
  std::map<std::string, std::string> files{{"boom.wav", wav_file(tone(440, 0.5))}};
  std::vector<std::string> lines;
  AssetLibrary library(
      [&](const std::string& path) { return files.contains(path) ? std::optional(files[path]) : std::nullopt; },
      [&](const LogLine& line) { lines.push_back(line.text); }, [&] { return std::vector<std::string>{"boom.wav", "main.lua"}; });
  const std::shared_ptr<const Pcm> first = library.sound("boom.wav");
  REQUIRE(first);
  CHECK(library.sound("boom.wav") == first);

  files["boom.wav"] = wav_file(tone(440, 0.25));
  library.forget("boom.wav");
  CHECK(library.sound("boom.wav")->seconds() == 0.25);
  CHECK(first->seconds() == 0.5);  // who plays it still has it

  CHECK(library.sound("bom.wav") == nullptr);
  CHECK(library.sound("bom.wav") == nullptr);
  CHECK(lines == std::vector<std::string>{"sound: no file 'bom.wav' in the game; did you mean 'boom.wav'?; there is silence instead"});
}
