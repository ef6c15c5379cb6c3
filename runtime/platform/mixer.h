// Mixes what a game lets be heard into stereo. Plain arithmetic: it knows no device, no files and no scripts.
//
// One thread says by update() what is to be heard now, whole, as a draw list says what is to be seen; another, as a rule
// the device's, calls mix(). The two share one small table under a lock that mix() only tries: it waits for nobody, takes
// no memory and gives none back.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <vector>

#include "base/math.h"
#include "base/pcm.h"

namespace tumble {

// One sound as it is to be heard now. A sound without loop that is no longer listed rings out; one with loop ends.
struct HeardSound {
  std::uint64_t id = 0;             // the same in every list
  std::shared_ptr<const Pcm> pcm;   // another one: it begins anew
  double volume = 1, pitch = 1;
  bool loop = false;
  bool held = false;                // stands still, silent: the game is paused
  bool stopped = false;             // ends now
  double fade = 0;                  // s that its beginning and its stop take; 0 is as short as makes no click
  double time = 0;                  // s of the file that have passed: where it begins if the mixer meets it late
  std::optional<Vec3> place;        // from the ear, m: x right, y up, z back; none: in the middle, at any distance
  double range = 30;                // m; from there on a sound with a place is silent
};

struct SoundList {
  std::vector<HeardSound> sounds;
  double volume = 1;                // of everything
};

// How loud a sound is at a distance: 1 up to an eighth of the range, from there on the inverse of the distance, bent
// down to 0 at the range.
double loudness_at(double distance, double range);

// What reaches the two ears.
struct Ears {
  double left = 0, right = 0;
};
// Of equal power in every direction, 0.71 on both sides from the front; never all on one side, as with real ears.
Ears ears_at(Vec3 place, double range);

class Mixer {
 public:
  explicit Mixer(int rate = 48000);  // frames a second

  void update(const SoundList& list);
  // Everything ends, softly: another game begins.
  void stop_all();
  // Overwrites `frames` pairs of left and right, -1 to 1. One thread at a time.
  void mix(float* stereo, int frames);

  int rate() const { return rate_; }
  // How many sounds have a voice, those that fade out counted.
  int voices() const;

  // So many are heard at once at most, the loudest; the rest of the voices are for those that fade out.
  static constexpr int kHeard = 40;
  static constexpr int kVoices = 64;

 private:
  enum class Wish : std::uint8_t { play, hold, stop };
  // What update() wants of a voice.
  struct Order {
    std::uint32_t serial = 0;        // 0: nothing; another one: a new sound
    Wish wish = Wish::play;
    const std::int16_t* samples = nullptr;  // kept alive by the slot until mix() has said that it is done with them
    std::size_t frames = 0;
    int channels = 1;
    bool together = false;           // two channels become one
    bool loop = false;
    double start = 0;                // frame
    double step = 1;                 // frames of the file for one of ours
    float left = 0, right = 0;
    float ramp = 1;                  // how much the level rises or falls in each frame
  };
  // The same voice as update() sees it.
  struct Slot {
    std::uint64_t id = 0;            // 0: of nobody, fading out
    std::shared_ptr<const Pcm> pcm;  // null: free
    Order order;
  };
  // And as mix() sees it.
  struct Voice {
    Order order;
    double at = 0;                   // frame
    float left = 0, right = 0, level = 0;
    bool live = false;
  };
  struct Wanted;

  std::vector<Wanted> find_wanted(const SoundList& list);
  void collect_finished();
  void follow(Slot& slot, const Order& order);
  void let_go(Slot& slot);
  bool start(const Wanted& wanted);
  float ramp_of(double fade) const;
  Order order_of(const HeardSound& sound, double volume) const;
  void hand_over();
  void take_orders();
  void mix_voice(Voice& voice, float* stereo, int frames);

  int rate_;
  std::uint32_t next_serial_ = 1;
  std::array<Slot, kVoices> slots_;
  std::set<std::uint64_t> over_;     // listed, but have had their time
  std::mutex lock_;                  // guards orders_ and fresh_
  std::array<Order, kVoices> orders_;
  bool fresh_ = false;
  std::array<Voice, kVoices> voices_;
  float smoothing_;                  // of loudness, for each frame
  std::array<std::atomic<std::uint32_t>, kVoices> finished_{};  // the last serial that mix() is done with
};

}  // namespace tumble
