// Who has a voice: the side of update().
#include "platform/mixer.h"

#include <algorithm>
#include <cmath>

namespace tumble {

namespace {

constexpr double kShortestFade = 0.004;  // s; a shorter one can be heard as a click
constexpr double kHeadSize = 0.9;        // of the way to one side that a sound beside us goes
constexpr double kSmoothing = 0.01;      // s in which loudness follows by 63 %
constexpr double kLate = 0.25;           // s; one that is met so late begins in its middle, others with their attack
constexpr double kNear = 1;              // m; nearer sounds come from all around

}  // namespace

double loudness_at(double distance, double range) {
  if (std::isinf(range)) return 1;
  if (distance >= range) return 0;
  const double full = range / 8, part = distance / range, window = 1 - part * part * part * part;
  return full / std::max(full, distance) * window * window;
}

Ears ears_at(Vec3 place, double range) {
  const double distance = length(place);
  const double side = kHeadSize * place.x / std::max(distance, kNear);  // -1 left, 1 right
  const double turn = (side + 1) * kPi / 4, loudness = loudness_at(distance, range);
  return {loudness * std::cos(turn), loudness * std::sin(turn)};
}

// A sound of the list with what it asks for, and its voice, if it has one.
struct Mixer::Wanted {
  const HeardSound* sound = nullptr;
  Order order;
  Slot* slot = nullptr;
  float loudness() const { return std::max(order.left, order.right); }
};

Mixer::Mixer(int rate) : rate_(rate), smoothing_(static_cast<float>(1 - std::exp(-1 / (kSmoothing * rate)))) {}

int Mixer::voices() const {
  return static_cast<int>(std::count_if(slots_.begin(), slots_.end(), [](const Slot& slot) { return slot.pcm != nullptr; }));
}

void Mixer::update(const SoundList& list) {
  collect_finished();
  std::vector<Wanted> wanted = find_wanted(list);
  for (Slot& slot : slots_) {
    if (!slot.pcm) continue;
    const auto found = std::find_if(wanted.begin(), wanted.end(), [&](const Wanted& w) { return w.slot == &slot; });
    if (found != wanted.end()) {
      follow(slot, found->order);
    } else {
      const bool anew = std::any_of(wanted.begin(), wanted.end(), [&](const Wanted& w) { return w.sound->id == slot.id; });
      if (slot.order.loop || slot.order.wish == Wish::hold || anew) let_go(slot);
    }
  }

  // The loudest are heard; of equally loud ones those that came later.
  std::erase_if(wanted, [](const Wanted& w) { return w.sound->stopped; });
  std::stable_sort(wanted.begin(), wanted.end(), [](const Wanted& a, const Wanted& b) {
    return a.loudness() != b.loudness() ? a.loudness() > b.loudness() : a.sound->id > b.sound->id;
  });
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const Wanted& w = wanted[i];
    const bool heard = i < static_cast<std::size_t>(kHeard);
    if (heard && (w.slot || start(w))) continue;
    if (w.slot) let_go(*w.slot);
    if (!w.sound->loop) over_.insert(w.sound->id);  // a loop may come in again, in its middle; a knock may not
  }
  hand_over();
}

// What can be heard of a list, and forgets which of the others have had their time.
std::vector<Mixer::Wanted> Mixer::find_wanted(const SoundList& list) {
  std::vector<Wanted> wanted;
  std::set<std::uint64_t> still_over;
  for (const HeardSound& sound : list.sounds) {
    const bool over = over_.contains(sound.id);
    if (over) still_over.insert(sound.id);
    if (!sound.pcm) continue;
    const auto slot = std::find_if(slots_.begin(), slots_.end(), [&](const Slot& s) { return s.id == sound.id && s.pcm == sound.pcm; });
    if (slot != slots_.end()) wanted.push_back({&sound, order_of(sound, list.volume), &*slot});
    else if (!over && !sound.stopped && !sound.held) wanted.push_back({&sound, order_of(sound, list.volume), nullptr});
  }
  over_ = std::move(still_over);
  return wanted;
}

void Mixer::stop_all() {
  collect_finished();
  for (Slot& slot : slots_)
    if (slot.pcm) let_go(slot);
  over_.clear();
  hand_over();
}

// Frees the voices that mix() is done with.
void Mixer::collect_finished() {
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    Slot& slot = slots_[i];
    if (!slot.pcm || finished_[i].load(std::memory_order_acquire) != slot.order.serial) continue;
    if (slot.id) over_.insert(slot.id);
    slot = {};
  }
}

void Mixer::follow(Slot& slot, const Order& order) {
  const Order before = slot.order;
  slot.order = order;
  slot.order.serial = before.serial;
  slot.order.start = before.start;
}

// Nobody's any more: it fades out.
void Mixer::let_go(Slot& slot) {
  slot.id = 0;
  slot.order.wish = Wish::stop;
  slot.order.ramp = ramp_of(0);
}

// False where every voice is taken: some still fade out.
bool Mixer::start(const Wanted& wanted) {
  const auto free = std::find_if(slots_.begin(), slots_.end(), [](const Slot& slot) { return !slot.pcm; });
  if (free == slots_.end()) return false;
  free->id = wanted.sound->id;
  free->pcm = wanted.sound->pcm;
  free->order = wanted.order;
  free->order.serial = next_serial_++;
  return true;
}

float Mixer::ramp_of(double fade) const { return static_cast<float>(1 / (std::max(fade, kShortestFade) * rate_)); }

Mixer::Order Mixer::order_of(const HeardSound& sound, double volume) const {
  const Pcm& pcm = *sound.pcm;
  Order order;
  order.wish = sound.stopped ? Wish::stop : sound.held ? Wish::hold : Wish::play;
  order.samples = pcm.samples.data();
  order.frames = pcm.frames();
  order.channels = pcm.channels;
  order.together = sound.place && pcm.channels == 2;
  order.loop = sound.loop;
  if (sound.time > kLate) order.start = std::fmod(sound.time * pcm.rate, static_cast<double>(order.frames));
  order.step = sound.pitch * pcm.rate / rate_;
  // Without a place one channel goes to both ears with equal power, and two go where they belong.
  Ears ears{1, 1};
  if (sound.place) ears = ears_at(*sound.place, sound.range);
  else if (pcm.channels == 1) ears = {std::sqrt(0.5), std::sqrt(0.5)};
  order.left = static_cast<float>(ears.left * sound.volume * volume);
  order.right = static_cast<float>(ears.right * sound.volume * volume);
  order.ramp = ramp_of(sound.fade);
  return order;
}

void Mixer::hand_over() {
  const std::lock_guard guard(lock_);
  for (std::size_t i = 0; i < slots_.size(); ++i) orders_[i] = slots_[i].order;
  fresh_ = true;
}

}  // namespace tumble
