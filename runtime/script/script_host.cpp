// Properties of nodes by path, for hosts.
#include <algorithm>

#include "script/bind.h"
#include "script/script.h"

namespace tumble {

std::optional<Value> Script::get_path(const std::string& node_path, const std::string& path) {
  std::optional<Value> result;
  guarded([&] {
    const NodeId node = live_.scene.get_by_path(node_path, {}, "node");
    push_node(node);
    push_path(path, 0);
    result = value_from_lua(L_, -1, path);
    lua_pop(L_, 1);
  });
  return result;
}

// Walks the path from the object on top, up to `keep` steps before its end, and leaves what it reaches.
std::string Script::push_path(const std::string& path, int keep) {
  std::vector<std::string> steps;
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t dot = std::min(path.find('.', begin), path.size());
    steps.push_back(path.substr(begin, dot - begin));
    begin = dot + 1;
  }
  for (std::size_t i = 0; i + static_cast<std::size_t>(keep) < steps.size(); ++i) {
    if (lua_isnil(L_, -1)) fail(path, ": nothing there before '", steps[i], "'");
    lua_getfield(L_, -1, steps[i].c_str());
    lua_remove(L_, -2);
  }
  return steps.back();
}

void Script::set_path(const std::string& node_path, const std::string& path, const Value& value) {
  guarded([&] {
    push_node(live_.scene.get_by_path(node_path, {}, "node"));
    const std::string last = push_path(path, 1);
    push_value(L_, value);
    lua_setfield(L_, -2, last.c_str());
    lua_pop(L_, 1);
  });
}

}  // namespace tumble
