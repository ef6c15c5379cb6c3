#include "base/team.h"

#include <algorithm>

#if defined(__x86_64__) || defined(__i386__)
#include <immintrin.h>
#endif

namespace tumble {

namespace {

// How often a helper looks for work before it goes to sleep: some 50 microseconds, as long as a step's serial parts.
constexpr int kLooks = 2000;
// How often the caller looks whether helpers are done before it lets others have the processor.
constexpr int kPatience = 4000;

void pause() {
#if defined(__x86_64__) || defined(__i386__)
  _mm_pause();
#endif
}

int there_are(int wanted) {
#ifdef __EMSCRIPTEN__
  (void)wanted;
  return 1;
#else
  const auto known = static_cast<int>(std::thread::hardware_concurrency());
  return std::clamp(wanted, 1, std::max(1, known));
#endif
}

}  // namespace

Team::Team(int threads) : asked_for_(threads), size_(there_are(threads)), shares_(static_cast<std::size_t>(size_)) {}

Team::~Team() {
  ended_ = true;
  ++round_;
  round_.notify_all();
  for (std::thread& helper : helpers_) helper.join();
}

void Team::start() {
  for (int i = 1; i < size_; ++i) helpers_.emplace_back([this, i] { help(static_cast<std::size_t>(i)); });
}

// A helper that comes late finds the work closed and leaves; one that is inside is waited for. So the caller goes on
// when all is done even if no helper ever gets a processor.
void Team::share(std::size_t count, std::size_t grain, Call call, void* with) {
  if (helpers_.empty()) start();
  call_ = call;
  with_ = with;
  grain_ = grain;
  const std::size_t parts = (count + grain - 1) / grain, each = (parts + shares_.size() - 1) / shares_.size() * grain;
  for (std::size_t i = 0; i < shares_.size(); ++i) {
    shares_[i].next = std::min(count, i * each);
    shares_[i].end = std::min(count, (i + 1) * each);
  }
  open_ = true;
  ++round_;
  round_.notify_all();
  take_part(0);
  open_ = false;
  for (int looks = 0; inside_ != 0; ++looks) {
    if (looks < kPatience) pause();
    else std::this_thread::yield();
  }
}

// First the own share, which is the same piece of work's part as last time and thus in this processor's cache; then what is
// left of others'.
void Team::take_part(std::size_t own) {
  for (std::size_t i = 0; i < shares_.size(); ++i) {
    Share& share = shares_[(own + i) % shares_.size()];
    for (;;) {
      const std::size_t from = share.next.fetch_add(grain_);
      if (from >= share.end) break;
      call_(with_, from, std::min(share.end, from + grain_));
    }
  }
}

void Team::help(std::size_t own) {
  unsigned known = 0;
  while (!ended_) {
    for (int looks = 0; looks < kLooks && round_ == known; ++looks) pause();
    round_.wait(known);
    known = round_;
    ++inside_;
    if (open_) take_part(own);
    --inside_;
  }
}

}  // namespace tumble
