// The device, through SDL's driver that writes to a file what a loudspeaker would get.
#include <catch2/catch.hpp>

#include <stdlib.h>
#include <unistd.h>

#include <chrono>
#include <cstring>
#include <thread>

#include "assets/temporary_folder.h"
#include "platform/audio.h"
#include "support/wav.h"

using namespace tumble;

namespace {

// An environment variable with another value for as long as this lives.
class Setting {
 public:
  Setting(const char* name, const std::string& value) : name_(name) {
    if (const char* before = getenv(name)) before_ = before;
    setenv(name, value.c_str(), 1);
  }
  ~Setting() {
    if (before_) setenv(name_, before_->c_str(), 1);
    else unsetenv(name_);
  }

 private:
  const char* name_;
  std::optional<std::string> before_;
};

std::vector<std::pair<float, float>> frames_of(const std::string& bytes) {
  std::vector<std::pair<float, float>> frames(bytes.size() / 8);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    std::memcpy(&frames[i].first, bytes.data() + 8 * i, 4);
    std::memcpy(&frames[i].second, bytes.data() + 8 * i + 4, 4);
  }
  return frames;
}

HeardSound tone_at_the_left() {
  HeardSound sound;
  sound.id = 1;
  sound.pcm = std::make_shared<const Pcm>(tone(440, 1));
  sound.place = Vec3{-2, 0, 0};
  return sound;
}

void play_to_its_end(Mixer& mixer, Audio& audio, const HeardSound& sound) {
  mixer.update({{sound}, 1});
  for (int i = 0; i < 5000 && mixer.voices() > 0; ++i) {
    audio.poll();
    mixer.update({});
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

}  // namespace

TEST_CASE("audio: a second of 440 Hz at the left reaches the device, and then silence", "[platform][audio]") {
  const TemporaryFolder folder;
  const Setting driver("SDL_AUDIODRIVER", "disk"), file("SDL_DISKAUDIOFILE", (folder / "out.pcm").string()), delay("SDL_DISKAUDIODELAY", "1");
  Mixer mixer;
  {
    const auto audio = Audio::open(mixer);
    REQUIRE(audio->has_device());
    play_to_its_end(mixer, *audio, tone_at_the_left());
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  CHECK(mixer.voices() == 0);

  const auto frames = frames_of(folder.read("out.pcm"));
  std::size_t first = 0, last = 0, crossings = 0;
  double left = 0, right = 0;
  float steepest = 0;
  for (std::size_t i = 1; i < frames.size(); ++i) {
    const auto& [l, r] = frames[i];
    if (l != 0 && first == 0) first = i;
    if (l != 0) last = i;
    crossings += frames[i - 1].first < 0 && l >= 0;
    left += l * l;
    right += r * r;
    steepest = std::max(steepest, std::abs(l - frames[i - 1].first));
  }
  CHECK(static_cast<double>(last - first) == Approx(48000).margin(2));
  CHECK(crossings == Approx(440).margin(1));
  // 0.9 of the way to the left, as the mixer's own test has it.
  CHECK(std::sqrt(left / right) == Approx(1 / std::tan(0.05 * kPi / 2)).epsilon(0.01));
  CHECK(std::sqrt(left / 48000) == Approx(0.5 / std::sqrt(2) * std::cos(0.05 * kPi / 2)).epsilon(0.01));
  CHECK(steepest < 2 * kPi * 440 / 48000 * 0.5 * 1.01);  // no click: nowhere steeper than the tone
  CHECK(frames.size() > last + 1000);
}

TEST_CASE("audio: without a device there is silence, and sounds still come to their end", "[platform][audio]") {
  const Setting driver("SDL_AUDIODRIVER", "there_is_no_such_driver");
  Mixer mixer;
  const auto audio = Audio::open(mixer);
  CHECK_FALSE(audio->has_device());
  HeardSound knock = tone_at_the_left();
  knock.pcm = std::make_shared<const Pcm>(tone(440, 0.05));
  play_to_its_end(mixer, *audio, knock);
  CHECK(mixer.voices() == 0);
}

TEST_CASE("audio: a machine without a device says nothing about it", "[platform][audio]") {
  const TemporaryFolder folder;
  const Setting driver("SDL_AUDIODRIVER", "alsa");  // writes of missing cards to the error stream
  const int kept = dup(STDERR_FILENO);
  REQUIRE(freopen((folder / "stderr").c_str(), "w", stderr));
  {
    Mixer mixer;
    const auto audio = Audio::open(mixer);
    audio->poll();
  }
  std::fflush(stderr);
  dup2(kept, STDERR_FILENO);
  close(kept);
  CHECK(folder.read("stderr") == "");
}
