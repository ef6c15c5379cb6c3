// The mixer against formulas: what comes out of it, sample by sample.
#include <catch2/catch.hpp>

#include <algorithm>
#include <thread>

#include "platform/mixer.h"
#include "support/wav.h"

using namespace tumble;

namespace {

constexpr int kRate = 48000;

struct Heard {
  std::vector<float> left, right;
  void add(Mixer& mixer, int frames) {
    std::vector<float> block(static_cast<std::size_t>(2 * frames));
    mixer.mix(block.data(), frames);
    for (int i = 0; i < frames; ++i) {
      left.push_back(block[static_cast<std::size_t>(2 * i)]);
      right.push_back(block[static_cast<std::size_t>(2 * i + 1)]);
    }
  }
};

Heard mixed(Mixer& mixer, int frames) {
  Heard heard;
  heard.add(mixer, frames);
  return heard;
}

std::shared_ptr<const Pcm> shared(Pcm pcm) { return std::make_shared<const Pcm>(std::move(pcm)); }

HeardSound sound_of(std::shared_ptr<const Pcm> pcm, std::uint64_t id = 1) {
  HeardSound sound;
  sound.id = id;
  sound.pcm = std::move(pcm);
  return sound;
}

Heard mixed(const HeardSound& sound, int frames, double volume = 1) {
  Mixer mixer(kRate);
  mixer.update({{sound}, volume});
  return mixed(mixer, frames);
}

double power(const std::vector<float>& samples, std::size_t begin = 0) {
  double sum = 0;
  for (std::size_t i = begin; i < samples.size(); ++i) sum += samples[i] * samples[i];
  return std::sqrt(sum / static_cast<double>(samples.size() - begin));
}

int crossings(const std::vector<float>& samples) {
  int count = 0;
  for (std::size_t i = 1; i < samples.size(); ++i) count += samples[i - 1] < 0 && samples[i] >= 0;
  return count;
}

// The largest step from one sample to the next.
float steepest(const std::vector<float>& samples) {
  float most = std::abs(samples.front());
  for (std::size_t i = 1; i < samples.size(); ++i) most = std::max(most, std::abs(samples[i] - samples[i - 1]));
  return most;
}

// The steepest that a tone of that height and loudness is.
double slope(double hertz, double loudness) { return 2 * kPi * hertz / kRate * loudness; }

// Past the ramp of a beginning, s * kRate.
constexpr std::size_t kBegun = 480;

}  // namespace

TEST_CASE("mixer: at its own rate a sound comes out sample by sample", "[platform][mixer]") {
  const auto pcm = shared(tone(440, 0.5));
  const Heard heard = mixed(sound_of(pcm), 20000, 0.5);
  for (std::size_t i = kBegun; i < heard.left.size(); ++i)
    REQUIRE(heard.left[i] == Approx(pcm->samples[i] / 32768.0 * std::sqrt(0.5) * 0.5).margin(1e-6));
  CHECK(heard.left == heard.right);
}

TEST_CASE("mixer: two channels stay on their sides at full loudness", "[platform][mixer]") {
  Pcm stereo;
  stereo.channels = 2;
  for (int i = 0; i < 9600; ++i) {
    stereo.samples.push_back(6000);
    stereo.samples.push_back(-3000);
  }
  const Heard heard = mixed(sound_of(shared(stereo)), 2000);
  CHECK(heard.left[1000] == Approx(6000 / 32768.0));
  CHECK(heard.right[1000] == Approx(-3000 / 32768.0));
}

TEST_CASE("mixer: pitch and other rates keep the tone's height and length", "[platform][mixer]") {
  // A second of 440 Hz at 22050 frames, played an octave higher: 880 Hz for half a second.
  HeardSound sound = sound_of(shared(tone(440, 1, 0.5, 22050)));
  sound.pitch = 2;
  const Heard heard = mixed(sound, kRate);
  CHECK(crossings({heard.left.begin(), heard.left.begin() + kRate / 2}) == Approx(440).margin(1));
  CHECK(power({heard.left.begin() + kRate / 2 + 1, heard.left.end()}) == 0);
  CHECK(power(std::vector<float>(heard.left.begin() + kBegun, heard.left.begin() + 20000)) == Approx(0.5 * std::sqrt(0.5) * std::sqrt(0.5)).epsilon(0.01));
}

TEST_CASE("mixer: a resampled tone is the tone between its samples", "[platform][mixer]") {
  // Cubic curves through 50 samples a period miss a sine by less than a ten-thousandth of its height.
  const Heard heard = mixed(sound_of(shared(tone(440, 0.2, 0.5, 22050))), 9000);
  for (std::size_t i = kBegun; i < heard.left.size(); ++i)
    REQUIRE(heard.left[i] == Approx(0.5 * std::sqrt(0.5) * std::sin(2 * kPi * 440 * static_cast<double>(i) / kRate)).margin(1e-4));
}

