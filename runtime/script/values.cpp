// Value to Lua and back.
#include <algorithm>

#include "script/script.h"
#include "script/types.h"
#include "script/view.h"

namespace tumble {

namespace {

constexpr int kDeepest = 32;

struct Reader {
  lua_State* L;
  const std::string& where;
  std::vector<const void*> open;  // tables being read, to find cycles

  Value read(int index) {
    index = lua_absindex(L, index);
    switch (lua_type(L, index)) {
      case LUA_TNIL: return {};
      case LUA_TBOOLEAN: return Value(static_cast<bool>(lua_toboolean(L, index)));
      case LUA_TNUMBER:
        return lua_isinteger(L, index) ? Value(std::int64_t{lua_tointeger(L, index)}) : Value(lua_tonumber(L, index));
      case LUA_TSTRING: {
        std::size_t size = 0;
        const char* text = lua_tolstring(L, index, &size);
        return Value(std::string(text, size));
      }
      case LUA_TTABLE: return read_table(index);
      case LUA_TUSERDATA: return read_object(index);
      default: fail(where, ": a ", luaL_typename(L, index), " cannot be stored; only numbers, strings, booleans, vec3, quat, color, nodes and tables of them can");
    }
  }

  Value read_object(int index) {
    if (const Vec3* v = vec3_at(L, index)) return *v;
    if (const Quat* q = object_at<Quat>(L, index, Tag::quat)) return *q;
    if (const Color* c = object_at<Color>(L, index, Tag::color)) return *c;
    if (const NodeId* n = object_at<NodeId>(L, index, Tag::node)) return Reference{Reference::Kind::node, n->index, n->generation};
    if (const JointRef* j = object_at<JointRef>(L, index, Tag::joint)) return Reference{Reference::Kind::joint, j->index, j->generation};
    if (std::optional<Value> copy = described_value(L, index)) return *std::move(copy);
    fail(where, ": ", script_of(L).object_text(index), " cannot be stored here");
  }

  Value read_table(int index) {
    const void* self = lua_topointer(L, index);
    if (std::find(open.begin(), open.end(), self) != open.end()) fail(where, ": a table contains itself");
    if (open.size() >= kDeepest) fail(where, ": tables inside tables, ", kDeepest, " deep; that is the limit");
    luaL_checkstack(L, 4, "nested tables");
    open.push_back(self);
    Value result = lua_rawlen(L, index) > 0 ? read_list(index) : read_map(index);
    open.pop_back();
    return result;
  }

  Value read_list(int index) {
    List list;
    const auto size = static_cast<lua_Integer>(lua_rawlen(L, index));
    for (lua_Integer i = 1; i <= size; ++i) {
      lua_rawgeti(L, index, i);
      list.push_back(read(-1));
      lua_pop(L, 1);
    }
    lua_Integer entries = 0;
    for (lua_pushnil(L); lua_next(L, index); lua_pop(L, 1)) ++entries;
    if (entries != size) fail(where, ": a table has both list entries and named ones; use one or the other");
    return list;
  }

  Value read_map(int index) {
    std::vector<std::string> keys;
    for (lua_pushnil(L); lua_next(L, index); lua_pop(L, 1)) {
      if (lua_type(L, -2) != LUA_TSTRING) fail(where, ": a table has ", describe_argument(L, -2), " as a key; names (strings) or a list 1, 2, 3 expected");
      keys.emplace_back(lua_tostring(L, -2));
    }
    std::sort(keys.begin(), keys.end());
    Map map;
    for (const std::string& key : keys) {
      lua_pushlstring(L, key.data(), key.size());
      lua_rawget(L, index);
      map.emplace_back(key, read(-1));
      lua_pop(L, 1);
    }
    return map;
  }
};

struct Pusher {
  lua_State* L;
  void operator()(std::monostate) const { lua_pushnil(L); }
  void operator()(bool b) const { lua_pushboolean(L, b); }
  void operator()(std::int64_t i) const { lua_pushinteger(L, i); }
  void operator()(double d) const { lua_pushnumber(L, d); }
  void operator()(const std::string& s) const { lua_pushlstring(L, s.data(), s.size()); }
  void operator()(Vec3 v) const { push_vec3(L, v); }
  void operator()(Quat q) const { push_object(L, Tag::quat, q); }
  void operator()(const Color& c) const { push_object(L, Tag::color, c); }
  void operator()(const Reference& r) const {
    if (r.kind == Reference::Kind::node) script_of(L).push_node({r.index, r.generation});
    else script_of(L).push_joint({r.index, r.generation});
  }
  void operator()(const List& list) const {
    luaL_checkstack(L, 3, "nested tables");
    lua_createtable(L, static_cast<int>(list.size()), 0);
    for (std::size_t i = 0; i < list.size(); ++i) {
      push_value(L, list[i]);
      lua_rawseti(L, -2, static_cast<lua_Integer>(i) + 1);
    }
  }
  void operator()(const Map& map) const {
    luaL_checkstack(L, 3, "nested tables");
    lua_createtable(L, 0, static_cast<int>(map.size()));
    for (const auto& [key, value] : map) {
      lua_pushlstring(L, key.data(), key.size());
      push_value(L, value);
      lua_rawset(L, -3);
    }
  }
};

}  // namespace

Value value_from_lua(lua_State* L, int index, const std::string& where) { return Reader{L, where, {}}.read(index); }

void push_value(lua_State* L, const Value& value) { std::visit(Pusher{L}, value.data); }

}  // namespace tumble
