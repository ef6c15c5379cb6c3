// A few threads that share one piece of work after another, each of some tens of microseconds: shorter than a general
// pool's queue would pay for. docs/decisions/0018 says why it is not one of a library.
#pragma once

#include <atomic>
#include <cstddef>
#include <thread>
#include <type_traits>
#include <vector>

namespace tumble {

class Team {
 public:
  // At most so many threads, the caller's included; more than the machine has are not taken. None starts before there is
  // work for it.
  explicit Team(int threads);
  int asked_for() const { return asked_for_; }
  ~Team();
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;

  // Calls f(from, to) until all of 0 .. count is done once, `grain` or less at a time, by whoever is free. What parts do
  // must not depend on each other or on their order: then the result is the same for any number of threads. Returns when
  // all is done; f must not throw. Work of one grain stays with the caller.
  template <class F>
  void each(std::size_t count, std::size_t grain, F&& f) {
    if (size_ < 2 || count <= grain) {
      if (count > 0) f(std::size_t{0}, count);
      return;
    }
    using Function = std::remove_reference_t<F>;
    share(count, grain, [](void* with, std::size_t from, std::size_t to) { (*static_cast<Function*>(with))(from, to); }, const_cast<void*>(static_cast<const void*>(&f)));
  }

 private:
  using Call = void (*)(void* with, std::size_t from, std::size_t to);
  void share(std::size_t count, std::size_t grain, Call call, void* with);
  void start();
  void take_part(std::size_t own);
  void help(std::size_t own);

  // What nobody has taken yet of one thread's share.
  struct alignas(64) Share {
    std::atomic<std::size_t> next{0};
    std::size_t end = 0;
  };

  const int asked_for_, size_;
  std::vector<std::thread> helpers_;

  // The work: written while nobody is inside and `open_` is false.
  Call call_ = nullptr;
  void* with_ = nullptr;
  std::size_t grain_ = 1;
  std::vector<Share> shares_;  // one a thread

  alignas(64) std::atomic<bool> open_{false};         // may helpers come in?
  alignas(64) std::atomic<int> inside_{0};            // helpers that may look at the work
  alignas(64) std::atomic<unsigned> round_{0};        // goes up with each piece of work, and at the end
  std::atomic<bool> ended_{false};
};

}  // namespace tumble
