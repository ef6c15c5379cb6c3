// Handles and the pools they point into: one owner, everyone else holds {index, generation}.
#pragma once

#include <cassert>
#include <cstdint>
#include <optional>
#include <vector>

namespace tumble {

// Names a T in its Pool. It may outlive the T: a pool then answers nullptr. The default handle names nothing.
template <class T>
struct Handle {
  std::uint32_t index = 0;
  std::uint32_t generation = 0;

  explicit operator bool() const { return generation != 0; }
  bool operator==(const Handle&) const = default;
  auto operator<=>(const Handle&) const = default;
};

// Owns its Ts. Pointers to elements are good until the next add; indices are reused, last freed first, so that the
// same calls give the same handles in every run.
template <class T>
class Pool {
 public:
  Handle<T> add(T value) {
    const Handle<T> handle = reserve();
    place(handle, std::move(value));
    return handle;
  }

  // A handle whose element comes later, by place(), or never, by remove(). Until then get() gives nullptr.
  Handle<T> reserve() {
    std::uint32_t index;
    if (free_.empty()) {
      index = static_cast<std::uint32_t>(slots_.size());
      slots_.emplace_back();
    } else {
      index = free_.back();
      free_.pop_back();
    }
    Slot& slot = slots_[index];
    slot.taken = true;
    return {index, ++slot.generation};
  }

  // Puts an element where a handle that another pool of the same kind gave out expects it.
  void place(Handle<T> handle, T value) {
    while (handle.index >= slots_.size()) {
      free_.push_back(static_cast<std::uint32_t>(slots_.size()));
      slots_.emplace_back();
    }
    Slot& slot = slots_[handle.index];
    assert(!slot.value);
    if (!slot.taken) std::erase(free_, handle.index);
    slot.generation = handle.generation;
    slot.taken = true;
    slot.value.emplace(std::move(value));
    ++count_;
  }

  void remove(Handle<T> handle) {
    if (handle.index >= slots_.size()) return;
    Slot& slot = slots_[handle.index];
    if (slot.generation != handle.generation || !slot.taken) return;
    if (slot.value) --count_;
    slot.value.reset();
    slot.taken = false;
    free_.push_back(handle.index);
  }

  // Drops the element but keeps its handle reserved, so that place() can bring it back under the same handle.
  void vacate(Handle<T> handle) {
    if (!get(handle)) return;
    slots_[handle.index].value.reset();
    --count_;
  }

  T* get(Handle<T> handle) {
    if (handle.index >= slots_.size()) return nullptr;
    Slot& slot = slots_[handle.index];
    return slot.generation == handle.generation && slot.value ? &*slot.value : nullptr;
  }
  const T* get(Handle<T> handle) const { return const_cast<Pool*>(this)->get(handle); }
  T& operator[](Handle<T> handle) {
    T* value = get(handle);
    assert(value);
    return *value;
  }
  const T& operator[](Handle<T> handle) const { return const_cast<Pool&>(*this)[handle]; }

  std::size_t size() const { return count_; }

  // In index order. The callback may not add or remove.
  template <class F>
  void each(F&& f) {
    for (std::uint32_t i = 0; i < slots_.size(); ++i)
      if (slots_[i].value) f(Handle<T>{i, slots_[i].generation}, *slots_[i].value);
  }
  template <class F>
  void each(F&& f) const {
    for (std::uint32_t i = 0; i < slots_.size(); ++i)
      if (slots_[i].value) f(Handle<T>{i, slots_[i].generation}, *slots_[i].value);
  }

 private:
  struct Slot {
    std::optional<T> value;
    std::uint32_t generation = 0;
    bool taken = false;
  };
  std::vector<Slot> slots_;
  std::vector<std::uint32_t> free_;
  std::size_t count_ = 0;
};

}  // namespace tumble
