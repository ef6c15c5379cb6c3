#include "platform/audio.h"

#include <SDL.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#if defined(__unix__)
#include <fcntl.h>
#include <unistd.h>
#endif

namespace tumble {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int kBlock = 1024;                            // frames that the device asks for at a time: 21 ms
constexpr std::chrono::seconds kBetweenTries{3};

// ALSA and others write to the terminal that they found no device, which is nothing to a game. While this lives, what is
// written to the standard error stream goes nowhere.
class QuietTerminal {
 public:
#if defined(__unix__)
  QuietTerminal() {
    std::fflush(stderr);
    kept_ = dup(STDERR_FILENO);
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (kept_ >= 0 && nowhere >= 0) dup2(nowhere, STDERR_FILENO);
    if (nowhere >= 0) close(nowhere);
  }
  ~QuietTerminal() {
    if (kept_ < 0) return;
    std::fflush(stderr);
    dup2(kept_, STDERR_FILENO);
    close(kept_);
  }
#else
  QuietTerminal() = default;
#endif
  QuietTerminal(const QuietTerminal&) = delete;
  QuietTerminal& operator=(const QuietTerminal&) = delete;

 private:
  [[maybe_unused]] int kept_ = -1;
};

class SdlAudio : public Audio {
 public:
  explicit SdlAudio(Mixer& mixer) : mixer_(mixer) { open_device(); }
  ~SdlAudio() override { close_device(); }

  void poll() override {
    const Clock::time_point now = Clock::now();
    if (device_ && SDL_GetAudioDeviceStatus(device_) == SDL_AUDIO_STOPPED) close_device();
    if (!device_ && now - tried_ > kBetweenTries) open_device();
    if (!device_) play_to_nobody(now);
    polled_ = now;
  }
  bool has_device() const override { return device_ != 0; }

 private:
  void open_device() {
    tried_ = Clock::now();
    const QuietTerminal quiet;
    if (SDL_InitSubSystem(SDL_INIT_AUDIO) != 0) return;
    SDL_AudioSpec want{};
    want.freq = mixer_.rate();
    want.format = AUDIO_F32SYS;
    want.channels = 2;
    want.samples = kBlock;
    want.userdata = this;
    want.callback = [](void* self, Uint8* bytes, int size) {
      static_cast<SdlAudio*>(self)->mixer_.mix(reinterpret_cast<float*>(bytes), size / static_cast<int>(2 * sizeof(float)));
    };
    device_ = SDL_OpenAudioDevice(nullptr, 0, &want, nullptr, 0);
    if (device_) SDL_PauseAudioDevice(device_, 0);
    else SDL_QuitSubSystem(SDL_INIT_AUDIO);  // so that the next try looks for drivers anew
  }

  void close_device() {
    if (!device_) return;
    const QuietTerminal quiet;
    SDL_CloseAudioDevice(device_);
    SDL_QuitSubSystem(SDL_INIT_AUDIO);
    device_ = 0;
  }

  // Sounds go on unheard, so that one that was to be over by then does not begin when a device comes.
  void play_to_nobody(Clock::time_point now) {
    if (polled_ == Clock::time_point{}) return;
    float block[2 * kBlock];
    const double most = 0.25;  // s; a machine that slept has nothing to catch up with
    auto frames = static_cast<int>(std::min(std::chrono::duration<double>(now - polled_).count(), most) * mixer_.rate());
    for (; frames > 0; frames -= kBlock) mixer_.mix(block, std::min(frames, kBlock));
  }

  Mixer& mixer_;
  SDL_AudioDeviceID device_ = 0;
  Clock::time_point tried_, polled_;
};

}  // namespace

std::unique_ptr<Audio> Audio::open(Mixer& mixer) { return std::make_unique<SdlAudio>(mixer); }

}  // namespace tumble
