// From samples to what is heard: the side of mix(). Nothing in here waits or takes memory.
#include <algorithm>
#include <cmath>

#include "platform/mixer.h"

namespace tumble {

namespace {

constexpr double kTail = 0.003;     // s over which the end of a file is softened, for files that end in full swing
constexpr float kClear = 0.8f;      // up to here nothing is bent

// What is too loud is bent rather than cut: straight up to kClear, from there on towards 1.
float limited(float x) {
  const float size = std::abs(x);
  if (size <= kClear) return x;
  return std::copysign(kClear + (1 - kClear) * std::tanh((size - kClear) / (1 - kClear)), x);
}

// The curve of Catmull and Rom through the middle two of four samples; at a whole frame it is that frame's sample.
float between(float a, float b, float c, float d, float t) {
  return b + 0.5f * t * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)));
}

float near(float now, float goal, float step) { return now < goal ? std::min(now + step, goal) : std::max(now - step, goal); }

}  // namespace

void Mixer::mix(float* stereo, int frames) {
  take_orders();
  std::fill(stereo, stereo + 2 * frames, 0.0f);
  for (std::size_t i = 0; i < voices_.size(); ++i) {
    Voice& voice = voices_[i];
    if (!voice.live) continue;
    mix_voice(voice, stereo, frames);
    if (!voice.live) finished_[i].store(voice.order.serial, std::memory_order_release);
  }
  for (int i = 0; i < 2 * frames; ++i) stereo[i] = limited(stereo[i]);
}

// Where update() is just writing, the orders of before are good for another block.
void Mixer::take_orders() {
  const std::unique_lock guard(lock_, std::try_to_lock);
  if (!guard || !fresh_) return;
  fresh_ = false;
  for (std::size_t i = 0; i < voices_.size(); ++i) {
    const Order& order = orders_[i];
    Voice& voice = voices_[i];
    if (order.serial == 0) continue;
    if (order.serial != voice.order.serial) voice = {order, order.start, order.left, order.right, 0, true};
    else voice.order = order;
  }
}

void Mixer::mix_voice(Voice& voice, float* stereo, int frames) {
  const Order& order = voice.order;
  const auto length = static_cast<double>(order.frames);
  const auto count = static_cast<std::ptrdiff_t>(order.frames);
  const float goal = order.wish == Wish::play ? 1.0f : 0.0f;
  // One sample of a frame that may lie beyond the ends: in a loop they meet, else there is silence.
  const auto sample = [&](std::ptrdiff_t frame, int channel) {
    if (frame < 0 || frame >= count) {
      if (!order.loop) return 0.0f;
      frame = (frame % count + count) % count;
    }
    return static_cast<float>(order.samples[frame * order.channels + channel]) / 32768;
  };
  const double tail = kTail * rate_ * order.step;

  for (int i = 0; i < frames; ++i) {
    voice.level = near(voice.level, goal, order.ramp);
    if (voice.level == 0 && goal == 0) {
      voice.live = order.wish != Wish::stop;
      return;
    }
    voice.left += (order.left - voice.left) * smoothing_;
    voice.right += (order.right - voice.right) * smoothing_;

    const auto frame = static_cast<std::ptrdiff_t>(voice.at);
    const auto part = static_cast<float>(voice.at - static_cast<double>(frame));
    const auto heard = [&](int channel) {
      return between(sample(frame - 1, channel), sample(frame, channel), sample(frame + 1, channel), sample(frame + 2, channel), part);
    };
    float left = heard(0), right = order.channels == 2 ? heard(1) : left;
    if (order.together) left = right = (left + right) / 2;
    float level = voice.level;
    if (!order.loop) level *= static_cast<float>(std::min(1.0, (length - voice.at) / tail));
    stereo[2 * i] += left * voice.left * level;
    stereo[2 * i + 1] += right * voice.right * level;

    voice.at += order.step;
    if (voice.at < length) continue;
    if (!order.loop) {
      voice.live = false;
      return;
    }
    voice.at = std::fmod(voice.at, length);
  }
}

}  // namespace tumble
