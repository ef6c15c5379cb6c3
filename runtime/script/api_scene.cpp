// The scene module.
#include "base/text.h"
#include "script/areas.h"
#include "script/script.h"

namespace tumble {

namespace {

NodeRef add(Script& s, Value table) {
  if (!table.is<Map>() && !(table.is<List>() && table.get<List>()->empty())) fail("scene.add: a table expected, got ", kind_name(table), "; write scene.add { name = \"ball\" }");
  if (s.phase() == Phase::declare) return {s.declare_node(table, "scene.add")};
  return {s.add_node(table, {}, Origin::added, "scene.add")};
}
NodeRef get(Script& s, std::string path) { return {s.engine().scene.get_by_path(path, {}, "scene.get")}; }
std::optional<NodeRef> find(Script& s, std::string path) {
  const NodeId node = s.engine().scene.find(path);
  return node ? std::optional(NodeRef{node}) : std::nullopt;
}
std::vector<NodeRef> tagged(Script& s, std::string tag) {
  std::vector<NodeRef> list;
  for (const NodeId node : s.engine().scene.tagged(tag)) list.push_back({node});
  return list;
}
NodeRef root(Script& s) { return {s.engine().scene.root()}; }
std::string name(Script& s) { return s.engine().scene_name; }
NodeRef camera(Script& s) { return {s.engine().camera()}; }
void load(Script& s, std::string path) { s.request_scene(path); }
void save(Script& s, std::string path) { s.save_scene(path); }
void restart(Script& s) { s.request_scene_restart(); }

int send(lua_State* L) {
  return at_border(L, [L] { return script_of(L).send_message(0, 1); });
}

}  // namespace

void rows_scene(Area& a) {
  a.fn<add>("add", "Adds a node. The table's keys are the node's properties, and `parent`, `children`, `prefab`.", "node").writes().takes(0, "node table");
  a.fn<get>("get", "The node of that name or path (\"level/door\"); an error where there is none or several.", "path");
  a.fn<find>("find", "The node of that name or path, or nil.", "path");
  a.fn<tagged>("tagged", "All nodes with that tag, in tree order.", "tag");
  a.fn<load>("load", "Replaces the loaded scene at the end of the tick. What main.lua declared stays.", "path").acts();
  a.fn<save>("save", "Writes the loaded scene, as it is now, to path.json; only in a game's folder, while it is made.", "path").acts();
  a.fn<restart>("restart", "Gives declared and loaded nodes their first state back at the end of the tick; added ones go.").acts();
  a.raw("send", "Calls on_<message> in main.lua and everywhere, at once; true if anyone listened.", send,
        {{"message", "string", false}, {"...", "any", true}}, "boolean").acts();
  a.prop<root>("root", "The node that all others hang from.");
  a.prop<name>("name", "The loaded scene's path, or \"\".");
  a.prop<camera>("camera", "The node of the active camera; there is always one.");
}

}  // namespace tumble
