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

Team::Team(int threads) : asked_for_(threads), size_(there_are(threads)) {}

Team::~Team() {
  ended_ = true;
  ++round_;
  round_.notify_all();
  for (std::thread& helper : helpers_) helper.join();
}

void Team::start() {
  for (int i = 1; i < size_; ++i) helpers_.emplace_back([this] { help(); });
}

// A helper that comes late finds the work closed and leaves; one that is inside is waited for. So the caller goes on
// when all is done even if no helper ever gets a processor.
void Team::share(std::size_t count, std::size_t grain, Call call, void* with) {
  if (helpers_.empty()) start();
  call_ = call;
  with_ = with;
  count_ = count;
  grain_ = grain;
  next_ = 0;
  open_ = true;
  ++round_;
  round_.notify_all();
  take_part();
  open_ = false;
  for (int looks = 0; inside_ != 0; ++looks) {
    if (looks < kPatience) pause();
    else std::this_thread::yield();
  }
}

void Team::take_part() {
  for (;;) {
    const std::size_t from = next_.fetch_add(grain_);
    if (from >= count_) return;
    call_(with_, from, std::min(count_, from + grain_));
  }
}

void Team::help() {
  unsigned known = 0;
  while (!ended_) {
    for (int looks = 0; looks < kLooks && round_ == known; ++looks) pause();
    round_.wait(known);
    known = round_;
    ++inside_;
    if (open_) take_part();
    --inside_;
  }
}

}  // namespace tumble
