// The part of `core` that compares, copies and words values.
#include "base/text.h"
#include "script/core.h"
#include "script/pairs.h"
#include "script/script.h"
#include "script/bind.h"

namespace tumble {

namespace {

int nearest_word(lua_State* L) {
  std::vector<std::string> words;
  for (lua_Integer i = 1; lua_rawgeti(L, 2, i) == LUA_TSTRING; ++i, lua_pop(L, 1)) words.emplace_back(lua_tostring(L, -1));
  const std::string word = nearest(std::string(luaL_optstring(L, 1, "")), words);
  return (word.empty() ? lua_pushnil(L) : (void)lua_pushlstring(L, word.data(), word.size())), 1;
}
std::string table_text(lua_State* L) {
  try {
    std::string text = tumble::text(value_from_lua(L, 1, ""));
    return text.size() > 60 ? text.substr(0, 57) + "..." : text;
  } catch (const Error&) {
    return "a table";
  }
}
int short_text(lua_State* L) {
  std::string text;
  if (lua_type(L, 1) == LUA_TSTRING) text = describe_argument(L, 1);
  else if (lua_type(L, 1) == LUA_TNUMBER) text = lua_isinteger(L, 1) ? std::to_string(lua_tointeger(L, 1)) : number_text(lua_tonumber(L, 1));
  else if (lua_type(L, 1) == LUA_TTABLE) text = table_text(L);
  else text = describe_argument(L, 1);
  return lua_pushlstring(L, text.data(), text.size()), 1;
}
int kind(lua_State* L) {
  if (lua_type(L, 1) == LUA_TUSERDATA) lua_pushstring(L, tag_name(tag_at(L, 1)));
  else lua_pushstring(L, luaL_typename(L, 1));
  return 1;
}
int same(lua_State* L) {
  const bool numbers = lua_type(L, 1) == LUA_TNUMBER && lua_type(L, 2) == LUA_TNUMBER;
  if (numbers) return lua_pushboolean(L, lua_isinteger(L, 1) == lua_isinteger(L, 2) && lua_compare(L, 1, 2, LUA_OPEQ)), 1;
  if (lua_type(L, 1) == LUA_TTABLE && lua_type(L, 2) == LUA_TTABLE && !lua_rawequal(L, 1, 2)) {
    try {
      return lua_pushboolean(L, value_from_lua(L, 1, "") == value_from_lua(L, 2, "")), 1;
    } catch (const Error&) {
      return lua_pushboolean(L, false), 1;
    }
  }
  return lua_pushboolean(L, lua_compare(L, 1, 2, LUA_OPEQ)), 1;
}
// A copy of a default, so that instances do not share a table.
int copy(lua_State* L) {
  if (lua_type(L, 1) != LUA_TTABLE) return lua_settop(L, 1), 1;
  return at_border(L, [L] { return push_value(L, value_from_lua(L, 1, "behaviour")), 1; });
}
int as_vec3(lua_State* L) {
  if (vec3_at(L, 1)) return lua_settop(L, 1), 1;
  if (!lua_istable(L, 1) || lua_rawlen(L, 1) != 3) return lua_pushnil(L), 1;
  double n[3];
  for (int i = 0; i < 3; ++i) {
    if (lua_rawgeti(L, 1, i + 1) != LUA_TNUMBER) return lua_pushnil(L), 1;
    n[i] = lua_tonumber(L, -1);
  }
  return push_vec3(L, {n[0], n[1], n[2]}), 1;
}
int as_color(lua_State* L) {
  if (object_at<Color>(L, 1, Tag::color)) return lua_settop(L, 1), 1;
  if (lua_type(L, 1) != LUA_TSTRING) return lua_pushnil(L), 1;
  const auto color = parse_color(lua_tostring(L, 1));
  if (!color) return lua_pushnil(L), 1;
  return push_object(L, Tag::color, *color), 1;
}
int keys(lua_State* L) { return push_sorted_keys(L, 1), 1; }
int property(lua_State* L) {
  push_object(L, Tag::property, 0, 1);
  lua_pushvalue(L, 1);
  lua_setiuservalue(L, -2, 1);
  return 1;
}
int property_of(lua_State* L) {
  if (tag_at(L, 1) != Tag::property) return lua_pushnil(L), 1;
  lua_getiuservalue(L, 1, 1);
  return 1;
}

}  // namespace

void push_value_functions(lua_State* L) {
  static const luaL_Reg functions[] = {{"nearest", nearest_word}, {"short", short_text}, {"kind", kind},         {"same", same},
                                       {"copy", copy},            {"as_vec3", as_vec3},  {"as_color", as_color}, {"keys", keys},
                                       {"property", property},    {"property_of", property_of}};
  for (const luaL_Reg& one : functions) {
    lua_pushcfunction(L, one.func);
    lua_setfield(L, -2, one.name);
  }
}

}  // namespace tumble
