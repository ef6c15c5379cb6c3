// What our userdata hold: values (vec3, quat, color) and handles (nodes, their components, joints, hits).
//
// Every userdata in a state is ours and begins with a tag, so a check is: full userdata, then compare four bytes.
#pragma once

#include <cstdint>

#include "base/color.h"
#include "base/math.h"
#include "engine/engine.h"
#include "script/lua.h"

namespace tumble {

enum class Tag : std::uint32_t {
  vec3 = 0x7b1e0000, quat, color, node, joint, body, mesh, material, light, camera, sky, sound, particles, animation, view, children, hit, filter, property, voice, sound_groups, end
};
constexpr int kTags = static_cast<int>(Tag::end) - static_cast<int>(Tag::vec3);
constexpr int tag_index(Tag tag) { return static_cast<int>(tag) - static_cast<int>(Tag::vec3); }
// "vec3", "node": for messages.
const char* tag_name(Tag tag);

template <class T>
struct Object {
  Tag tag;
  std::uint32_t serial;   // age among objects, for the order of pairs; it lies in what would be padding
  T value;
};
std::uint32_t next_object_serial(lua_State* L);
// A node's component, or the list of its children.
struct ComponentData { NodeId node; };
// A sound that a script plays: its number, and what was written last, which can be read when it is over too.
struct VoiceData {
  std::uint64_t id = 0;
  double volume = 1, pitch = 1;
};
// A table inside a component or joint ("motor" of a hinge): where it hangs; the path is user value 1.
struct ViewData { Reference root; };

// Scripts never get light userdata, so what is a userdata at all is an object of ours.
inline Tag tag_at(lua_State* L, int index) {
  const void* object = lua_touserdata(L, index);
  return object ? *static_cast<const Tag*>(object) : Tag::end;
}
// The value inside a userdata of that tag, or nullptr.
template <class T>
T* object_at(lua_State* L, int index, Tag tag) {
  void* object = lua_touserdata(L, index);
  return object && *static_cast<const Tag*>(object) == tag ? &static_cast<Object<T>*>(object)->value : nullptr;
}
// Pushes a new userdata with the tag's metatable.
template <class T>
T& push_object(lua_State* L, Tag tag, const T& value, int user_values = 0);

// Metatables lie in the registry under their tags.
inline void push_metatable(lua_State* L, Tag tag) { lua_rawgetp(L, LUA_REGISTRYINDEX, reinterpret_cast<void*>(static_cast<std::uintptr_t>(tag))); }

template <class T>
T& push_object(lua_State* L, Tag tag, const T& value, int user_values) {
  auto* object = static_cast<Object<T>*>(lua_newuserdatauv(L, sizeof(Object<T>), user_values));
  new (object) Object<T>{tag, next_object_serial(L), value};
  push_metatable(L, tag);
  lua_setmetatable(L, -2);
  return object->value;
}

inline void push_vec3(lua_State* L, Vec3 v) { push_object(L, Tag::vec3, v); }
inline Vec3* vec3_at(lua_State* L, int index) { return object_at<Vec3>(L, index, Tag::vec3); }

}  // namespace tumble
