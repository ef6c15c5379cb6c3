// Lua's allocator: counts, limits, and gives every block a serial number.
#pragma once

#include <cstddef>
#include <cstdint>

namespace tumble {

// The serial orders objects by age: `pairs` walks keys that are tables or functions oldest first, which is the same in
// every run, while their addresses are not.
class LuaMemory {
 public:
  explicit LuaMemory(std::size_t limit) : limit_(limit) {}
  // For lua_newstate; `self` is the LuaMemory.
  static void* allocate(void* self, void* block, std::size_t old_size, std::size_t new_size);
  static std::uint64_t serial(const void* block);
  std::size_t used() const { return used_; }
  std::size_t limit() const { return limit_; }

 private:
  std::size_t used_ = 0;
  std::size_t limit_;
  std::uint64_t next_serial_ = 1;
};

}  // namespace tumble
