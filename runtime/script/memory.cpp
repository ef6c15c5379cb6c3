#include "script/memory.h"

#include <cstdlib>
#include <cstring>

namespace tumble {

namespace {
// In front of each block. Eight bytes keep the alignment that Lua asks for (its largest member is 8 bytes wide).
struct Header {
  std::uint64_t serial;
};
Header* header(void* block) { return static_cast<Header*>(block) - 1; }
}  // namespace

std::uint64_t LuaMemory::serial(const void* block) { return header(const_cast<void*>(block))->serial; }

void* LuaMemory::allocate(void* self, void* block, std::size_t old_size, std::size_t new_size) {
  auto& memory = *static_cast<LuaMemory*>(self);
  if (!block) old_size = 0;  // it is then a type tag
  if (new_size == 0) {
    if (block) std::free(header(block));
    memory.used_ -= old_size;
    return nullptr;
  }
  // Shrinking must never fail, so the limit is looked at only on the way up.
  if (new_size > old_size && memory.used_ + (new_size - old_size) > memory.limit_) return nullptr;
  auto* moved = static_cast<Header*>(std::realloc(block ? header(block) : nullptr, new_size + sizeof(Header)));
  if (!moved) return nullptr;
  if (!block) moved->serial = memory.next_serial_++;
  memory.used_ += new_size - old_size;
  return moved + 1;
}

}  // namespace tumble
