// Nodes, joints and components as userdata, and how messages name them.
#include "base/text.h"
#include "script/bind.h"
#include "script/script.h"

namespace tumble {

std::uint32_t next_object_serial(lua_State* L) { return script_of(L).next_serial(); }

// The registry slot where userdata of a pool are kept, so that a node is always the same key of a table.
static void push_cached(lua_State* L, const void* slot, std::uint32_t index, std::uint32_t generation, Tag tag, int user_values) {
  lua_rawgetp(L, LUA_REGISTRYINDEX, slot);
  if (lua_rawgeti(L, -1, static_cast<lua_Integer>(index) + 1) == LUA_TUSERDATA) {
    const auto* known = static_cast<const Object<NodeId>*>(lua_touserdata(L, -1));
    if (known->value.generation == generation) return lua_remove(L, -2);
  }
  lua_pop(L, 1);
  push_object(L, tag, NodeId{index, generation}, user_values);
  lua_pushvalue(L, -1);
  lua_rawseti(L, -3, static_cast<lua_Integer>(index) + 1);
  lua_remove(L, -2);
}

void Script::push_node(NodeId node) {
  if (!node) return lua_pushnil(running_);
  constexpr int kComponents = static_cast<int>(Tag::animation) - static_cast<int>(Tag::body) + 1;
  push_cached(running_, &live_, node.index, node.generation, Tag::node, kComponents + 1);   // and the list of children
}

void Script::push_joint(JointRef joint) {
  if (!joint) return lua_pushnil(running_);
  push_cached(running_, &declared_, joint.index, joint.generation, Tag::joint, 0);
}

void Script::push_component(NodeId node, Tag tag) {
  lua_State* L = running_;
  const int slot = (tag == Tag::children ? 2 + static_cast<int>(Tag::animation) : 1 + static_cast<int>(tag)) - static_cast<int>(Tag::body);
  push_node(node);
  if (lua_getiuservalue(L, -1, slot) != LUA_TUSERDATA) {
    lua_pop(L, 1);
    push_object(L, tag, ComponentData{node});
    lua_pushvalue(L, -1);
    lua_setiuservalue(L, -3, slot);
  }
  lua_remove(L, -2);
}

std::string Script::object_text(int index) {
  lua_State* L = running_;
  const Tag tag = tag_at(L, index);
  if (const Vec3* v = vec3_at(L, index)) return text(Value(*v));
  if (const Quat* q = object_at<Quat>(L, index, Tag::quat)) return text(Value(*q));
  if (const Color* c = object_at<Color>(L, index, Tag::color)) return "color \"" + to_hex(*c) + "\"";
  if (const NodeId* node = object_at<NodeId>(L, index, Tag::node)) {
    const SceneNode* n = engine().scene.get(*node);
    return n ? "node '" + n->name + "'" : "a destroyed node";
  }
  if (const JointRef* joint = object_at<JointRef>(L, index, Tag::joint)) {
    const JointRecord* record = engine().joint(*joint);
    if (!record) return "a destroyed joint";
    return record->name.empty() ? "a " + record->type + " joint" : record->type + " '" + record->name + "'";
  }
  if (tag >= Tag::body && tag <= Tag::animation) {
    const NodeId node = object_at<ComponentData>(L, index, tag)->node;
    const SceneNode* n = engine().scene.get(node);
    return std::string(tag_name(tag)) + (n ? " of node '" + n->name + "'" : " of a destroyed node");
  }
  return tag_name(tag);
}

std::string Script::dead_node_text(NodeId node) const {
  const auto found = dead_.find(node);
  return found != dead_.end() ? found->second : "this node was destroyed";
}

CameraView Script::view_of(NodeId node) const {
  const SceneNode* n = live_.scene.get(node);
  if (!n || !n->camera) return camera_view(live_);
  const Transform& world = live_.scene.world(node);
  return {{world.position, world.rotation}, n->camera->field_of_view, n->camera->near, n->camera->far};
}

}  // namespace tumble