TEST_CASE("mixer: a loop has no gap, to the sample", "[platform][mixer]") {
  // 997 frames: no multiple of any block or period.
  Pcm pcm;
  for (int i = 0; i < 997; ++i) pcm.samples.push_back(static_cast<std::int16_t>((i * 7919) % 20001 - 10000));
  HeardSound sound = sound_of(shared(pcm));
  sound.loop = true;
  const Heard heard = mixed(sound, 20000);
  for (std::size_t i = kBegun; i < heard.left.size(); ++i)
    REQUIRE(heard.left[i] == Approx(pcm.samples[i % 997] / 32768.0 * std::sqrt(0.5)).margin(1e-6));
}

TEST_CASE("mixer: a loop at another pitch goes over its seam without a click", "[platform][mixer]") {
  HeardSound sound = sound_of(shared(tone(480, 0.1)));  // 48 whole periods
  sound.loop = true;
  sound.pitch = 1.37;
  const Heard heard = mixed(sound, kRate);
  CHECK(steepest(heard.left) <= slope(480 * 1.37, 0.5 * std::sqrt(0.5)) * 1.01);
  CHECK(crossings(heard.left) == Approx(480 * 1.37).margin(1));
}

TEST_CASE("mixer: beginnings, ends, stops and pauses do not click", "[platform][mixer]") {
  // The worst file: full swing from the first sample to the last.
  Pcm square;
  square.samples.assign(12000, 16000);
  const double height = 16000 / 32768.0 * std::sqrt(0.5);
  const double most = height / (0.003 * kRate) * 1.01;  // straight over 3 ms, the shortest ramp
  HeardSound sound = sound_of(shared(square));
  CHECK(steepest(mixed(sound, 13000).left) < most);

  Mixer mixer(kRate);
  mixer.update({{sound}, 1});
  Heard heard = mixed(mixer, 5000);
  sound.held = true;
  mixer.update({{sound}, 1});
  heard.add(mixer, 5000);
  CHECK(heard.left.back() == 0);
  sound.held = false;
  mixer.update({{sound}, 1});
  heard.add(mixer, 3000);
  CHECK(heard.left.back() == Approx(height));  // it went on where it stood: 8000 of 12000 frames have passed
  sound.stopped = true;
  mixer.update({{sound}, 1});
  heard.add(mixer, 1000);
  CHECK(heard.left.back() == 0);
  CHECK(steepest(heard.left) < most);
  mixer.update({});
  CHECK(mixer.voices() == 0);
}

TEST_CASE("mixer: volume and place are followed without a step", "[platform][mixer]") {
  HeardSound sound = sound_of(shared(tone(200, 1)));
  sound.loop = true;
  Mixer mixer(kRate);
  Heard heard;
  for (int i = 0; i < 40; ++i) {
    sound.volume = i % 2 ? 1 : 0.2;
    sound.place = Vec3{i % 3 ? 2.0 : -2.0, 0, 0};
    mixer.update({{sound}, 1});
    heard.add(mixer, 1000);
  }
  // The tone's own slope and what the change of loudness, spread over 10 ms, adds.
  CHECK(steepest(heard.left) < slope(200, 0.5) + 0.5 / (0.01 * kRate));
}

TEST_CASE("mixer: a place decides what each ear hears", "[platform][mixer]") {
  const auto ears = [](Vec3 place) {
    HeardSound sound = sound_of(shared(tone(440, 1)));
    sound.place = place;
    sound.range = 16;
    const Heard heard = mixed(sound, 20000);
    return std::pair(power(heard.left, kBegun), power(heard.right, kBegun));
  };
  const double full = 0.5 / std::sqrt(2);  // the power of a tone of 0.5
  const auto [front_left, front_right] = ears({0, 0, -1.5});
  CHECK(front_left == Approx(full * std::sqrt(0.5)).epsilon(0.002));
  CHECK(front_left == Approx(front_right));
  // Nine tenths of the way to the left: a twentieth of a quarter turn short of the axis.
  const auto [left, right] = ears({-1.5, 0, 0});
  CHECK(left == Approx(full * std::cos(0.05 * kPi / 2)).epsilon(0.002));
  CHECK(right == Approx(full * std::sin(0.05 * kPi / 2)).epsilon(0.01));
  // The same power in all directions, here half right and behind.
  const auto [back_left, back_right] = ears({1, 0.5, 1});
  CHECK(std::hypot(back_left, back_right) == Approx(full).epsilon(0.002));
  // Half the range: a quarter by the inverse law, bent by (1 - 1/16)^2.
  const auto [far_left, far_right] = ears({0, 8, 0});
  CHECK(std::hypot(far_left, far_right) == Approx(full * 0.25 * std::pow(15.0 / 16, 2)).epsilon(0.002));
  CHECK(ears({0, 0, 16}) == std::pair(0.0, 0.0));
}

TEST_CASE("mixer: loudness falls steadily to nothing at the range", "[platform][mixer]") {
  CHECK(loudness_at(0, 30) == 1);
  for (double d = 0; d < 30; d += 0.1) CHECK(loudness_at(d + 0.1, 30) <= loudness_at(d, 30));
  CHECK(loudness_at(29.9, 30) < 1e-4);
  CHECK(loudness_at(1e9, std::numeric_limits<double>::infinity()) == 1);
}

