#include "script/dispatch.h"

#include <algorithm>

#include "base/text.h"
#include "script/script.h"
#include "script/view.h"

namespace tumble {

// The rows of an area by the address of their name: Lua keeps one copy of each short string, so two words are equal if
// their addresses are. It lies in a userdata that the kind's metatable keeps; the row tables beside it keep the words alive.
struct Names {
  struct Entry {
    const void* word = nullptr;
    const Row* row = nullptr;
  };
  std::size_t mask = 0;
  Entry entries[1];             // mask + 1 of them

  static std::size_t bytes(std::size_t entries) { return sizeof(Names) + (entries - 1) * sizeof(Entry); }
  std::size_t begin(const void* word) const { return (reinterpret_cast<std::uintptr_t>(word) >> 4) * 0x9e3779b97f4a7c15ULL >> 32 & mask; }
  const Row* find(const void* word) const {
    for (std::size_t i = begin(word); entries[i].word; i = (i + 1) & mask)
      if (entries[i].word == word) return entries[i].row;
    return nullptr;
  }
  void add(const void* word, const Row* row) {
    std::size_t i = begin(word);
    while (entries[i].word) i = (i + 1) & mask;
    entries[i] = {word, row};
  }
};

namespace {

void push_names(lua_State* L, const Area& area) {
  std::size_t size = 8;
  while (size < 2 * area.rows.size()) size *= 2;
  auto* names = new (lua_newuserdatauv(L, Names::bytes(size), 0)) Names;
  names->mask = size - 1;
  for (std::size_t i = 0; i < size; ++i) new (&names->entries[i]) Names::Entry;
  for (const Row& row : area.rows) {
    if (row.kind == Row::Kind::event || row.scripted) continue;
    lua_pushlstring(L, row.name.data(), row.name.size());
    names->add(lua_topointer(L, -1), &row);
    lua_pop(L, 1);
  }
}
// The row for the key at 2 of an object at 1.
const Row* row_of(lua_State* L, int tag_index) { return script_of(L).names(tag_index)->find(lua_topointer(L, 2)); }

// The row table: name -> function (method or function) or light userdata (the Row of a property).
void push_rows(lua_State* L, const Area& area, bool with_functions) {
  lua_createtable(L, 0, static_cast<int>(area.rows.size()));
  for (const Row& row : area.rows) {
    if (row.kind == Row::Kind::event || row.scripted) continue;
    if (row.call) {
      if (!with_functions) continue;
      lua_pushcfunction(L, row.call);
    } else {
      lua_pushlightuserdata(L, const_cast<Row*>(&row));
    }
    lua_setfield(L, -2, row.name.c_str());
  }
}

const Area& upvalue_area(lua_State* L) { return *static_cast<const Area*>(lua_touserdata(L, lua_upvalueindex(2))); }

// Leaves the row or function for the key at `key` on the stack.
int look_up(lua_State* L, int key) {
  lua_pushvalue(L, key);
  return lua_rawget(L, lua_upvalueindex(1));
}

std::string key_text(lua_State* L, int index) {
  return lua_type(L, index) == LUA_TSTRING ? lua_tostring(L, index) : describe_argument(L, index);
}

// A function for each kind of object, so that the way to its rows is short.
template <int tag_index>
int object_index(lua_State* L) {
  if (const Row* row = row_of(L, tag_index)) {
    if (row->call) return lua_pushcfunction(L, row->call), 1;
    return row->get(L);                              // it reads the object alone, so that the key may stay
  }
  return at_border(L, [L] { return index_described(L, upvalue_area(L)); });
}

int object_newindex(lua_State* L) {
  const Row* row = row_of(L, tag_index(tag_at(L, 1)));
  if (row && row->set) {
    lua_remove(L, 2);
    return row->set(L);
  }
  return at_border(L, [L, row] {
    const Area& area = upvalue_area(L);
    const Tag tag = tag_at(L, 1);
    if (tag == Tag::vec3 || tag == Tag::quat || tag == Tag::color) return newindex_described(L, area);
    if (row && !row->call) fail(area.name, ".", row->name, ": can be read but not written");
    if (row) fail(area.name, ".", key_text(L, 2), " is a function of every ", area.name, " and cannot be replaced");
    return newindex_described(L, area);
  });
}

// vec3, quat and color by name, without the detour over the rows for one-letter fields.
int vec3_index(lua_State* L) {
  const Vec3& v = *vec3_at(L, 1);
  std::size_t size = 0;
  const char* key = lua_tolstring(L, 2, &size);
  if (size == 1 && lua_type(L, 2) == LUA_TSTRING) {
    if (*key == 'x') return lua_pushnumber(L, v.x), 1;
    if (*key == 'y') return lua_pushnumber(L, v.y), 1;
    if (*key == 'z') return lua_pushnumber(L, v.z), 1;
  }
  return object_index<tag_index(Tag::vec3)>(L);
}

template <std::size_t... I>
lua_CFunction index_function(int tag_index, std::index_sequence<I...>) {
  static constexpr lua_CFunction functions[] = {object_index<static_cast<int>(I)>...};
  return functions[tag_index];
}

int module_index(lua_State* L) {
  if (look_up(L, 2) == LUA_TLIGHTUSERDATA) {
    const Row* row = static_cast<const Row*>(lua_touserdata(L, -1));
    lua_settop(L, 0);
    return row->get(L);
  }
  return at_border(L, [L]() -> int { fail_unknown(L, upvalue_area(L), upvalue_area(L).name, key_text(L, 2)); });
}

int module_newindex(lua_State* L) {
  const int type = look_up(L, 2);
  const Row* row = type == LUA_TLIGHTUSERDATA ? static_cast<const Row*>(lua_touserdata(L, -1)) : nullptr;
  if (row && row->set) {
    lua_settop(L, 3);
    lua_remove(L, 1);
    lua_remove(L, 1);
    return row->set(L);
  }
  return at_border(L, [L, row]() -> int {
    const Area& area = upvalue_area(L);
    const std::string key = key_text(L, 2);
    if (row) fail(area.name, ".", key, ": can be read but not written");
    if (area.find(key)) fail(area.name, ".", key, " is a function of the engine and cannot be replaced; give yours another name");
    fail_unknown(L, area, area.name, key);
  });
}

int object_tostring(lua_State* L) {
  const std::string text = script_of(L).object_text(1);
  lua_pushlstring(L, text.data(), text.size());
  return 1;
}

void set_closure(lua_State* L, const char* field, lua_CFunction function, const Area& area, bool functions) {
  push_rows(L, area, functions);
  lua_pushlightuserdata(L, const_cast<Area*>(&area));
  lua_pushcclosure(L, function, 2);
  lua_setfield(L, -2, field);
}

void lock(lua_State* L, const std::string& name) {
  lua_pushlstring(L, name.data(), name.size());
  lua_setfield(L, -2, "__metatable");
}

// Into the table on top.
void set_functions(lua_State* L, const Area& area) {
  for (const Row& row : area.rows)
    if (row.call) {
      lua_pushcfunction(L, row.call);
      lua_setfield(L, -2, row.name.c_str());
    }
}

// Puts a table of the area's methods before the function at __index of the metatable on top: the VM then finds a method
// alone, and only properties and misses reach C.
void put_methods_first(lua_State* L, const Area& area) {
  lua_newtable(L);                                   // methods
  set_functions(L, area);
  lua_newtable(L);                                   // metatable of methods: properties
  lua_getfield(L, -3, "__index");
  lua_setfield(L, -2, "__index");
  lua_setmetatable(L, -2);
  lua_setfield(L, -2, "__index");
}

bool has_methods(const Area& area) {
  return std::any_of(area.rows.begin(), area.rows.end(), [](const Row& row) { return row.call != nullptr; });
}

int first_argument(lua_State* L) { return lua_pushvalue(L, 1), 1; }

// Does a function behind a table at an object's __index get the object? In the Lua that build.sh makes, yes; the
// system's Lua gives it the table.
bool gets_object_behind_table(lua_State* L) {
  lua_newuserdatauv(L, 0, 0);
  const void* object = lua_touserdata(L, -1);
  lua_newtable(L);                                   // its metatable
  lua_pushcfunction(L, first_argument);
  lua_setfield(L, -2, "__index");
  put_methods_first(L, Area{});
  lua_setmetatable(L, -2);
  lua_getfield(L, -1, "self");
  const bool gets = lua_touserdata(L, -1) == object;
  lua_pop(L, 2);
  return gets;
}

void open_object(lua_State* L, Tag tag, bool methods_first) {
  const Area& rows = area(tag_name(tag));
  lua_newtable(L);
  push_names(L, rows);
  script_of(L).names(tag_index(tag)) = static_cast<const Names*>(lua_touserdata(L, -1));
  lua_setfield(L, -2, "names");
  set_closure(L, "__index", tag == Tag::vec3 ? vec3_index : index_function(tag_index(tag), std::make_index_sequence<kTags>{}), rows, true);
  // Of a vec3 x, y and z are what is mostly asked for: they stay first.
  if (methods_first && has_methods(rows) && tag != Tag::vec3) put_methods_first(L, rows);
  set_closure(L, "__newindex", object_newindex, rows, true);
  lua_pushcfunction(L, object_tostring);
  lua_setfield(L, -2, "__tostring");
  lua_pushstring(L, tag_name(tag));
  lua_setfield(L, -2, "__name");
  lock(L, tag_name(tag));
  lua_rawsetp(L, LUA_REGISTRYINDEX, reinterpret_cast<void*>(static_cast<std::uintptr_t>(tag)));
}

// Functions are found by the VM alone: the proxy's __index is a table; only properties and misses reach C.
void open_module(lua_State* L, const Area& module, int globals) {
  lua_newtable(L);                                   // proxy
  lua_newtable(L);                                   // its metatable
  lua_newtable(L);                                   // functions
  set_functions(L, module);
  lua_pushvalue(L, -1);                              // kept for provide_scripted()
  lua_rawsetp(L, LUA_REGISTRYINDEX, &module);
  lua_newtable(L);                                   // metatable of functions: properties
  set_closure(L, "__index", module_index, module, false);
  lua_setmetatable(L, -2);
  lua_setfield(L, -2, "__index");
  set_closure(L, "__newindex", module_newindex, module, false);
  lock(L, module.name);
  lua_setmetatable(L, -2);
  if (module.name.find('.') == std::string::npos) lua_setfield(L, globals, module.name.c_str());
  else lua_rawsetp(L, LUA_REGISTRYINDEX, &module.rows);   // for push_inner_module
}

int read_only_newindex(lua_State* L) {
  return at_border(L, [L]() -> int {
    const char* name = lua_tostring(L, lua_upvalueindex(1));
    fail("'", name, "' belongs to Lua and cannot be changed; write a function of your own instead of ", name, ".", key_text(L, 2));
  });
}

int read_only_index(lua_State* L) {
  return at_border(L, [L]() -> int {
    std::vector<std::string> names;
    lua_pushvalue(L, 1);
    for (lua_pushnil(L); lua_next(L, -2); lua_pop(L, 1))
      if (lua_type(L, -2) == LUA_TSTRING) names.emplace_back(lua_tostring(L, -2));
    const std::string key = key_text(L, 2);
    fail(lua_tostring(L, lua_upvalueindex(1)), " has no '", key, "'", did_you_mean(key, names));
  });
}

}  // namespace

void fail_unknown(lua_State*, const Area& area, const std::string& owner, const std::string& name) {
  // Known to a component of the node, and so only at the wrong place?
  if (area.name == "node")
    for (const char* part : {"body", "mesh", "material", "light", "camera", "sky", "sound", "particles", "animation"}) {
      const Area& component = tumble::area(part);
      const Row* row = component.find(name);
      const bool field = component.described && component.described->field(name);
      if (row || field)
        fail(owner, " has no '", name, "'; it belongs to the ", part, ": node.", part, row && row->method && row->call ? ":" : ".", name);
    }
  fail(owner, " has no '", name, "'", did_you_mean(name, area.names()));
}

void make_read_only(lua_State* L, const char* name) {
  lua_newtable(L);      // proxy
  lua_newtable(L);      // metatable
  lua_rotate(L, -3, -1);  // proxy, metatable, content
  lua_newtable(L);      // metatable of the content: unknown names
  lua_pushstring(L, name);
  lua_pushcclosure(L, read_only_index, 1);
  lua_setfield(L, -2, "__index");
  lua_setmetatable(L, -2);
  lua_setfield(L, -2, "__index");
  lua_pushstring(L, name);
  lua_pushcclosure(L, read_only_newindex, 1);
  lua_setfield(L, -2, "__newindex");
  lock(L, name);
  lua_setmetatable(L, -2);
}

void provide_scripted(lua_State* L, int exports) {
  exports = lua_absindex(L, exports);
  for (const Area* module : all_areas())
    for (const Row& row : module->rows) {
      if (!row.scripted || module->object) continue;
      lua_rawgetp(L, LUA_REGISTRYINDEX, module);
      lua_getfield(L, exports, module->name.c_str());
      if (!lua_istable(L, -1) || lua_getfield(L, -1, row.name.c_str()) != LUA_TFUNCTION)
        fail("boot does not provide ", row.full_name());
      lua_setfield(L, -3, row.name.c_str());
      lua_pop(L, 2);
    }
}

void push_inner_module(lua_State* L, const char* name) { lua_rawgetp(L, LUA_REGISTRYINDEX, &area(name).rows); }

void open_areas(lua_State* L, int globals) {
  globals = lua_absindex(L, globals);
  const bool methods_first = gets_object_behind_table(L);
  for (int i = 0; i < kTags; ++i) open_object(L, static_cast<Tag>(static_cast<std::uint32_t>(Tag::vec3) + static_cast<std::uint32_t>(i)), methods_first);
  for (const Area* module : all_areas())
    if (!module->object) open_module(L, *module, globals);
  open_value_operators(L);
  open_children(L);
  open_views(L);
  open_sound_groups(L);
  open_hit_collection(L);
}

}  // namespace tumble
