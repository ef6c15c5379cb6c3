#include "engine/scene_file.h"

#include "assets/game_path.h"
#include "engine/json.h"
#include "engine/prefab.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace tumble {

namespace {

constexpr std::int64_t kVersion = 1;
constexpr std::size_t kMaxPrefabChain = 16;
// Ten copies of a prefab of ten copies ...: a few small files could fill any memory.
constexpr std::size_t kMaxNodes = 100000;

const Value* children_of(const Value& node) {
  const Value* children = node.find("children");
  return children && !children->is_nil() ? children : nullptr;
}

std::size_t count_nodes(const Value& node) {
  std::size_t count = 1;
  const Value* children = children_of(node);
  if (!children) return count;
  if (const List* list = children->get<List>())
    for (const Value& child : *list) count += count_nodes(child);
  else count += count_nodes(*children);
  return count;
}

// Reads files and lays copies over prefabs; each prefab is read once.
class Loader {
 public:
  explicit Loader(const FileReader& read) : read_(read) {}

  // The table in a file without its version, prefabs merged in. `asked`: who asks, for the error.
  const Value& load(const std::string& path, const std::string& asked) {
    check_path(path, asked);
    check_chain(path, asked);
    if (const auto found = files_.find(path); found != files_.end()) return found->second;

    const std::string file = path + ".json";
    const std::optional<std::string> text = read_(file);
    if (!text) fail(asked, ": no file '", file, "'");
    Value root = parse_json(*text, file);
    take_version(root, file);
    NodeDef checked;  // file by file, so that an error names the file and the place where the author wrote it
    assign(checked, root, file);

    chain_.push_back(path);
    root = expand(std::move(root), file);
    chain_.pop_back();
    return files_[path] = std::move(root);
  }

  Value expand(Value node, const std::string& place) {
    if (!node.is<Map>()) return node;
    if (const Value* children = children_of(node)) node["children"] = expand_children(*children, place);
    const Value* prefab = node.find("prefab");
    const std::string* path = prefab ? prefab->get<std::string>() : nullptr;
    if (!path || path->empty()) return node;

    const Value& base = load(*path, place + ": prefab");
    copied_ += count_nodes(base);
    if (copied_ > kMaxNodes) fail(place, ": prefabs give more than ", kMaxNodes, " nodes; make fewer copies");
    return merged(type_of<NodeDef>(), prefab_copy(base, node, *path + ".json"), node);
  }

 private:
  Value expand_children(const Value& children, const std::string& place) {
    const List* list = children.get<List>();
    if (!list) return expand(children, place + ": children");
    List result;
    for (const Value& child : *list)
      result.push_back(expand(child, place + ": children[" + std::to_string(result.size() + 1) + "]"));
    return result;
  }

  static void check_path(const std::string& path, const std::string& asked) {
    try {
      require_game_path(path);
    } catch (const Error& error) {
      fail(asked, ": ", error.what());
    }
    if (path.ends_with(".json")) fail(asked, ": scenes and prefabs are written without '.json' (got '", path, "')");
  }

  void check_chain(const std::string& path, const std::string& asked) const {
    const auto begin = std::find(chain_.begin(), chain_.end(), path);
    if (begin != chain_.end()) {
      std::string circle;
      for (auto link = begin; link != chain_.end(); ++link) circle += *link + " -> ";
      fail(asked, ": prefabs hold one another in a circle (", circle, path, "); take one of them out");
    }
    if (chain_.size() > kMaxPrefabChain) fail(asked, ": prefabs hold one another more than ", kMaxPrefabChain, " deep");
  }

  static void take_version(Value& root, const std::string& file) {
    if (!root.is<Map>()) fail(file, ": a scene file is one node table (got ", kind_name(root), ")");
    const Value* version = root.find("tumble");
    if (!version) fail(file, ": the version is missing; a scene file begins with \"tumble\": 1");
    const std::int64_t* number = version->get<std::int64_t>();
    if (!number || *number < 1) fail(file, ": tumble: version number expected, got ", text(*version), "; write \"tumble\": 1");
    if (*number > kVersion)
      fail(file, ": written for version ", *number, " of scene files; this runtime reads up to ", kVersion, ", use a newer one");
    std::erase_if(*root.get<Map>(), [](const auto& entry) { return entry.first == "tumble"; });
  }

  const FileReader& read_;
  std::map<std::string, Value> files_;
  std::vector<std::string> chain_;  // files being read, the outermost first
  std::size_t copied_ = 0;          // nodes from prefabs
};

// Described numbers are real; 5 is nicer to read than 5.0. Scripts' own properties keep their kind.
void prefer_whole(Value& value) {
  if (const double* number = value.get<double>()) {
    if (std::abs(*number) < 1e15 && *number == std::floor(*number)) value = static_cast<std::int64_t>(*number);
  } else if (List* list = value.get<List>()) {
    for (Value& entry : *list) prefer_whole(entry);
  } else if (Map* map = value.get<Map>()) {
    for (auto& [key, entry] : *map)
      if (key != "behaviours") prefer_whole(entry);
  }
}

// A null takes a prefab's behaviour away; one that took nothing away says nothing.
void drop_nil_behaviours(NodeDef& node) {
  std::erase_if(node.behaviours, [](const auto& entry) { return entry.second.is_nil(); });
  for (NodeDef& child : node.children) drop_nil_behaviours(child);
}

void forget_prefabs(NodeDef& node) {
  node.prefab.clear();
  for (NodeDef& child : node.children) forget_prefabs(child);
}

}  // namespace

NodeDef load_scene_file(const std::string& path, const FileReader& read, const std::string& call) {
  Loader loader(read);
  NodeDef def;
  assign(def, loader.load(path, call), path + ".json");
  drop_nil_behaviours(def);
  return def;
}

Value with_prefabs(const Value& node, const FileReader& read, const std::string& call) { return Loader(read).expand(node, call); }

std::string write_scene_file(const NodeDef& root) {
  NodeDef plain = root;
  forget_prefabs(plain);
  Value value = to_value(plain, true);
  prefer_whole(value);
  value.get<Map>()->insert(value.get<Map>()->begin(), {"tumble", kVersion});
  return write_json(value);
}

}  // namespace tumble