TEST_CASE("mixer: too much is bent, not cut, and never leaves -1 to 1", "[platform][mixer]") {
  Mixer mixer(kRate);
  SoundList list;
  for (std::uint64_t id = 1; id <= 6; ++id) {
    list.sounds.push_back(sound_of(shared(tone(100, 1, 0.9)), id));
    list.sounds.back().loop = true;
  }
  mixer.update(list);
  const Heard heard = mixed(mixer, 9600);
  const float most = *std::max_element(heard.left.begin(), heard.left.end());
  CHECK(most <= 1);
  CHECK(most > 0.99f);
  // Up to 0.8 nothing is changed.
  const Heard soft = mixed(sound_of(shared(tone(100, 1, 0.99))), 9600);
  CHECK(*std::max_element(soft.left.begin(), soft.left.end()) == Approx(0.99 * std::sqrt(0.5)).epsilon(1e-3));
}

TEST_CASE("mixer: the quietest give way, and a loop comes back where it would be", "[platform][mixer]") {
  Mixer mixer(kRate);
  SoundList list;
  const auto pcm = shared(tone(440, 1));
  for (std::uint64_t id = 1; id <= Mixer::kHeard; ++id) {
    list.sounds.push_back(sound_of(pcm, id));
    list.sounds.back().volume = 0.01 * static_cast<double>(id);
    list.sounds.back().loop = true;
  }
  mixer.update(list);
  mixed(mixer, 1000);
  CHECK(mixer.voices() == Mixer::kHeard);

  list.sounds.push_back(sound_of(pcm, 100));
  mixer.update(list);
  mixed(mixer, 1000);
  mixer.update(list);
  CHECK(mixer.voices() == Mixer::kHeard);  // the newcomer, and one that had 0.01 has gone

  list.sounds.pop_back();
  list.sounds.front().time = 0.5;
  mixer.update(list);
  mixed(mixer, 60000);
  mixer.update(list);
  CHECK(mixer.voices() == Mixer::kHeard);
}

TEST_CASE("mixer: a sound that ended is not begun again while it is listed", "[platform][mixer]") {
  Mixer mixer(kRate);
  const SoundList list{{sound_of(shared(tone(440, 0.01)))}, 1};
  mixer.update(list);
  mixed(mixer, 1000);
  for (int i = 0; i < 3; ++i) {
    mixer.update(list);
    CHECK(power(mixed(mixer, 1000).left) == 0);
  }
}

TEST_CASE("mixer: what is no longer listed rings out, a loop ends", "[platform][mixer]") {
  Mixer mixer(kRate);
  HeardSound knock = sound_of(shared(tone(440, 0.2)), 1), hum = sound_of(shared(tone(440, 0.2)), 2);
  hum.loop = true;
  mixer.update({{knock}, 1});
  mixed(mixer, 1000);
  mixer.update({});
  CHECK(power(mixed(mixer, 8000).left, 7000) > 0.2);
  mixed(mixer, 1000);

  mixer.update({{hum}, 1});
  mixed(mixer, 1000);
  mixer.update({});
  CHECK(power(mixed(mixer, 8000).left, 7000) == 0);
}

TEST_CASE("mixer: a fade takes its time, in and out", "[platform][mixer]") {
  HeardSound sound = sound_of(shared(tone(1000, 1)));
  sound.loop = true;
  sound.fade = 0.5;
  Mixer mixer(kRate);
  mixer.update({{sound}, 1});
  const double full = 0.5 * std::sqrt(0.5) / std::sqrt(2);
  Heard heard = mixed(mixer, kRate / 4);  // half of the way up: the last 2 periods have half of the power
  CHECK(power(heard.left, heard.left.size() - 96) == Approx(full / 2).epsilon(0.02));
  mixed(mixer, kRate / 2);
  sound.stopped = true;
  mixer.update({{sound}, 1});
  heard = mixed(mixer, kRate / 4);
  CHECK(power(heard.left, heard.left.size() - 96) == Approx(full / 2).epsilon(0.02));
  CHECK(power(mixed(mixer, kRate / 2).left, kRate / 4 + 100) == 0);
}

TEST_CASE("mixer: two threads at once neither wait nor lose a voice", "[platform][mixer]") {
  Mixer mixer(kRate);
  std::atomic<bool> done = false;
  std::thread device([&] {
    std::vector<float> block(1024);
    while (!done) mixer.mix(block.data(), 512);
  });
  std::uint64_t id = 1;
  for (int i = 0; i < 2000; ++i) {
    SoundList list;
    for (int k = 0; k < 10; ++k) list.sounds.push_back(sound_of(shared(tone(440, 0.002)), id + static_cast<std::uint64_t>(k)));
    id += 3;
    mixer.update(list);
  }
  mixer.stop_all();
  for (int i = 0; i < 10000 && mixer.voices() > 0; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    mixer.update({});
  }
  done = true;
  device.join();
  CHECK(mixer.voices() == 0);
}
